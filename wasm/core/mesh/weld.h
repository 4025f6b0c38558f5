// Welding: joins vertex copies at seams. The method uses the welded mesh, the output keeps the copies.
#pragma once

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/types.h"

namespace shapespline {

/// Maps between raw (input) vertices and welded vertices.
struct Welding {
  std::vector<int> weldedOfRaw;  ///< n indices in [0, count)
  std::vector<int> rawOfWelded;  ///< the first raw copy of each welded vertex
  int count = 0;
};

/// Joins vertices that coincide in every pose within the pose's tolerance, a length.
Welding weld(std::span<const Positions* const> poses, std::span<const double> tolerance,
             const FractionReport& onProgress = {});

/// Tolerance of each pose: 1e-6 of its bounding diagonal. Larger values would join real detail. Exporters write
/// float32, with a rounding of 6e-8 of the size. In a pose far from the origin that stores only float32 values, the
/// tolerance is the rounding at that distance.
std::vector<double> weldTolerances(std::span<const Positions* const> poses);

std::vector<Triangle> weldFaces(const std::vector<Triangle>& faces, const Welding& welding);
/// Mean position of each welded vertex's copies.
Positions weldPositions(const Positions& raw, const Welding& welding);

/// Groups raw vertices for shading. Copies of one welded vertex share a normal if their input normals agree within a
/// degree or are missing. Returns the group of each raw vertex, in [0, groups).
std::vector<int> shadingGroups(const Welding& welding, const Positions& rawNormals, int& groups);

}  // namespace shapespline
