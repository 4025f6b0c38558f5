#include "core/ghost/collapse_mesh.h"

#include <algorithm>
#include <cassert>

namespace shapespline {

namespace {

bool contains(const Triangle& face, int v) { return face[0] == v || face[1] == v || face[2] == v; }

// Whether all faces have three different corners, and no two faces are equal.
[[maybe_unused]] bool areTrianglesOnce(std::vector<Triangle> faces) {
  for (Triangle& face : faces) {
    std::sort(face.begin(), face.end());
    if (face[0] == face[1] || face[1] == face[2]) return false;
  }
  std::sort(faces.begin(), faces.end());
  return std::adjacent_find(faces.begin(), faces.end()) == faces.end();
}

}  // namespace

CollapseMesh::CollapseMesh(int vertexCount, std::vector<Triangle> faces)
    : faces_(std::move(faces)),
      first_(vertexCount, -1),
      next_(3 * faces_.size(), -1),
      valence_(vertexCount, 0),
      kind_(vertexCount, Kind::Fixed),
      alive_(static_cast<int>(faces_.size())),
      slot_(vertexCount, -1) {
  assert(areTrianglesOnce(faces_));
  for (int corner = 3 * alive_ - 1; corner >= 0; --corner) {
    const int v = faces_[corner / 3][corner % 3];
    next_[corner] = first_[v];
    first_[v] = corner;
    ++valence_[v];
  }
  for (int v = 0; v < vertexCount; ++v) kind_[v] = findKind(v);
}

void CollapseMesh::ring(int vertex, std::vector<Neighbour>& ring) {
  ring.clear();
  eachFace(vertex, [&](int f) {
    for (int v : faces_[f]) {
      if (v == vertex) continue;
      if (slot_[v] < 0) {
        slot_[v] = static_cast<int>(ring.size());
        ring.push_back({v, 0});
      }
      ++ring[slot_[v]].faces;
    }
  });
  for (const Neighbour& n : ring) slot_[n.vertex] = -1;
}

CollapseMesh::Kind CollapseMesh::findKind(int vertex) {
  ring(vertex, ring_);
  if (ring_.empty()) return Kind::Fixed;
  int lines = 0, along = 0;
  bool alike = true;
  for (const Neighbour& n : ring_) {
    if (!n.onLine()) continue;
    if (lines++ == 0) along = n.faces;
    else alike &= n.faces == along;
  }
  if (lines != 0 && (lines != 2 || !alike)) return Kind::Fixed;

  // Detects whether the vertex has one fan, or several that share only this vertex.
  const int size = static_cast<int>(ring_.size());
  fans_.reset(size);
  for (int i = 0; i < size; ++i) slot_[ring_[i].vertex] = i;
  int fans = size;
  eachFace(vertex, [&](int f) {
    int ends[2], count = 0;
    for (int v : faces_[f])
      if (v != vertex) ends[count++] = slot_[v];
    fans -= fans_.join(ends[0], ends[1]);
  });
  for (const Neighbour& n : ring_) slot_[n.vertex] = -1;
  if (fans > 1) return Kind::Fixed;
  return lines == 0 ? Kind::Inner : Kind::Line;
}

int CollapseMesh::facesAlong(int a, int b) {
  if (valence_[b] < valence_[a]) std::swap(a, b);
  int count = 0;
  eachFace(a, [&](int f) { count += contains(faces_[f], b); });
  return count;
}

bool CollapseMesh::hasFace(int a, int b, int c) {
  bool found = false;
  eachFace(a, [&](int f) { found |= contains(faces_[f], b) && contains(faces_[f], c); });
  return found;
}

bool CollapseMesh::canCollapse(int from, int to) {
  if (kind_[from] == Kind::Fixed) return false;
  ring(from, ring_);
  const auto edge = std::find_if(ring_.begin(), ring_.end(), [&](const Neighbour& n) { return n.vertex == to; });
  if (edge == ring_.end() || (kind_[from] == Kind::Line) != edge->onLine()) return false;
  const int along = edge->faces;

  opposite_.clear();
  eachFace(from, [&](int f) {
    if (!contains(faces_[f], to)) return;
    for (int v : faces_[f])
      if (v != from && v != to) opposite_.push_back(v);
  });
  const auto isOpposite = [&](int v) { return std::find(opposite_.begin(), opposite_.end(), v) != opposite_.end(); };

  // Link condition: vertices in both links must belong to the link of the edge.
  for (const Neighbour& n : ring_)
    if (n.vertex != to && !isOpposite(n.vertex) && facesAlong(n.vertex, to) > 0) return false;
  // No edge may belong to both links. First, check third sides of faces.
  bool twice = false;
  eachFace(from, [&](int f) {
    if (contains(faces_[f], to)) return;
    int ends[2], count = 0;
    for (int v : faces_[f])
      if (v != from && isOpposite(v)) ends[count++] = v;
    twice |= count == 2 && hasFace(ends[0], ends[1], to);
  });
  if (twice) return false;
  // A cone closes the boundary. Its edges must not belong to both links either.
  if (along == 1)
    for (int x : opposite_)
      if (facesAlong(from, x) == 1 && facesAlong(to, x) == 1) return false;
  return true;
}

int CollapseMesh::collapse(int from, int to) {
  int gone = 0;
  for (int corner = first_[from], next; corner >= 0; corner = next) {
    next = next_[corner];
    Triangle& face = faces_[corner / 3];
    if (face[0] < 0) continue;
    if (contains(face, to)) {
      for (int v : face) --valence_[v];
      face = {-1, -1, -1};
      ++gone;
      continue;
    }
    face[corner % 3] = to;
    ++valence_[to];
    next_[corner] = first_[to];
    first_[to] = corner;
  }
  first_[from] = -1;
  valence_[from] = 0;
  alive_ -= gone;
  return gone;
}

}  // namespace shapespline
