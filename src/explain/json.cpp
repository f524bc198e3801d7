// SPDX-License-Identifier: Apache-2.0
//
// An explanation as data, with all digits.
#include "util/json.h"

#include "explain/explanation.h"

namespace snell::explain {

namespace {

void Add(JsonWriter& json, const char* name, const kernel::vec3& v) {
  json.Add(name, {v.x, v.y, v.z});
}

void AddSurface(JsonWriter& json, const Surface& s) {
  json.BeginObject("surface");
  json.Add("object", s.object);
  json.Add("material", s.material);
  json.Add("place", s.place);
  json.Add("part", s.part);
  Add(json, "position", s.p);
  Add(json, "normal", s.n);
  Add(json, "shading_normal", s.ns);
  json.Add("uv", {s.uv.x, s.uv.y});
  json.Add("from_outside", s.fromOutside);
  if (s.refracts) {
    json.Add("near_ior", double(s.nearIor));
    json.Add("relative_ior", double(s.eta));
    json.Add("fresnel", double(s.fresnel));
    json.Add("total_reflection", s.totalReflection);
  }
  json.End();
}

void AddLight(JsonWriter& json, const LightTry& light) {
  json.BeginObject("");
  json.Add("light", light.light);
  json.Add("outcome", light.outcome);
  if (!light.blocker.empty()) json.Add("blocker", light.blocker);
  Add(json, "start", light.start);
  Add(json, "direction", light.wi);
  json.Add("distance", double(light.distance));
  json.Add("pick", double(light.pick));
  json.Add("pdf", double(light.pdf));
  json.Add("bsdf_pdf", double(light.bsdfPdf));
  json.Add("weight", double(light.weight));
  Add(json, "irradiance", light.irradiance);
  Add(json, "f", light.f);
  Add(json, "passed", light.passed);
  json.End();
}

void AddRay(JsonWriter& json, const Segment& ray) {
  json.BeginObject("");
  json.Add("kind", ray.kind);
  json.Add("parent", ray.parent);
  Add(json, "origin", ray.o);
  Add(json, "direction", ray.d);
  json.Add("length", double(ray.length));
  json.Add("media", ray.media);
  Add(json, "weight", ray.weight);
  json.Add("scattered", ray.scattered);
  if (ray.surface) AddSurface(json, *ray.surface);
  json.BeginArray("textures");
  for (const TextureRead& read : ray.reads) {
    json.BeginObject("");
    json.Add("texture", read.texture);
    json.Add("uv", {read.uv.x, read.uv.y});
    json.Add("value", {read.value.x, read.value.y, read.value.z, read.value.w});
    json.End();
  }
  json.End();
  json.BeginArray("lights");
  for (const LightTry& light : ray.lights) AddLight(json, light);
  json.End();
  if (ray.way) {
    json.BeginObject("way");
    json.Add("lobe", ray.way->lobe);
    json.Add("pdf", double(ray.way->pdf));
    Add(json, "weight", ray.way->weight);
    json.End();
  }
  json.Add("notes", ray.notes);
  json.End();
}

}  // namespace

std::string ToJson(const Explanation& explanation) {
  JsonWriter json;
  json.Add("scene", explanation.scene);
  json.Add("integrator", explanation.integrator);
  json.Add("width", explanation.width);
  json.Add("height", explanation.height);
  json.Add("x", explanation.x);
  json.Add("y", explanation.y);
  json.Add("sample", std::uint64_t(explanation.sample));
  Add(json, "radiance", explanation.radiance);
  json.BeginArray("terms");
  for (const Contribution& term : explanation.terms) {
    json.BeginObject("");
    Add(json, "radiance", term.L);
    json.Add("source", term.source);
    json.Add("held", term.held);
    json.Add("ray", term.ray);
    json.End();
  }
  json.End();
  json.BeginArray("rays");
  for (const Segment& ray : explanation.rays) AddRay(json, ray);
  json.End();
  return json.Finish();
}

}  // namespace snell::explain
