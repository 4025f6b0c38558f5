// Poses -> OBJ and PLY.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// A file of materials beside an OBJ: what OBJ calls it and the scene's materials.
struct MaterialLibrary {
  std::string file;                ///< empty: none
  std::vector<std::string> names;  ///< of every material of the scene, without blanks
};

/// Of the scene: texture coordinates, polygons as they came in, objects, materials that have a library or that the
/// input only named. Normals: 3n unit vectors, or empty.
std::vector<std::uint8_t> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                   const Scene& scene, std::span<const float> normals = {},
                                   const MaterialLibrary& library = {});
std::vector<std::uint8_t> writePly(std::span<const float> positions,
                                   const std::vector<Triangle>& faces);  ///< binary little endian

}  // namespace shapespline
