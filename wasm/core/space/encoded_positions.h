// Where a shape that is no blend of coordinates lies in shape space: it has to be encoded to be compared.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"

namespace shapespline {

/// Coordinates of one shape that is no column.
struct ShapeCoordinates {
  std::vector<std::array<double, numbersPerFace>> face;  ///< as FaceCoordinates has them; 0 without area
  std::vector<Vec3> pair;                                ///< as PatchCoordinates::pair
  Vec3 meanPosition;
};

/// The coordinates of the poses, in whichever precision they are: one code for both, where speed does not count.
struct PoseCoordinates {
  const PatchCoordinates& patches;
  const void* faces;
  double (*read)(const void* faces, int face, int column, int number);
  const std::vector<Vec3>& meanPosition;

  double number(int face, int column, int k) const { return read(faces, face, column, k); }
};

template <class Real>
PoseCoordinates coordinatesOf(const PatchCoordinates& patches, const LriCoordinates<Real>& x) {
  const auto read = [](const void* faces, int face, int column, int number) {
    return static_cast<double>(static_cast<const FaceCoordinates<Real>*>(faces)->at(face, column, number));
  };
  return {patches, &x.face, read, x.meanPosition};
}

/// A shape that belongs to these weights (one per column, sum 1), such as the poses' vertices in them, encoded in the
/// poses' patches. Logarithms take the representatives nearest the same blend of the poses' logarithms.
ShapeCoordinates encodeShape(const PoseCoordinates& poses, const WeldedShape& shape, Stretch stretch,
                             const Eigen::VectorXd& weights, const Positions& positions);

}  // namespace shapespline
