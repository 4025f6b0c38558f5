// Poses -> OBJ and PLY.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/types.h"
#include "io/base/scene.h"

namespace shapespline {

/// Of the scene: texture coordinates.
std::vector<std::uint8_t> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                   const Scene& scene);
std::vector<std::uint8_t> writePly(std::span<const float> positions,
                                   const std::vector<Triangle>& faces);  ///< binary little endian

}  // namespace shapespline
