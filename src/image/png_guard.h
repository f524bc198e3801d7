// SPDX-License-Identifier: Apache-2.0
//
// libpng reports errors by longjmp. This file is where those jumps land: a step of work either ends well
// or returns false with a message, and no C++ object with a destructor is ever jumped over.
#pragma once

#include <png.h>

#include <csetjmp>
#include <cstdio>

namespace snell::image {

// What libpng's error function leaves behind; given to png_create_*_struct as its error pointer.
struct PngMessage {
  char text[200] = "unknown reason";
};

[[noreturn]] inline void OnPngError(png_structp png, png_const_charp message) {
  auto* kept = static_cast<PngMessage*>(png_get_error_ptr(png));
  std::snprintf(kept->text, sizeof(kept->text), "%s", message);
  png_longjmp(png, 1);
}

// Warnings are about things that do not change the picture.
inline void OnPngWarning(png_structp, png_const_charp) {}

// Run `step`, which calls libpng; false if libpng failed. Neither the step nor a callback that it leads
// to may own an object with a destructor while it calls libpng.
template <typename Step>
bool PngSucceeds(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  step();
  return true;
}

}  // namespace snell::image
