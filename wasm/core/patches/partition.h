// A deterministic partition of the faces into connected patches that turn as one, and the graph of neighbouring patches
// (paper section 4.2, after Wang et al. 2007).
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/mesh/mesh.h"
#include "core/rotation/rotation.h"

namespace shapespline {

/// R_f of some poses, a face's side by side.
struct FaceRotations {
  int poses;
  std::vector<Quaternion> values;  ///< poses * faces

  FaceRotations(int faces, int poses)
      : poses(poses), values(static_cast<std::size_t>(poses) * faces, Quaternion::Identity()) {}
  Quaternion* of(int face) { return values.data() + static_cast<std::size_t>(poses) * face; }
  const Quaternion* of(int face) const { return values.data() + static_cast<std::size_t>(poses) * face; }
};

/// Everything the partition looks at. All arrays are indexed by face; faces outside every component are left out.
struct PatchInput {
  const FaceGraph& graph;
  const Components& components;
  const std::vector<double>& area;  ///< in the reference pose
  const Positions& centroid;        ///< in the reference pose
  const FaceRotations& rotations;   ///< of the poses that count first; none of them need be the reference
  int comparedPoses;                ///< how many count
};

/// Two patches that share an edge (or, at a pinched place, a vertex).
struct PatchPair {
  int first, second;  ///< first < second
  int sharedEdges;
};

struct Patches {
  std::vector<int> ofFace;  ///< -1 where the face is in no component
  int count = 0;
  std::vector<int> componentOf;  ///< component of each patch
  std::vector<PatchPair> pairs;  ///< ascending
};

/// Number of patches used when none is asked for: the square root of the number of faces, rounded. The pairs then
/// number a few times sqrt(m), so the first system stays tiny beside the second.
int defaultPatchCount(int faceCount);

/// Farthest-point seeds, then rounds of region growing on the dual graph and re-seeding (Lloyd); of large meshes among
/// clusters of faces (face_clusters.h), then face by face between the patches. Every component gets at least one patch,
/// so the count may exceed `wanted`; it never exceeds the number of faces.
Patches partitionFaces(const PatchInput& input, int wanted, const FractionReport& onProgress = {});

}  // namespace shapespline
