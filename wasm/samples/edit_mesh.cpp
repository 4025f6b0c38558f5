#include "samples/edit_mesh.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

namespace shapespline {
namespace {

int cornerOf(const Triangle& face, int vertex) {
  return static_cast<int>(std::find(face.begin(), face.end(), vertex) - face.begin());
}

bool contains(const Triangle& face, int vertex) { return cornerOf(face, vertex) < 3; }

int after(const Triangle& face, int vertex) { return face[(cornerOf(face, vertex) + 1) % 3]; }
int before(const Triangle& face, int vertex) { return face[(cornerOf(face, vertex) + 2) % 3]; }

Vec3 areaNormal(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

// A face may tilt while the mesh is edited, but by less than about 60 degrees at once.
bool sameSide(const Vec3& old, const Vec3& changed) { return old.dot(changed) > 0.5 * old.norm() * changed.norm(); }

}  // namespace

EditMesh::EditMesh(Surface surface) : surface_(std::move(surface)) { link(); }

void EditMesh::link() {
  facesOf_.assign(surface_.positions.size(), {});
  for (int f = 0; f < static_cast<int>(surface_.faces.size()); ++f) {
    for (int v : surface_.faces[f]) facesOf_[v].push_back(f);
  }
}

int EditMesh::faceWith(int a, int b) const {
  for (int f : facesOf_[a]) {
    if (after(surface_.faces[f], a) == b) return f;
  }
  return -1;
}

Vec3 EditMesh::faceNormal(const Triangle& face) const {
  return areaNormal(position(face[0]), position(face[1]), position(face[2]));
}

std::vector<int> EditMesh::ring(int vertex) const {
  std::vector<int> result;
  if (facesOf_[vertex].empty()) return result;
  const int first = after(surface_.faces[facesOf_[vertex][0]], vertex);
  int next = first;
  do {
    result.push_back(next);
    next = before(surface_.faces[faceWith(vertex, next)], vertex);
  } while (next != first);
  return result;
}

Vec3 EditMesh::normal(int vertex) const {
  Vec3 sum = Vec3::Zero();
  for (int f : facesOf_[vertex]) sum += faceNormal(surface_.faces[f]);
  return sum;
}

std::pair<int, int> EditMesh::opposite(int a, int b) const {
  return {before(surface_.faces[faceWith(a, b)], a), before(surface_.faces[faceWith(b, a)], b)};
}

void EditMesh::splitEdges(const std::function<bool(int, int)>& tooLong) {
  std::unordered_map<std::uint64_t, int> middle;  // of each marked edge
  const auto key = [](int a, int b) { return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b)); };
  const auto find = [&](int a, int b) {
    const auto place = middle.find(key(a, b));
    return place == middle.end() ? -1 : place->second;
  };
  for (const Triangle& face : surface_.faces) {
    for (int c = 0; c < 3; ++c) {
      const int a = face[c], b = face[(c + 1) % 3];
      if (a > b || !tooLong(a, b)) continue;
      middle[key(a, b)] = vertexCount();
      surface_.positions.push_back(0.5 * (position(a) + position(b)));
    }
  }
  std::vector<Triangle> faces;
  for (Triangle face : surface_.faces) {
    const auto marked = [&](int c) { return find(face[c], face[(c + 1) % 3]); };
    const int count = (marked(0) >= 0) + (marked(1) >= 0) + (marked(2) >= 0);
    // Turn the face so that with one mark edge 0 has it, and with two marks edge 2 has none.
    while ((count == 1 && marked(0) < 0) || (count == 2 && marked(2) >= 0)) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
    }
    const auto [a, b, c] = face;
    const int ab = marked(0), bc = marked(1), ca = marked(2);
    if (count == 0) faces.push_back(face);
    if (count == 1) faces.insert(faces.end(), {{a, ab, c}, {ab, b, c}});
    if (count == 2) {
      faces.push_back({ab, b, bc});
      const bool fromA = (position(a) - position(bc)).squaredNorm() < (position(ab) - position(c)).squaredNorm();
      if (fromA) faces.insert(faces.end(), {{a, ab, bc}, {a, bc, c}});
      else faces.insert(faces.end(), {{a, ab, c}, {ab, bc, c}});
    }
    if (count == 3) faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  surface_.faces = std::move(faces);
  link();
}

// The link condition: the ends share exactly the two opposite vertices, and none of these is left with two faces.
bool EditMesh::canCollapse(int from, int to) const {
  if (faceWith(from, to) < 0) return false;
  const auto [left, right] = opposite(from, to);
  if (valence(left) <= 3 || valence(right) <= 3) return false;
  const std::vector<int> around = ring(to);
  for (int v : ring(from)) {
    const bool shared = std::find(around.begin(), around.end(), v) != around.end();
    if (shared && v != left && v != right) return false;
  }
  return true;
}

bool EditMesh::keepsNormals(int vertex, int other, const Vec3& position) const {
  for (int f : facesOf_[vertex]) {
    const Triangle& face = surface_.faces[f];
    if (contains(face, other)) continue;
    const Vec3& b = surface_.positions[after(face, vertex)];
    const Vec3& c = surface_.positions[before(face, vertex)];
    if (!sameSide(faceNormal(face), areaNormal(position, b, c))) return false;
  }
  return true;
}

bool EditMesh::collapse(int from, int to, const Vec3& position, const TooLong& tooLong) {
  if (!canCollapse(from, to)) return false;
  if (!keepsNormals(from, to, position) || !keepsNormals(to, from, position)) return false;
  for (int end : {from, to}) {
    for (int v : ring(end)) {
      if (v != from && v != to && tooLong(surface_.positions[v], position)) return false;
    }
  }
  for (int f : {faceWith(from, to), faceWith(to, from)}) {
    for (int v : surface_.faces[f]) detach(v, f);
    surface_.faces[f] = {-1, -1, -1};
  }
  for (int f : facesOf_[from]) {
    surface_.faces[f][cornerOf(surface_.faces[f], from)] = to;
    facesOf_[to].push_back(f);
  }
  facesOf_[from].clear();
  move(to, position);
  return true;
}

bool EditMesh::flip(int a, int b) {
  const auto [left, right] = opposite(a, b);
  if (left == right || faceWith(left, right) >= 0 || faceWith(right, left) >= 0) return false;
  if (valence(a) <= 3 || valence(b) <= 3) return false;
  const int f = faceWith(a, b), g = faceWith(b, a);
  const Triangle upper{right, left, a}, lower{left, right, b};
  const Vec3 old = faceNormal(surface_.faces[f]) + faceNormal(surface_.faces[g]);
  if (!sameSide(old, faceNormal(upper)) || !sameSide(old, faceNormal(lower))) return false;
  detach(b, f);
  detach(a, g);
  surface_.faces[f] = upper;
  surface_.faces[g] = lower;
  facesOf_[right].push_back(f);
  facesOf_[left].push_back(g);
  return true;
}

void EditMesh::detach(int vertex, int face) { std::erase(facesOf_[vertex], face); }

void EditMesh::compact() {
  std::vector<int> place(surface_.positions.size(), -1);
  Positions kept;
  std::erase_if(surface_.faces, [](const Triangle& face) { return face[0] < 0; });
  for (Triangle& face : surface_.faces) {
    for (int& v : face) {
      if (place[v] < 0) {
        place[v] = static_cast<int>(kept.size());
        kept.push_back(surface_.positions[v]);
      }
      v = place[v];
    }
  }
  surface_.positions = std::move(kept);
  link();
}

Surface EditMesh::take() {
  compact();
  return std::move(surface_);
}

}  // namespace shapespline
