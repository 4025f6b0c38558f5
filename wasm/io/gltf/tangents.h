// Tangents for normal maps.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// 4n floats as glTF's TANGENT: a unit vector along increasing u, perpendicular to the normal, and the handedness.
/// positions, normals: 3n; uvs: 2n. Each vertex takes the area-weighted mean of its faces (Lengyel 2001).
std::vector<float> tangentsOf(std::span<const float> positions, std::span<const float> normals,
                              std::span<const float> uvs, const std::vector<Triangle>& faces);

}  // namespace shapespline
