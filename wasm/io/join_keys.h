// Poses of several files -> keys of one mesh, in the first one's vertices.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/base/imported.h"
#include "io/object_match.h"

namespace shapespline {

/// Warning for objects that not every file has.
Warning leftOutWarning(const std::vector<std::string>& taken, int count);

/// Adds poses to an import, one after the other. The import has at least one key.
class KeyJoiner {
 public:
  explicit KeyJoiner(Import& import) : import_(import) {}

  /// Adds keys that share these faces. Objects may come in another order than those of the first key (`objects`:
  /// theirs, or none): see matchObjects; those that it lacks are left out, with a warning. Where one vertex of the mesh
  /// stands at several places in them it is split, and a warning says so: normals, colours and coordinates go with it.
  /// `where` is how messages call the file. Errors: VertexCountMismatch, FaceCountMismatch, FaceMismatch of keys that
  /// are not of the mesh.
  Status add(const std::vector<Triangle>& faces, std::vector<Key> keys, const std::string& where,
             const std::vector<ObjectFaces>& objects);

 private:
  void warnOfExtra(int count);
  void addMatches(const ObjectMatch& same, const std::vector<ObjectFaces>& objects, int key);

  Import& import_;
};

}  // namespace shapespline
