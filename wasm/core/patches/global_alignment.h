// How the whole shape is turned: patch rotations are found up to a common rotation, which follows the patches' own
// paths.
#pragma once

#include <vector>

#include "core/rotation/rotation.h"

namespace shapespline {

/// Turns reconstructed patch rotations to where the patches' own cumulative paths have them.
///
/// Every path says how the whole would be turned, X_i = P_i G_i^T; where they agree, that is it. The mean of rotations
/// that differ much jumps (a projection, an eigenvector), so a fixed number of reweighted steps is taken from a patch
/// that speaks for most. Smooth wherever the paths and the rotations are.
class GlobalAlignment {
 public:
  GlobalAlignment() = default;

  /// halfway[step][patch]: X_i halfway through each step, from which the spokesman and the weights are taken. area: of
  /// each patch.
  GlobalAlignment(const std::vector<std::vector<Quaternion>>& halfway, const std::vector<double>& area);

  /// The rotation Q that takes `rotation` to where `path` has it: G_k <- Q G_k.
  Quaternion at(const std::vector<Quaternion>& path, const std::vector<Quaternion>& rotation) const;

 private:
  int medoid_ = 0;
  std::vector<double> weight_;  // of each patch, their sum 1
};

}  // namespace shapespline
