// Keyframes: J poses of one mesh at strictly increasing times (paper section 4.1, Eq. 4).
#pragma once

#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "core/spline/key_times.h"

namespace shapespline {

/// One pose of the mesh.
struct Key {
  std::string name;     ///< what the user calls it, usually the file's name
  double time = 0;      ///< in seconds or any unit the user likes
  Positions positions;  ///< n, in the input's own vertex order
};

/// The input of a sequence, in the input's own (raw) vertices and faces.
struct Keyframes {
  std::vector<Triangle> faces;  ///< m, the same in every key
  std::vector<Key> keys;        ///< J >= 2, times strictly increasing
  /// n shading normals of the first key, or empty: copies of a vertex at a seam share a computed normal only where
  /// these agree to within a degree.
  Positions normals;

  int vertexCount() const { return keys.empty() ? 0 : static_cast<int>(keys.front().positions.size()); }
  int faceCount() const { return static_cast<int>(faces.size()); }
  int keyCount() const { return static_cast<int>(keys.size()); }
};

/// Checks everything that the method relies on: at least two keys and one face, equal vertex counts, finite numbers,
/// indices in range, strictly increasing times, and some face with area in every key.
/// Errors name the key, and the vertex or face.
Status validate(const Keyframes& keyframes);

/// The error of a key with another number of vertices than the first one, which says what to do about it. `what` is how
/// the message calls the key.
Error vertexCountMismatch(const std::string& what, int key, std::size_t count, std::size_t first);

/// Compares the faces of key `key` with those of the first key, one by one. Error: FaceCountMismatch with both counts,
/// or FaceMismatch with the first face that differs; says whether the triangles are the same set in another order or
/// winding. `name` is how the message calls the key.
Status compareFaces(const std::vector<Triangle>& first, const std::vector<Triangle>& other, int key,
                    const std::string& name);

}  // namespace shapespline
