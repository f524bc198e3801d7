// SPDX-License-Identifier: Apache-2.0
//
// The kernel's transcendental functions against the standard library's in double precision, over the whole
// range that math.h promises: floats taken at even steps of their bits, so that ends, tiny and huge values
// are all there.
#include "kernel/math.h"

#include <gtest/gtest.h>

#include <string>

#include "support/numeric.h"
#include "support/random.h"

namespace snell::kernel {
namespace {

using test::UlpError;

struct Worst {
  double ulp = 0;
  float at = 0;

  void Note(double error, float x) {
    if (error > ulp) {
      ulp = error;
      at = x;
    }
  }
};

// Call visit(x) for about `count` floats in [lower, upper], both ends included, of both signs if lower is
// negative.
template <class Visit>
void SweepFloats(float lower, float upper, std::uint64_t count, const Visit& visit) {
  // Order floats by an integer that rises with them
  const auto rank = [](float f) {
    const std::int64_t bits = std::bit_cast<std::int32_t>(f);
    return bits >= 0 ? bits : -std::int64_t(bits & 0x7fffffff);
  };
  const auto unrank = [](std::int64_t r) {
    return r >= 0 ? std::bit_cast<float>(std::int32_t(r)) : -std::bit_cast<float>(std::int32_t(-r));
  };
  const std::int64_t first = rank(lower);
  const std::int64_t last = rank(upper);
  const std::int64_t step = std::max<std::int64_t>(1, (last - first) / std::int64_t(count));
  const auto normal = [](float f) { return f == 0.0f || std::isnormal(f); };
  for (std::int64_t r = first; r < last; r += step) {
    if (normal(unrank(r))) visit(unrank(r));
  }
  visit(upper);
}

struct Case {
  const char* name;
  float (*function)(float);
  double (*exact)(double);
  float lower;
  float upper;
  double ulps;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Function : public testing::TestWithParam<Case> {};

TEST_P(Function, IsWithinItsBoundOverItsRange) {
  const Case& c = GetParam();
  Worst worst;
  const auto check = [&](float x) {
    const double exact = c.exact(double(x));
    // Results below the normal floats may be flushed to zero
    if (std::abs(exact) < 0x1p-126) {
      EXPECT_LE(std::abs(double(c.function(x)) - exact), 0x1p-126) << x;
    } else {
      worst.Note(UlpError(c.function(x), exact), x);
    }
  };
  SweepFloats(c.lower, c.upper, test::Scaled(400000), check);
  test::Random random(1);
  for (std::uint64_t i = 0; i < test::Scaled(200000); ++i)
    check(float(random.Uniform(double(c.lower), double(c.upper))));
  RecordProperty("max_ulp", std::to_string(worst.ulp));
  EXPECT_LE(worst.ulp, c.ulps) << "at " << worst.at;
}

double TwoToThe(double x) { return std::exp2(x); }
double TangentAngle(double x) { return std::atan2(x, 1.0); }
double InverseSlope(double x) { return std::atan2(1.0, x); }
double AngleLeft(double x) { return std::atan2(x, -1.0); }
FN float Atan2Right(float x) { return Atan2(x, 1.0f); }
FN float Atan2Up(float x) { return Atan2(1.0f, x); }
FN float Atan2Left(float x) { return Atan2(x, -1.0f); }

INSTANTIATE_TEST_SUITE_P(
    Math, Function,
    testing::Values(
        Case{"Exp2", [](float x) { return Exp2(x); }, TwoToThe, -126.0f, 127.49f, 3},
        Case{"Exp", [](float x) { return Exp(x); }, std::exp, -87.33f, 88.36f, 3},
        Case{"Log2", [](float x) { return Log2(x); }, std::log2, 0x1p-126f, 3.4028234e38f, 3},
        Case{"Log", [](float x) { return Log(x); }, std::log, 0x1p-126f, 3.4028234e38f, 3},
        Case{"Acos", [](float x) { return Acos(x); }, std::acos, -1.0f, 1.0f, 3},
        Case{"Asin", [](float x) { return Asin(x); }, std::asin, -1.0f, 1.0f, 3},
        Case{"AtanRight", Atan2Right, TangentAngle, -3e38f, 3e38f, 3},
        Case{"AtanUp", Atan2Up, InverseSlope, -3e38f, 3e38f, 3},
        Case{"AtanLeft", Atan2Left, AngleLeft, 0.0f, 3e38f, 3}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(SinCos, HasItsBoundsUpTo8000) {
  Worst ulps;
  Worst absolute;
  const auto check = [&](float x) {
    float s;
    float c;
    SinCos(x, s, c);
    const double sine = std::sin(double(x)), cosine = std::cos(double(x));
    absolute.Note(std::max(std::abs(double(s) - sine), std::abs(double(c) - cosine)), x);
    if (std::abs(x) <= Pi) ulps.Note(std::max(UlpError(s, sine), UlpError(c, cosine)), x);
    EXPECT_EQ(s, Sin(x));
    EXPECT_EQ(c, Cos(x));
  };
  SweepFloats(-8000.0f, 8000.0f, test::Scaled(400000), check);
  test::Random random(2);
  for (std::uint64_t i = 0; i < test::Scaled(400000); ++i)
    check(float(random.Uniform(-8000, 8000)));

  // The floats around every zero, where all digits of the result come from the reduction
  for (int k = -5092; k <= 5092; ++k) {
    const float zero = float(k * 1.5707963267948966);
    for (const float x : {std::nextafterf(zero, -1e9f), zero, std::nextafterf(zero, 1e9f)}) {
      check(x);
    }
  }
  RecordProperty("max_ulp_up_to_pi", std::to_string(ulps.ulp));
  RecordProperty("max_absolute_error", std::to_string(absolute.ulp * 1e9) + "e-9");
  EXPECT_LE(ulps.ulp, 3.0) << "at " << ulps.at;
  EXPECT_LE(absolute.ulp, 8e-8) << "at " << absolute.at;
}

TEST(Atan2, KnowsAllQuadrantsAndAxes) {
  test::Random random(3);
  for (int i = 0; i < 200000; ++i) {
    const float x = float(random.LogUniform(1e-15, 1e15)) * (random.Chance(0.5) ? 1.0f : -1.0f);
    const float y = float(random.LogUniform(1e-15, 1e15)) * (random.Chance(0.5) ? 1.0f : -1.0f);
    ASSERT_LE(UlpError(Atan2(y, x), std::atan2(double(y), double(x))), 3.0) << y << " " << x;
  }
  EXPECT_EQ(Atan2(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(Atan2(0.0f, 2.0f), 0.0f);
  EXPECT_EQ(Atan2(0.0f, -2.0f), Pi);
  EXPECT_EQ(Atan2(2.0f, 0.0f), PiOver2);
  EXPECT_EQ(Atan2(-2.0f, 0.0f), -PiOver2);
}

TEST(Exp, IsClampedBeyondTheNormalFloats) {
  EXPECT_GE(Exp(-1000.0f), 0.0f);
  EXPECT_LE(Exp(-1000.0f), 2.4e-38f);
  EXPECT_TRUE(std::isfinite(Exp(1000.0f)));
  EXPECT_GT(Exp(1000.0f), 1e38f);
  EXPECT_EQ(Exp(0.0f), 1.0f);
  EXPECT_EQ(Exp2(10.0f), 1024.0f);
  const vec3 v = Exp(vec3(0.0f, 1.0f, -2.0f));
  EXPECT_EQ(v, vec3(Exp(0.0f), Exp(1.0f), Exp(-2.0f)));
}

TEST(Pow, HasTheDocumentedRelativeError) {
  test::Random random(4);
  double worst = 0;
  for (std::uint64_t i = 0; i < test::Scaled(400000); ++i) {
    const float x = float(random.LogUniform(1e-30, 1e30));
    const float y = float(random.LogUniform(1e-3, 1e4));
    const double exponent = double(y) * std::log2(double(x));
    if (std::abs(exponent) > 125) continue;
    const double exact = std::pow(double(x), double(y));
    const double error = std::abs(double(Pow(x, y)) / exact - 1) / (1 + std::abs(exponent));
    worst = std::max(worst, error);
  }
  RecordProperty("max_error_per_1_plus_y_log2_x", std::to_string(worst * 1e9) + "e-9");
  EXPECT_LE(worst, 1.5e-7);
  EXPECT_EQ(Pow(0.0f, 2.0f), 0.0f);
  EXPECT_EQ(Pow(0.0f, 0.0f), 1.0f);
  EXPECT_EQ(Pow(-1.0f, 2.0f), 0.0f);
  EXPECT_EQ(Pow(1.0f, 1e6f), 1.0f);
}

TEST(SmoothStep, IsACubicBetweenItsEnds) {
  EXPECT_EQ(SmoothStep(1.0f, 3.0f, 0.0f), 0.0f);
  EXPECT_EQ(SmoothStep(1.0f, 3.0f, 4.0f), 1.0f);
  EXPECT_EQ(SmoothStep(1.0f, 3.0f, 2.0f), 0.5f);
  EXPECT_FLOAT_EQ(SmoothStep(1.0f, 3.0f, 1.5f), 0.15625f);
  EXPECT_FLOAT_EQ(SmoothStep(3.0f, 1.0f, 1.5f), 0.84375f);
}

TEST(Spectra, HaveAMaximumAndAMean) {
  EXPECT_EQ(MaxChannel(Spectrum(1, 3, 2)), 3.0f);
  EXPECT_FLOAT_EQ(MeanChannel(Spectrum(1, 3, 2)), 2.0f);
  EXPECT_TRUE(IsBlack(Spectrum(0, 0, 0)));
  EXPECT_FALSE(IsBlack(Spectrum(0, 1e-30f, 0)));
}

}  // namespace
}  // namespace snell::kernel
