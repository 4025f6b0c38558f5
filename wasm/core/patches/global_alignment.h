// Rotation of the whole shape. The patches' own paths determine it, because patch rotations are known only up to a
// common rotation.
#pragma once

#include <vector>

#include "core/rotation/rotation.h"

namespace shapespline {

/// Rotates reconstructed patch rotations to match the patches' own cumulative paths.
///
/// Each path suggests a rotation of the whole, X_i = P_i G_i^T. If they all agree, this is the result. A mean of very
/// different rotations jumps (a projection, an eigenvector). A fixed number of reweighted steps is therefore taken from
/// a patch that agrees with most others. The result is smooth wherever the paths and the rotations are.
class GlobalAlignment {
 public:
  GlobalAlignment() = default;

  /// halfway[step][patch]: X_i halfway through each step, which determines the starting patch and the weights. area:
  /// one per patch.
  GlobalAlignment(const std::vector<std::vector<Quaternion>>& halfway, const std::vector<double>& area);

  /// The rotation Q that moves `rotation` to `path`: G_k <- Q G_k.
  Quaternion at(const std::vector<Quaternion>& path, const std::vector<Quaternion>& rotation) const;

 private:
  int medoid_ = 0;
  std::vector<double> weight_;  // weight of each patch; the sum is 1
};

}  // namespace shapespline
