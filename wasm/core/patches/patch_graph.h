// The graph of patches, with links between neighbours and between components, and its trees.
#pragma once

#include <vector>

#include "core/base/compressed_rows.h"
#include "core/patches/partition.h"

namespace shapespline {

/// Two patches with a known relative rotation: neighbours, or the patches at an attachment of components.
struct PatchLink {
  int from, to;
  int sharedEdges;  ///< 0 for a bridge, which leads from the parent component to the attached component
};

/// A tree that connects every patch to the root of its part of the graph.
struct PatchTree {
  std::vector<int> order;   ///< patches, parents first
  std::vector<int> parent;  ///< parent of each patch, -1 for a root
  std::vector<int> link;    ///< link of each patch to its parent, -1 for a root
  int root() const { return order.front(); }
};

class PatchGraph {
 public:
  PatchGraph() = default;
  /// area: one per patch. Links may have any direction. Bridges must be bridges of the graph.
  PatchGraph(std::vector<PatchLink> links, std::vector<double> area);

  int patchCount() const { return static_cast<int>(area_.size()); }
  const std::vector<PatchLink>& links() const { return links_; }
  const std::vector<double>& area() const { return area_; }
  double meanSharedEdges() const { return meanSharedEdges_; }

  /// Directs every link between neighbours away from the tree's root.
  void orient(const PatchTree& tree);

  /// Shortest paths from the central patch: among 64 candidates, the patch with the smallest area-weighted distance to
  /// all others. cost: one per link, positive. Costs are compared on a grid, so rounding decides no tie.
  PatchTree centreTree(const std::vector<double>& cost) const;

  /// Maximum spanning tree by weight (Prim), from the given root.
  PatchTree spanningTree(const std::vector<double>& weight, int root) const;

 private:
  struct End {
    int link, patch;
  };
  /// Limit for growing trees. Trees beyond the limit are returned without an order.
  struct Bound {
    double sum;       ///< sum of all patches' distances, weighted by area
    bool reachesAll;  ///< whether every patch is known to be reachable from any other
  };
  PatchTree grow(const std::vector<double>& cost, int root, bool alongPaths, std::vector<double>& distance,
                 const Bound& bound) const;

  std::vector<PatchLink> links_;
  std::vector<double> area_;
  double meanSharedEdges_ = 1;
  CompressedRows<End> ends_;  // by patch
};

}  // namespace shapespline
