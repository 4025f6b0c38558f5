// Torn faces: faces that are stretched far more than their component between the poses, such as the membrane of a mouth
// that opens. Their rotations mean nothing, so they carry none.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/lri/local_frames.h"
#include "core/lri/welded_shape.h"

namespace shapespline {

/// How much each face is torn. 0: ordinary, or without area. 1: an edge or a height changes at least eightfold over the
/// poses, relative to the size of the component. The share is continuous in the poses and grows from a fivefold change
/// on. A face whose neighbours are all torn is torn as much. Shares count from the least one of the
/// component, so a component with only torn faces is ordinary.
/// parts: the components of the faces with area. Empty if no face is torn.
std::vector<double> tornShares(const WeldedShape& shape, const std::vector<char>& hasArea, const Components& parts);

/// ShapeTopology::anchor, from the other members.
std::vector<int> anchorsOf(const WeldedShape& shape, const ShapeTopology& topology);

/// A torn face in the second system. Its gradient is blended in the frame of the faces that it hangs on, without a
/// rotation of its own.
struct TornFace {
  Triangle corners;
  int anchorFace;  ///< a face that carries a rotation
  int frame;       ///< local frame of the anchor
  /// Divergence at the first two corners, per column: D_f times the share torn, times the area, times the gradient of
  /// the corner's hat function. The three corners have sum 0. Relative to the local frame, and to the anchor's
  /// rotation.
  struct Columns {
    std::vector<Vec3> first, second;
  } inFrame, inAnchor;
};

/// facesRest: D_f equals the rotation of the face's frame in every column.
std::vector<TornFace> encodeTornFaces(const WeldedShape& shape, const ShapeTopology& topology,
                                      const LocalFramePoses& frames, bool facesRest);

}  // namespace shapespline
