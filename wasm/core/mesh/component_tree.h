// Meshes of several components (eyes, clothes, hooves): each is attached to its neighbour.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/mesh.h"

namespace shapespline {

/// How one component is attached to another.
struct ComponentLink {
  int parent = -1;       ///< -1 for the root
  int anchorFace = -1;   ///< face of the parent that carries this component
  int contactFace = -1;  ///< face of this component nearest to it
};

struct ComponentTree {
  std::vector<ComponentLink> link;  ///< one per component
  std::vector<int> order;           ///< components, parents before children; the root is first
  int root() const { return order.front(); }
};

/// Minimum spanning tree of the components, the distance of two being the largest over all poses, rooted at the
/// component of largest area, summed over all poses. Faces without area, which are in no component, take no part.
ComponentTree linkComponents(const std::vector<Triangle>& faces, const Components& components,
                             std::span<const Positions* const> poses);

}  // namespace shapespline
