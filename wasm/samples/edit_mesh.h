// A closed triangle mesh whose edges can be split, collapsed and flipped.
#pragma once

#include <functional>
#include <vector>

#include "samples/surface.h"

namespace shapespline {

/// Stays closed and manifold through every operation. Removed faces have corner -1 until compact().
class EditMesh {
 public:
  explicit EditMesh(Surface surface);

  int vertexCount() const { return static_cast<int>(surface_.positions.size()); }
  const Vec3& position(int vertex) const { return surface_.positions[vertex]; }
  void move(int vertex, const Vec3& position) { surface_.positions[vertex] = position; }
  int valence(int vertex) const { return static_cast<int>(facesOf_[vertex].size()); }

  /// The vertices around a vertex, counter-clockwise seen from outside.
  std::vector<int> ring(int vertex) const;

  /// Area-weighted normal, not normalised.
  Vec3 normal(int vertex) const;

  /// Splits at their midpoints all edges for which `tooLong` holds, at once.
  void splitEdges(const std::function<bool(int, int)>& tooLong);

  /// Moves both ends of the edge to `position` and removes its two faces, unless the result would not be manifold, or
  /// would turn a face over, or have an edge for which `tooLong(neighbour, position)` holds.
  using TooLong = std::function<bool(const Vec3&, const Vec3&)>;
  bool collapse(int from, int to, const Vec3& position, const TooLong& tooLong);

  /// Replaces edge (a, b) by the other diagonal of its two faces, unless that edge exists or a face would turn over.
  bool flip(int a, int b);

  /// The two vertices opposite the edge: left of a -> b, then right.
  std::pair<int, int> opposite(int a, int b) const;

  /// Removes deleted vertices and faces.
  void compact();

  Surface take();

 private:
  int faceWith(int a, int b) const;  // the face that has the directed edge a -> b, or -1
  void link();
  Vec3 faceNormal(const Triangle& face) const;
  bool canCollapse(int from, int to) const;
  bool keepsNormals(int vertex, int other, const Vec3& position) const;
  void detach(int vertex, int face);

  Surface surface_;
  std::vector<std::vector<int>> facesOf_;
};

}  // namespace shapespline
