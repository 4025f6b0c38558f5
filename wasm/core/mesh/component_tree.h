// Attaches each component of a mesh (eyes, clothes, hooves) to a neighbour.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/mesh.h"

namespace shapespline {

/// Attachment of one component to another.
struct ComponentLink {
  int parent = -1;       ///< parent component, -1 for the root
  int anchorFace = -1;   ///< face of the parent that carries this component
  int contactFace = -1;  ///< face of this component nearest to it
};

struct ComponentTree {
  std::vector<ComponentLink> link;  ///< one link per component
  std::vector<int> order;           ///< components, parents before children; the root is first
  int root() const { return order.front(); }
};

/// Minimum spanning tree of the components. The distance of two components is their largest over all poses. The root is
/// the component with the largest area, summed over all poses. Faces without area belong to no component and are
/// ignored.
ComponentTree linkComponents(const std::vector<Triangle>& faces, const Components& components,
                             std::span<const Positions* const> poses);

}  // namespace shapespline
