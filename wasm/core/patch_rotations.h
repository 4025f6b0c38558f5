// The first system: patch rotations from their connection maps (paper section 4.2).
#pragma once

#include <vector>

#include "core/cholesky.h"
#include "core/patches.h"
#include "core/rotation.h"

namespace shapespline {

/// Minimises sum w_ij |G_j - G_i exp(x_ij)|_F^2 over SO(3) for every patch, free up to one rotation a piece.
///
/// Starts on the spanning tree of largest weights and goes on by Gauss-Newton steps G <- exp(e) G. With the step in the
/// common frame the normal matrix is the weighted Laplacian of the patch graph: constant, so that it is factored once
/// and a step is one back-substitution. (With steps in each patch's own frame it holds the maps x_ij and is not.)
class PatchRotationSystem {
 public:
  PatchRotationSystem() = default;

  /// root: patch at which each piece starts, counted within the piece and taken modulo its size.
  Status build(const Patches& patches, const std::vector<double>& pairWeight, int root);

  /// pair: x_ij, one a pair. rotation: one a patch; resized. Returns the number of steps taken.
  int solve(const std::vector<Vec3>& pair, std::vector<Quaternion>& rotation);

  /// Patches, each after its parent in the spanning tree.
  const std::vector<int>& order() const { return order_; }
  /// Parent of each patch in the tree; -1 for the root of a piece.
  const std::vector<int>& parent() const { return parent_; }

 private:
  void spanTree(const Patches& patches, int root);
  void startOnTree(std::vector<Quaternion>& rotation) const;
  double step(std::vector<Quaternion>& rotation);  // its largest length, radians

  std::vector<PatchPair> pairs_;
  std::vector<double> weight_;
  std::vector<int> order_, parent_, parentPair_;
  Cholesky laplacian_;
  std::vector<int> position_;  // of each patch in the solver's vectors
  // Scratch: exp(x_ij) of each pair; a step of each patch and what pulls it there.
  using Vec4 = Eigen::Vector4d;
  std::vector<Quaternion> connection_;
  std::vector<Vec4, Eigen::aligned_allocator<Vec4>> step_;
};

}  // namespace shapespline
