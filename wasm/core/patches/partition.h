// A deterministic partition of the faces into connected patches that rotate as one, and the graph of neighbouring
// patches (paper section 4.2, after Wang et al. 2007).
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/mesh/mesh.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// R_f in some poses. The rotations of one face are contiguous.
struct FaceRotations {
  int poses;
  std::vector<Quaternion> values;  ///< poses * faces

  FaceRotations(int faces, int poses)
      : poses(poses), values(static_cast<std::size_t>(poses) * faces, Quaternion::Identity()) {}
  Quaternion* of(int face) { return values.data() + static_cast<std::size_t>(poses) * face; }
  const Quaternion* of(int face) const { return values.data() + static_cast<std::size_t>(poses) * face; }
};

/// Input of the partition. All arrays are indexed by face. Faces outside every component are ignored.
struct PatchInput {
  const FaceGraph& graph;
  const Components& components;
  const std::vector<double>& area;  ///< in one pose, the origin
  const Positions& centroid;        ///< in the origin
  const FaceRotations& rotations;   ///< relative to the origin; compared poses first
  int comparedPoses;                ///< the partition compares the first poses of `rotations`, this many
};

/// Two patches with a common edge or, at a pinched vertex, a common vertex.
struct PatchPair {
  int first, second;  ///< first < second
  int sharedEdges;
};

struct Patches {
  std::vector<int> ofFace;  ///< patch of each face, or -1 outside all components; torn faces have that of their anchor
  int count = 0;
  std::vector<int> componentOf;  ///< component of each patch
  std::vector<PatchPair> pairs;  ///< ascending
};

/// Default number of patches: the square root of the number of faces, rounded. The number of pairs is then a few times
/// sqrt(m), so the first system is tiny compared with the second.
int defaultPatchCount(int faceCount);

/// Farthest-point seeds, then rounds of region growing on the dual graph and re-seeding (Lloyd). Large meshes are
/// partitioned by clusters of faces (face_clusters.h), then refined by faces between the patches. Every component gets
/// at least one patch, so the count may exceed `wanted`. It never exceeds the number of faces.
Patches partitionFaces(const PatchInput& input, int wanted, const FractionReport& onProgress = {});

}  // namespace shapespline
