// Poses -> OBJ and PLY.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// A file of materials beside an OBJ: what OBJ calls it and the scene's materials.
struct MaterialLibrary {
  std::string file;                ///< empty: none
  std::vector<std::string> names;  ///< of every material of the scene, without blanks
};

/// What the positions are relative to (io/far_offset.h).
struct MeshOffset {
  Vec3 value = Vec3::Zero();
  bool added = true;  ///< to the numbers that are written; else an OBJ names it in a comment, which its reader knows
};

/// Of the scene: texture coordinates, polygons as they came in, objects, materials that have a library or that the
/// input only named. Normals: 3n unit vectors, or empty. Error: NotFinite.
Result<std::vector<std::uint8_t>> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const Scene& scene, std::span<const float> normals = {},
                                           const MaterialLibrary& library = {}, const MeshOffset& offset = {});

/// Binary little endian; of double precision where there is an offset. Error: NotFinite.
Result<std::vector<std::uint8_t>> writePly(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const MeshOffset& offset = {});

}  // namespace shapespline
