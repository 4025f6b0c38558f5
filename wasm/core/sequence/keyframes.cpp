#include "core/sequence/keyframes.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "core/mesh/same_surface.h"

namespace shapespline {

namespace {

std::string keyName(const std::string& name, int key) {
  const std::string number = "key " + std::to_string(key + 1);
  return name.empty() ? number : name + " (" + number + ")";
}

constexpr const char* oneMesh =
    " All keys must be poses of one mesh. In Blender, export the same object each time, with its modifiers applied and "
    "the same settings, or one GLB with shape keys or an animation. OBJ keeps the vertices unchanged.";

Triangle sorted(Triangle face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::vector<Triangle> sortedSet(const std::vector<Triangle>& faces) {
  std::vector<Triangle> set(faces.size());
  std::transform(faces.begin(), faces.end(), set.begin(), sorted);
  std::sort(set.begin(), set.end());
  return set;
}

// Describes how equal triangles differ, as an addition to the message. Empty if the triangles themselves differ.
std::string sameTrianglesHint(const std::vector<Triangle>& first, const std::vector<Triangle>& other) {
  bool inPlace = true;
  for (std::size_t f = 0; f < first.size() && inPlace; ++f) inPlace = sorted(first[f]) == sorted(other[f]);
  if (inPlace) return " The triangles are the same but some have the opposite winding.";
  if (sortedSet(first) == sortedSet(other)) return " The triangles are the same but in a different order.";
  return "";
}

std::string faceText(const Triangle& f) {
  return "(" + std::to_string(f[0]) + ", " + std::to_string(f[1]) + ", " + std::to_string(f[2]) + ")";
}

Status validateFaces(const Keyframes& k) {
  if (k.faces.empty())
    return Error{ErrorCode::NoTriangles, "The keys have no triangles. Add at least one mesh with faces."};
  const int n = k.vertexCount();
  for (int f = 0; f < k.faceCount(); ++f)
    for (int v : k.faces[f])
      if (v < 0 || v >= n)
        return Error{ErrorCode::IndexOutOfRange,
                     "Face " + grouped(f) + " refers to vertex " + grouped(v) + ", but there are " + grouped(n) +
                         " vertices (0 to " + grouped(n - 1) + "). Export the mesh again.",
                     -1, v, f};
  return {};
}

Status validatePositions(const Keyframes& k, int key) {
  const Key& pose = k.keys[key];
  const auto n = static_cast<std::size_t>(k.vertexCount());
  if (pose.positions.size() != n) return vertexCountMismatch(keyName(pose.name, key), key, pose.positions.size(), n);
  for (std::size_t v = 0; v < n; ++v)
    if (!pose.positions[v].allFinite())
      return Error{ErrorCode::NotFinite,
                   keyName(pose.name, key) + ": the position of vertex " + grouped(v) +
                       " is not a finite number. Repair the mesh and export it again.",
                   key, static_cast<int>(v)};
  return {};
}

Status validateArea(const Keyframes& k, int key) {
  const Positions& p = k.keys[key].positions;
  for (const Triangle& f : k.faces)
    if ((p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).squaredNorm() > 0) return {};
  return Error{ErrorCode::NoArea,
               keyName(k.keys[key].name, key) +
                   ": every triangle has zero area. Use a pose in which the shape is not collapsed.",
               key};
}

}  // namespace

Status validate(const Keyframes& k) {
  if (k.keyCount() < 2)
    return Error{ErrorCode::TooFewKeys, k.keyCount() == 0
                                            ? "There are no keys. Give at least two poses of one mesh."
                                            : "There is only one key. Give at least two poses of one mesh."};
  if (Status faces = validateFaces(k); !faces) return faces;
  for (int j = 0; j < k.keyCount(); ++j) {
    if (Status positions = validatePositions(k, j); !positions) return positions;
    if (Status area = validateArea(k, j); !area) return area;
  }
  std::vector<double> times;
  for (const Key& key : k.keys) times.push_back(key.time);
  return validateTimes(times, k.keyCount());
}

Error vertexCountMismatch(const std::string& what, int key, std::size_t count, std::size_t first) {
  return {ErrorCode::VertexCountMismatch,
          what + " has " + grouped(static_cast<std::int64_t>(count)) + " vertices, but key 1 has " +
              grouped(static_cast<std::int64_t>(first)) + "." + oneMesh,
          key};
}

Status compareFaces(const std::vector<Triangle>& first, const std::vector<Triangle>& other, int key,
                    const std::string& name) {
  if (first.size() != other.size())
    return Error{
        ErrorCode::FaceCountMismatch,
        name + " has " + grouped(other.size()) + " faces, but key 1 has " + grouped(first.size()) + "." + oneMesh, key};
  const auto [a, b] = std::mismatch(first.begin(), first.end(), other.begin(), sameTriangle);
  if (a == first.end()) return {};
  const int face = static_cast<int>(a - first.begin());
  return Error{ErrorCode::FaceMismatch,
               name + ": face " + grouped(face) + " is " + faceText(*b) + ", but in key 1 it is " + faceText(*a) +
                   ", all counted from 0." + sameTrianglesHint(first, other) + oneMesh,
               key, -1, face};
}

}  // namespace shapespline
