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
  std::string name;     ///< display name, usually the file name
  double time = 0;      ///< in seconds or any other unit
  Positions positions;  ///< n, in the input's vertex order
};

/// The input of a sequence, with the input's (raw) vertices and faces.
struct Keyframes {
  std::vector<Triangle> faces;  ///< m, the same in every key
  std::vector<Key> keys;        ///< J >= 2, times strictly increasing
  /// n shading normals of the first key, or empty. Copies of a vertex at a seam share a computed normal only if these
  /// agree within a degree.
  Positions normals;

  int vertexCount() const { return keys.empty() ? 0 : static_cast<int>(keys.front().positions.size()); }
  int faceCount() const { return static_cast<int>(faces.size()); }
  int keyCount() const { return static_cast<int>(keys.size()); }
};

/// Checks the requirements of the method: at least two keys and one face, equal vertex counts, finite numbers, indices
/// in range, strictly increasing times, and some face with area in every key.
/// Errors name the key, and the vertex or face: TooFewKeys, NoTriangles, IndexOutOfRange, VertexCountMismatch,
/// NotFinite, NoArea, and those of validateTimes.
Status validate(const Keyframes& keyframes);

/// Error with advice for a key with a different number of vertices than the first. `what`: name of the key in the
/// message.
Error vertexCountMismatch(const std::string& what, int key, std::size_t count, std::size_t first);

/// Compares the faces of key `key` with those of the first key, one by one. Error: FaceCountMismatch with both counts,
/// or FaceMismatch with the first different face. The message also reports equal triangles in another order or winding.
/// `name`: name of the key in the message.
Status compareFaces(const std::vector<Triangle>& first, const std::vector<Triangle>& other, int key,
                    const std::string& name);

}  // namespace shapespline
