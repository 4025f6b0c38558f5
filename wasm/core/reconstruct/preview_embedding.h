// Shapes at a fraction of a frame's cost, for while a slider moves: every vertex is carried by a small cell of the
// mesh.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/lri/welded_shape.h"
#include "core/rotation/rotation.h"
#include "core/sparse/cholesky.h"
#include "core/spline/pose_weights.h"

namespace shapespline {

/// Where a component is attached to another: the link's faces, and in every column the point that holds it there
/// (lri.h).
struct EmbeddedPlace {
  int anchorFace, contactFace;
  std::vector<Vec3> pivot;
};

/// Vertices embedded in cells, parts of what follows one frame. A cell turns with its frame and, within it, as its
/// faces do on average; its centre follows from where the keys have neighbouring centres, seen from the frame halfway
/// between theirs (least squares over the graph of cells); a vertex from where the keys have it in its cell. All of
/// that is splined with the curve's weights, so that every key is met. Between the keys the error is of second order in
/// how much a cell bends within itself. No system of the mesh's size is solved.
class PreviewEmbedding {
 public:
  struct Input {
    const WeldedShape& shape;
    std::span<const int> placeOf;       ///< of each vertex in the shapes that are made, a permutation
    std::span<const int> faceOfVertex;  ///< a face of the vertex, or the one that a loose vertex is anchored at
    std::span<const int> loose;         ///< vertices that are anchored
    std::span<const int> frameOf;       ///< frame of each face
    std::span<const int> componentOf;   ///< component of each face
    const std::vector<std::vector<Quaternion>>& frames;  ///< frames[column][frame]
    std::function<Vec3(int face, int column)> turn;      ///< log(G^T R_f)
    std::vector<EmbeddedPlace> anchors;                  ///< parents before children
    bool logarithmic;                                    ///< lengths are splined by their logarithms, as log S_f is
  };

  struct Scratch {
    std::vector<Quaternion> rotation;  // of each cell
    std::vector<Vec3> centre;
    std::vector<double, Eigen::aligned_allocator<double>> solution;
  };

  /// Error: that of the solver.
  static Result<PreviewEmbedding> create(const Input& input);

  /// The shape at `weights`, with the frames' rotations there. places: (x, y, z, pad) of each vertex, in the order of
  /// placeOf.
  void at(const PoseWeights& weights, const std::vector<Quaternion>& frames, Scratch& scratch,
          std::vector<float>& places) const;

 private:
  class Builder;
  PreviewEmbedding() = default;
  // Vertices of one cell, four side by side: numbers_ holds x, y and z of each column for each block.
  struct Cell {
    int frame, component;  // component -1: anchored vertices
    int begin, end;        // in place_, in whole blocks of four
    int size;
    std::vector<Vec3> turn;  // against its frame, one per column
  };
  // Where `to` lies from `from`, in the frame halfway between theirs.
  struct Link {
    int from, to;
    double weight;
    std::vector<Vec3> offset;       // one per column; directions only where there are
    std::vector<double> logLength;  // one per column, or none
  };
  // A component, or anchored vertices, at an anchor face: a point that lies at `offset` from one cell, seen from the
  // face, and at `reach` from the other, seen from that.
  struct Attachment {
    int from, to, frame;
    std::vector<Vec3> turn, offset, reach;  // one per column
  };

  static Vec3 way(const Link& link, const Quaternion& middle, const PoseWeights& weights);
  void settle(const PoseWeights& weights, const std::vector<Quaternion>& frames, Scratch& scratch) const;

  int columns_ = 0, vertexCount_ = 0;
  std::vector<Cell> cells_;
  std::vector<int> place_;  // of the vertices, cell by cell; -1 fills up a block
  std::vector<float> numbers_;
  std::vector<Vec3> mean_;   // of all vertices, one per column
  std::vector<Link> links_;  // between neighbouring cells
  std::vector<Attachment> attachments_;
  Cholesky laplacian_;
};

}  // namespace shapespline
