// The first system: patch rotations from connection maps (paper section 4.2), as a smooth function of the maps.
#pragma once

#include <span>
#include <vector>

#include "core/patches/patch_graph.h"
#include "core/rotation/rotation.h"
#include "core/sparse/cholesky.h"

namespace shapespline {

/// Rotations G_k with G_to near G_from C for every link, up to a common rotation.
///
/// If the maps C disagree around cycles of links, sum w |G_to - G_from C|_F^2 over SO(3) has several minima, and the
/// minimum found by an iteration changes suddenly with C. Instead, rotations along a fixed tree are followed by a fixed
/// number of steps of iteratively reweighted least squares. Each step consists of products of analytic functions and
/// one back-substitution with a constant matrix. The result is an analytic function of the maps everywhere, and exact
/// if the maps agree.
///
/// Steps are taken in the common frame (G <- exp(e) G). There the normal matrix is the constant weighted Laplacian of
/// the graph, and a bridge of the graph keeps its map exactly. Immutable.
class PatchRotationSystem {
 public:
  /// The right-hand side for each patch, then its rotation.
  using Scratch = std::vector<Eigen::Vector4d, Eigen::aligned_allocator<Eigen::Vector4d>>;

  /// weight: one per link of the graph, positive. Error: the solver's.
  static Result<PatchRotationSystem> create(const PatchGraph& graph, PatchTree tree, std::vector<double> weight);

  /// connection: C of each link. caution: one per step; the weight of a link whose maps disagree by an angle r is
  /// multiplied by ((1 + cos r) / 2)^caution. rotation: one per patch; resized. The tree's root stays near the
  /// identity.
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
  std::vector<double> area_;  // share of each patch in the total area
  Cholesky laplacian_;
  std::vector<int> position_;  // position of each patch in the solver's vectors
};

}  // namespace shapespline
