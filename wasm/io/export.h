// Shapes -> bytes of files that other tools read. The only entrance for files that are written.
#pragma once

#include "io/gltf/gltf_writer.h"     // IWYU pragma: export
#include "io/polygon/mesh_writer.h"  // IWYU pragma: export
