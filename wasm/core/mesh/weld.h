// Welding: seams split a vertex into copies; the method works on the mesh without them, the output keeps them.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// The maps between raw vertices (as in the input) and welded ones.
struct Welding {
  std::vector<int> weldedOfRaw;  ///< n entries in [0, count)
  std::vector<int> rawOfWelded;  ///< a raw vertex for each welded one, the first of its copies
  int count = 0;
};

/// Joins vertices that coincide in every pose within that pose's tolerance, a length.
Welding weld(std::span<const Positions* const> poses, std::span<const double> tolerance,
             const FractionReport& onProgress = {});

/// The tolerance of each pose: 1e-6 of its own bounding diagonal, wherever the others lie; anything much larger would
/// join real detail. Exporters write float32, whose rounding is 6e-8 of the size; where a pose that holds nothing but
/// such numbers lies far from the origin, it is what those are rounded by there.
std::vector<double> weldTolerances(std::span<const Positions* const> poses);

std::vector<Triangle> weldFaces(const std::vector<Triangle>& faces, const Welding& welding);
/// The mean of each welded vertex's copies.
Positions weldPositions(const Positions& raw, const Welding& welding);

/// Groups raw vertices for shading: copies of one welded vertex share a normal where the input's normals agree within a
/// degree, or where it has none. Returns the group of each raw vertex, in [0, groups).
std::vector<int> shadingGroups(const Welding& welding, const Positions& rawNormals, int& groups);

}  // namespace shapespline
