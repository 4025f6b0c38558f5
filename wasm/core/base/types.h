// Vectors, matrices, triangles and positions for the whole core.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>  // for cross products

namespace shapespline {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Vertex indices of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

/// n positions, one per vertex, in the unit of the input file.
using Positions = std::vector<Vec3>;

}  // namespace shapespline
