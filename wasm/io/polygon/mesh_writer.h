// Writes poses as OBJ and PLY.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// A material file for an OBJ: its name in the OBJ, and the scene's materials.
struct MaterialLibrary {
  std::string file;                ///< empty if there is no file
  std::vector<std::string> names;  ///< a name without spaces for each material of the scene
};

/// The offset of the positions (io/far_offset.h).
struct MeshOffset {
  Vec3 value = Vec3::Zero();
  bool added = true;  ///< add the offset to the written numbers; otherwise an OBJ states it in a comment, which our
                      ///< reader understands
};

/// Writes texture coordinates, the input's polygons, objects, and materials that have a library entry or only a name in
/// the input. normals: n unit vectors as 3n numbers, or empty. Error: NotFinite.
Result<std::vector<std::uint8_t>> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const Scene& scene, std::span<const float> normals = {},
                                           const MaterialLibrary& library = {}, const MeshOffset& offset = {});

/// Writes binary little endian; with an offset in double precision. Error: NotFinite.
Result<std::vector<std::uint8_t>> writePly(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const MeshOffset& offset = {});

}  // namespace shapespline
