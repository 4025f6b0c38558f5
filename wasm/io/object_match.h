// Matches objects of two poses: by name, then by shape and position, then by the order in the files.
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
  /// Whether every object has its index of the first pose.
  bool isInOrder() const;
};

/// Names are tried from the most specific to the least: with the names of ancestors, of the node, of the mesh, and each
/// of them without a trailing number such as Blender's .001. A name counts if it is unique in both poses and has the
/// same number of faces. Remaining objects are matched by connectivity. Similar objects (two eyes) are matched by
/// position under one rigid motion of all of them, and if that is ambiguous, by order.
ObjectMatch matchObjects(const ObjectMesh& first, const ObjectMesh& other);

}  // namespace shapespline
