// Encodes a shape that is not a blend of coordinates, to locate it in shape space.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/lri/lri.h"
#include "core/patches/patch_coordinates.h"

namespace shapespline {

/// Coordinates of a shape that is not a column.
struct ShapeCoordinates {
  std::vector<std::array<double, numbersPerFace>> face;  ///< in the format of FaceCoordinates; 0 without a rotation
  std::vector<Vec3> pair;                                ///< in the format of PatchCoordinates::pair
  Vec3 meanPosition;
};

/// Coordinates of the poses in either precision. Speed is not critical here, so one implementation serves both.
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

/// Encodes a shape with the poses' patches. weights: one per column, sum 1. The shape must be the result of blending
/// with these weights, for example a blend of the poses' vertices. Logarithms use the representatives nearest to the
/// same blend of the poses' logarithms.
ShapeCoordinates encodeShape(const PoseCoordinates& poses, const WeldedShape& shape, Stretch stretch,
                             const Eigen::VectorXd& weights, const Positions& positions);

}  // namespace shapespline
