// A triangle mesh with edge collapses that preserve the topology (Dey et al. 1999, link condition).
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/base/union_find.h"

namespace shapespline {

/// Boundaries and non-manifold lines collapse only along themselves. Vertices at ends or junctions of such lines, and
/// between two fans, stay. Vertices and faces keep their numbers.
class CollapseMesh {
 public:
  /// faces: three different vertices each, no duplicates.
  CollapseMesh(int vertexCount, std::vector<Triangle> faces);

  int faceCount() const { return alive_; }
  int valence(int vertex) const { return valence_[vertex]; }
  bool isGone(int face) const { return faces_[face][0] < 0; }
  const Triangle& face(int face) const { return faces_[face]; }

  template <class Visit>
  void eachFace(int vertex, Visit visit) {
    for (int* link = &first_[vertex]; *link >= 0;) {
      const int corner = *link;
      if (isGone(corner / 3)) {
        *link = next_[corner];
        continue;
      }
      visit(corner / 3);
      link = &next_[corner];
    }
  }

  /// A neighbouring vertex, and the number of faces along the common edge.
  struct Neighbour {
    int vertex;
    int faces;
    bool onLine() const { return faces != 2; }  ///< on a boundary or a non-manifold line
  };
  void ring(int vertex, std::vector<Neighbour>& ring);

  /// Allowed collapses of a vertex. The kind does not change while neighbours collapse.
  enum class Kind : char {
    Inner,  ///< inside a disc: may collapse onto any neighbour
    Line,   ///< inside a boundary or a non-manifold line: may collapse along it
    Fixed,
  };
  Kind kind(int vertex) const { return kind_[vertex]; }

  /// Whether the edge can be collapsed from `from` onto `to`.
  bool canCollapse(int from, int to);

  /// Returns the number of removed faces.
  int collapse(int from, int to);

 private:
  Kind findKind(int vertex);
  int facesAlong(int a, int b);
  bool hasFace(int a, int b, int c);

  std::vector<Triangle> faces_;
  std::vector<int> first_, next_;  // linked list of corners 3 f + c for each vertex
  std::vector<int> valence_;       // number of faces at each vertex
  std::vector<Kind> kind_;
  int alive_ = 0;

  // Scratch memory.
  std::vector<int> slot_;  // slot of each vertex in the current ring; -1 outside
  std::vector<Neighbour> ring_;
  UnionFind fans_;  // fans of the current ring
  std::vector<int> opposite_;
};

}  // namespace shapespline
