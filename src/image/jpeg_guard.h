// SPDX-License-Identifier: Apache-2.0
//
// libjpeg's errors, caught where its longjmp lands: a step of work either ends well or returns false with
// a message, and no C++ object with a destructor is ever jumped over. (jpeglib.h needs <cstdio> first.)
#pragma once

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include <jerror.h>

namespace snell::image {

// Stands in for libjpeg's error manager, which must come first so that its pointer leads back here.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf landing;
  char text[JMSG_LENGTH_MAX] = "unknown reason";
};

[[noreturn]] inline void OnJpegError(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->text);
  std::longjmp(errors->landing, 1);
}

// libjpeg paints over missing and broken data and goes on; we do not. Other warnings are about things
// that do not change the picture.
inline void OnJpegMessage(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  const int code = jpeg->err->msg_code;
  if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
      code == JWRN_ARITH_BAD_CODE || code == JWRN_MUST_RESYNC)
    OnJpegError(jpeg);
}

inline jpeg_error_mgr* Install(JpegErrors& errors) {
  jpeg_std_error(&errors.manager);
  errors.manager.error_exit = OnJpegError;
  errors.manager.emit_message = OnJpegMessage;
  errors.manager.output_message = [](j_common_ptr) {};
  return &errors.manager;
}

// Run `step`, which calls libjpeg; false if libjpeg failed. Neither the step nor a callback that it leads
// to may own an object with a destructor while it calls libjpeg.
template <typename Step>
bool JpegSucceeds(JpegErrors& errors, const Step& step) {
  if (setjmp(errors.landing) != 0) return false;
  step();
  return true;
}

}  // namespace snell::image
