// tinygltf reduced to types and JSON: no file system, no image decoding, no network.
#pragma once

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE

#include "io/gltf/text_stream.h"

#include <tiny_gltf.h>
