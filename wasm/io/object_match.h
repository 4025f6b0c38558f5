// Matches objects of two poses: by name, then by shape and position, then by file order.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "io/base/imported.h"

namespace shapespline {

/// The faces of a pose and their objects.
struct ObjectMesh {
  const std::vector<ObjectFaces>& objects;  ///< in face order
  const std::vector<Triangle>& faces;
  const Positions& positions;

  /// Whether each face belongs to an object.
  bool isWhole() const;
};

struct ObjectMatch {
  std::vector<int> otherOf;     ///< other pose's object for each object of the first pose, or -1
  std::vector<MatchRule> rule;  ///< rule that found each match
  int extra = 0;                ///< number of objects that only the other pose has

  bool isComplete() const;
  /// Whether matching by name changes the order of some objects.
  bool namesMoveObjects() const;
  /// Whether every object keeps its index.
  bool isInOrder() const;
};

/// Tries names from the most specific to the least: with the names of ancestors, of the node, of the mesh, then each
/// without a trailing number such as Blender's .001. A name counts if it is unique in both poses and the face counts
/// agree. Remaining objects are matched by connectivity. Similar objects (two eyes) are matched by position under a
/// common rigid motion. If that is ambiguous, file order decides.
ObjectMatch matchObjects(const ObjectMesh& first, const ObjectMesh& other);

}  // namespace shapespline
