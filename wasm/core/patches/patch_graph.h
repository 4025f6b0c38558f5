// The graph of patches: what joins neighbours, and what joins components. Trees in it.
#pragma once

#include <vector>

#include "core/base/compressed_rows.h"
#include "core/patches/partition.h"

namespace shapespline {

/// Two patches whose rotations are known against each other: neighbours, or the two where a component is attached to
/// another.
struct PatchLink {
  int from, to;
  int sharedEdges;  ///< 0 for a bridge, which leads from the component that carries to the one that is attached
};

/// A tree in which every patch is reached from the root of its part of the graph.
struct PatchTree {
  std::vector<int> order;   ///< patches, parents first
  std::vector<int> parent;  ///< of each patch; -1 for a root
  std::vector<int> link;    ///< of each patch, to its parent; -1 for a root
  int root() const { return order.front(); }
};

class PatchGraph {
 public:
  PatchGraph() = default;
  /// area: of each patch. Links may run either way; bridges must be bridges of the graph.
  PatchGraph(std::vector<PatchLink> links, std::vector<double> area);

  int patchCount() const { return static_cast<int>(area_.size()); }
  const std::vector<PatchLink>& links() const { return links_; }
  const std::vector<double>& area() const { return area_; }
  double meanSharedEdges() const { return meanSharedEdges_; }

  /// Turns every link between neighbours round that does not lead away from the tree's root.
  void orient(const PatchTree& tree);

  /// Shortest paths from the patch in the middle: the one with the least area-weighted distance to all others, of 64
  /// candidates. cost: of each link, positive; compared on a grid, so rounding decides no tie.
  PatchTree centreTree(const std::vector<double>& cost) const;

  /// The spanning tree of largest weights (Prim), from the given root.
  PatchTree spanningTree(const std::vector<double>& weight, int root) const;

 private:
  struct End {
    int link, patch;
  };
  /// Of trees that are worth growing: those beyond it come back without an order.
  struct Bound {
    double sum;       ///< of all patches' distances, weighted by their areas
    bool reachesAll;  ///< every patch is known to be reached from any other
  };
  PatchTree grow(const std::vector<double>& cost, int root, bool alongPaths, std::vector<double>& distance,
                 const Bound& bound) const;

  std::vector<PatchLink> links_;
  std::vector<double> area_;
  double meanSharedEdges_ = 1;
  CompressedRows<End> ends_;  // by patch
};

}  // namespace shapespline
