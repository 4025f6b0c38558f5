// Computes tangents for normal maps.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Returns 4n floats in the format of glTF's TANGENT: a unit vector along increasing u, perpendicular to the normal,
/// and the handedness. positions, normals: 3n; uvs: 2n. Each vertex gets the area-weighted mean over its faces (Lengyel
/// 2001).
std::vector<float> tangentsOf(std::span<const float> positions, std::span<const float> normals,
                              std::span<const float> uvs, const std::vector<Triangle>& faces);

}  // namespace shapespline
