// A coarser mesh for the partition: connected clusters of a few faces each, as faces of it.
#pragma once

#include <vector>

#include "core/patches/partition.h"

namespace shapespline {

struct FaceClusters {
  std::vector<int> ofFace;  ///< cluster of each face; -1 where the face is in no component
  std::vector<int> member;  ///< faces, cluster by cluster; the cluster's first one is its lowest
  // What the partition looks at, by cluster: sums of areas, means of centroids and rotations over areas.
  FaceGraph graph;
  Components components;
  std::vector<double> area;
  Positions centroid;
  FaceRotations rotations{0, 0};

  int count() const { return static_cast<int>(area.size()); }
};

/// Clusters of at most `largest` faces, in the order of their lowest faces; only the poses that count are averaged.
FaceClusters clusterFaces(const PatchInput& input, int largest, const FractionReport& onProgress = {});

}  // namespace shapespline
