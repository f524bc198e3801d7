// SPDX-License-Identifier: Apache-2.0
//
// tinygltf's records of a glTF document. Only its parser is used: files and pictures are ours, so that
// they stay within the scene's folder and their sizes are checked.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
