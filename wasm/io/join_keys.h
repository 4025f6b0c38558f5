// Joins poses of several files as keys of one mesh, in the first file's vertices.
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "io/base/imported.h"
#include "io/object_match.h"

namespace shapespline {

/// Warning about objects that some files lack.
Warning leftOutWarning(const std::vector<std::string>& taken, int count);

/// Adds poses to an import one by one. The import must have at least one key.
class KeyJoiner {
 public:
  explicit KeyJoiner(Import& import) : import_(import) {}

  /// Adds keys that share these faces.
  /// Objects may come in another order than in the first key (`objects`: those of these keys, or empty; see
  /// matchObjects). Objects unknown to the first key are omitted with a warning.
  /// A mesh vertex with several positions in these keys is split with a warning, together with its normals, colours and
  /// coordinates. `where`: display name of the file. Errors: VertexCountMismatch, FaceCountMismatch, FaceMismatch for
  /// keys of a different mesh.
  Status add(const std::vector<Triangle>& faces, std::vector<Key> keys, const std::string& where,
             const std::vector<ObjectFaces>& objects);

 private:
  void warnOfExtra(int count);
  void addMatches(const ObjectMatch& same, const std::vector<ObjectFaces>& objects, int key);

  Import& import_;
};

}  // namespace shapespline
