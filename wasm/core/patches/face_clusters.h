// A coarser mesh for the partition: connected clusters of a few faces each serve as its faces.
#pragma once

#include <vector>

#include "core/patches/partition.h"

namespace shapespline {

struct FaceClusters {
  std::vector<int> ofFace;  ///< cluster of each face, or -1 for a face outside all components
  std::vector<int> member;  ///< faces, cluster by cluster; each cluster starts with its lowest face
  // Data of the clusters for the partition: sums of areas, and area-weighted means of centroids and rotations.
  FaceGraph graph;
  Components components;
  std::vector<double> area;
  Positions centroid;
  FaceRotations rotations{0, 0};

  int count() const { return static_cast<int>(area.size()); }
};

/// Clusters of at most `largest` faces, ordered by their lowest faces. Averages only the compared poses.
FaceClusters clusterFaces(const PatchInput& input, int largest, const FractionReport& onProgress = {});

}  // namespace shapespline
