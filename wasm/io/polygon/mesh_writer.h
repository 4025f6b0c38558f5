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

/// A material file for an OBJ: its name in the OBJ and the scene's materials.
struct MaterialLibrary {
  std::string file;                ///< empty: none
  std::vector<std::string> names;  ///< of every material of the scene, without spaces
};

/// The offset that the positions are relative to (io/far_offset.h).
struct MeshOffset {
  Vec3 value = Vec3::Zero();
  bool added = true;  ///< to the numbers that are written; else an OBJ names it in a comment, which its reader knows
};

/// Writes texture coordinates, the polygons of the input, objects, and materials that have a library or that the input
/// only named. Normals: 3n unit vectors, or empty. Error: NotFinite.
Result<std::vector<std::uint8_t>> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const Scene& scene, std::span<const float> normals = {},
                                           const MaterialLibrary& library = {}, const MeshOffset& offset = {});

/// Binary little endian, in double precision with an offset. Error: NotFinite.
Result<std::vector<std::uint8_t>> writePly(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const MeshOffset& offset = {});

}  // namespace shapespline
