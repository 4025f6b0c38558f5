// The only file that compiles tinygltf's code.
#define JSON_NO_IO
#define TINYGLTF_IMPLEMENTATION
#include "io/gltf/tinygltf.h"
