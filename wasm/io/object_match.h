// Which object of one pose is which of another: by name, then by shape and place, then by the order in the files.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "io/base/imported.h"

namespace shapespline {

/// A pose's faces with the objects that they belong to.
struct ObjectMesh {
  const std::vector<ObjectFaces>& objects;  ///< in the order of the faces
  const std::vector<Triangle>& faces;
  const Positions& positions;

  /// Whether each face belongs to an object.
  bool isWhole() const;
};

struct ObjectMatch {
  std::vector<int> otherOf;     ///< of each object of the first pose: one of the other, or -1
  std::vector<MatchRule> rule;  ///< how it was found
  int extra = 0;                ///< objects that only the other pose has

  bool isComplete() const;
  /// By their names, some objects stand in another order than in the first pose.
  bool namesMoveObjects() const;
  /// Each is where it is in the first pose.
  bool isInOrder() const;
};

/// Names are tried from the most telling to the least: with those of the nodes above, of the node, of the mesh, and
/// these without a number at the end such as Blender's .001; a name counts where it is the only one of its kind in both
/// poses and stands for as many faces. What is left is matched by connectivity. Alike objects (two eyes) go by place,
/// as one rigid motion of all of them leaves it; where that does not tell, by their order.
ObjectMatch matchObjects(const ObjectMesh& first, const ObjectMesh& other);

}  // namespace shapespline
