// Writes shapes as files for other tools. The only public header for writing.
#pragma once

#include "io/gltf/gltf_writer.h"     // IWYU pragma: export
#include "io/polygon/mesh_writer.h"  // IWYU pragma: export
