// A triangle mesh whose vertices collapse onto neighbours without a change of topology (Dey et al. 1999, link
// condition).
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/base/union_find.h"

namespace shapespline {

/// Boundaries and non-manifold lines collapse only along themselves; vertices where such lines end or meet, and where
/// two fans touch, stay. Vertices and faces keep their numbers.
class CollapseMesh {
 public:
  /// faces: three different vertices each, none twice.
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

  /// A vertex that shares an edge with another, and how many faces lie along that edge.
  struct Neighbour {
    int vertex;
    int faces;
    bool onLine() const { return faces != 2; }  ///< on a boundary or a non-manifold line
  };
  void ring(int vertex, std::vector<Neighbour>& ring);

  /// What may become of a vertex. It stays what it is while its neighbours collapse.
  enum class Kind : char {
    Inner,  ///< in a disc: may collapse onto any neighbour
    Line,   ///< inside a boundary or a non-manifold line: may collapse along it
    Fixed,
  };
  Kind kind(int vertex) const { return kind_[vertex]; }

  /// Whether the neighbour `to` can take the place of `from`.
  bool canCollapse(int from, int to);

  /// Returns how many faces are gone.
  int collapse(int from, int to);

 private:
  Kind findKind(int vertex);
  int facesAlong(int a, int b);
  bool hasFace(int a, int b, int c);

  std::vector<Triangle> faces_;
  std::vector<int> first_, next_;  // corners 3 f + c in a list for each vertex
  std::vector<int> valence_;       // number of faces
  std::vector<Kind> kind_;
  int alive_ = 0;

  // scratch
  std::vector<int> slot_;  // of each vertex in the ring that is looked at; -1 outside it
  std::vector<Neighbour> ring_;
  UnionFind fans_;  // of that ring
  std::vector<int> opposite_;
};

}  // namespace shapespline
