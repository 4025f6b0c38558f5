// The one place where tinygltf's code is compiled.
#define JSON_NO_IO
#define TINYGLTF_IMPLEMENTATION
#include "io/gltf/tinygltf.h"
