// The first system: patch rotations from their connection maps (paper section 4.2), smooth in them.
#pragma once

#include <span>
#include <vector>

#include "core/patches/patch_graph.h"
#include "core/rotation/rotation.h"
#include "core/sparse/cholesky.h"

namespace shapespline {

/// Rotations G_k with G_to near G_from C for every link, up to one common rotation.
///
/// Where the maps C disagree around cycles of links, sum w |G_to - G_from C|_F^2 over SO(3) has several minima, and the
/// one that an iteration settles in changes with C suddenly. So there is no iteration: the rotations along a fixed
/// tree, then a fixed number of steps of iteratively reweighted least squares from there, each a product of analytic
/// functions and one back-substitution with a constant matrix. The result is an analytic function of the maps wherever
/// they are. Exact where they agree.
///
/// Steps are taken in the common frame (G <- exp(e) G): the normal matrix is the weighted Laplacian of the graph,
/// constant, and a bridge of the graph keeps its map exactly. Immutable.
class PatchRotationSystem {
 public:
  /// What pulls each patch, then how it turns.
  using Scratch = std::vector<Eigen::Vector4d, Eigen::aligned_allocator<Eigen::Vector4d>>;

  /// weight: of each link of the graph, positive. Error: that of the solver.
  static Result<PatchRotationSystem> create(const PatchGraph& graph, PatchTree tree, std::vector<double> weight);

  /// connection: C of each link. caution: one per step; a link whose maps disagree by an angle r pulls ((1 + cos r) /
  /// 2)^caution less. rotation: one per patch; resized. The tree's root stays near the identity.
  void solve(const std::vector<Quaternion>& connection, std::span<const int> caution, Scratch& scratch,
             std::vector<Quaternion>& rotation) const;

  const PatchTree& tree() const { return tree_; }

 private:
  PatchRotationSystem(const PatchGraph& graph, PatchTree tree, std::vector<double> weight, Cholesky laplacian);
  void startOnTree(const std::vector<Quaternion>& connection, std::vector<Quaternion>& rotation) const;
  void step(const std::vector<Quaternion>& connection, int caution, Scratch& scratch,
            std::vector<Quaternion>& rotation) const;

  std::vector<PatchLink> links_;
  PatchTree tree_;
  std::vector<double> weight_;
  std::vector<double> area_;  // of each patch, over the whole
  Cholesky laplacian_;
  std::vector<int> position_;  // of each patch in the solver's vectors
};

}  // namespace shapespline
