// Shapes with known motions for the invariants: exactly twisted and bent boxes, spheres, small difficult meshes.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/rotation/rigid_fit.h"
#include "core/rotation/rotation.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/sequence.h"
#include "core/space/gram_matrix.h"

namespace shapespline::test {

inline constexpr double pi = std::numbers::pi;
inline double radians(double degrees) { return degrees * pi / 180; }

struct Shape {
  Positions positions;
  std::vector<Triangle> faces;
};

/// A closed, welded box of nx x ny x nz cells. z runs along the bar from 0 to depth; x and y are centred.
inline Shape box(double width, double height, double depth, int nx, int ny, int nz) {
  Shape shape;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](int i, int j, int k) {
    const auto [it, added] = index.emplace(std::array{i, j, k}, static_cast<int>(shape.positions.size()));
    if (added)
      shape.positions.emplace_back(width * (double(i) / nx - 0.5), height * (double(j) / ny - 0.5), depth * k / nz);
    return it->second;
  };
  const auto quad = [&](int a, int b, int c, int d, bool flip) {
    if (flip) shape.faces.push_back({a, b, d}), shape.faces.push_back({b, c, d});
    else shape.faces.push_back({a, b, c}), shape.faces.push_back({a, c, d});
  };
  for (int i = 0; i < nx; ++i)
    for (int k = 0; k < nz; ++k) {
      quad(vertex(i, 0, k), vertex(i + 1, 0, k), vertex(i + 1, 0, k + 1), vertex(i, 0, k + 1), (i + k) % 2);
      quad(vertex(i, ny, k + 1), vertex(i + 1, ny, k + 1), vertex(i + 1, ny, k), vertex(i, ny, k), (i + k) % 2);
    }
  for (int j = 0; j < ny; ++j)
    for (int k = 0; k < nz; ++k) {
      quad(vertex(0, j, k + 1), vertex(0, j + 1, k + 1), vertex(0, j + 1, k), vertex(0, j, k), (j + k) % 2);
      quad(vertex(nx, j, k), vertex(nx, j + 1, k), vertex(nx, j + 1, k + 1), vertex(nx, j, k + 1), (j + k) % 2);
    }
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      quad(vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0), vertex(i, j, 0), (i + j) % 2);
      quad(vertex(i, j, nz), vertex(i + 1, j, nz), vertex(i + 1, j + 1, nz), vertex(i, j + 1, nz), (i + j) % 2);
    }
  return shape;
}

/// The closed bar 1 x 1 x 10.
inline Shape bar() { return box(1, 1, 10, 4, 4, 40); }

inline Shape sphere(const Vec3& centre, double radius, int rings = 12, int segments = 24) {
  Shape shape;
  shape.positions.push_back(centre + Vec3(0, 0, radius));
  for (int r = 1; r < rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const double theta = pi * r / rings, phi = 2 * pi * s / segments;
      shape.positions.push_back(
          centre + radius * Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
    }
  shape.positions.push_back(centre - Vec3(0, 0, radius));
  const int last = static_cast<int>(shape.positions.size()) - 1;
  const auto at = [&](int r, int s) { return 1 + (r - 1) * segments + s % segments; };
  for (int s = 0; s < segments; ++s) {
    shape.faces.push_back({0, at(1, s), at(1, s + 1)});
    shape.faces.push_back({last, at(rings - 1, s + 1), at(rings - 1, s)});
    for (int r = 1; r + 1 < rings; ++r) {
      shape.faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      shape.faces.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return shape;
}

inline Shape joined(const Shape& a, const Shape& b) {
  Shape both = a;
  const int offset = static_cast<int>(a.positions.size());
  both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& f : b.faces) both.faces.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  return both;
}

using Map = std::function<Vec3(const Vec3&)>;

inline Positions mapped(const Positions& positions, const Map& map) {
  Positions result;
  for (const Vec3& p : positions) result.push_back(map(p));
  return result;
}

/// Twists about z, from 0 at z = 0 to `angle` at z = depth.
inline Map twist(double angle, double depth = 10) {
  return [=](const Vec3& p) -> Vec3 {
    const double a = angle * p.z() / depth, c = std::cos(a), s = std::sin(a);
    return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
  };
}

/// Bends the z axis to an arc of equal length and the given angle, in the xz plane.
inline Map bend(double angle, double depth = 10) {
  return [=](const Vec3& p) -> Vec3 {
    if (std::abs(angle) < 1e-12) return p;
    const double radius = depth / angle, a = p.z() / radius;
    return {radius - (radius - p.x()) * std::cos(a), p.y(), (radius - p.x()) * std::sin(a)};
  };
}

inline Map turn(const Vec3& axis, double angle, const Vec3& move = Vec3::Zero()) {
  const Mat3 r = expRotation(axis.normalized() * angle);
  return [=](const Vec3& p) -> Vec3 { return r * p + move; };
}

inline Keyframes keyframes(const Shape& shape, const std::vector<Map>& maps, std::vector<double> times = {}) {
  Keyframes k;
  k.faces = shape.faces;
  if (times.empty()) times = evenTimes(static_cast<int>(maps.size()));
  for (std::size_t j = 0; j < maps.size(); ++j) k.keys.push_back({"", times[j], mapped(shape.positions, maps[j])});
  return k;
}

inline Keyframes bentBar(const std::vector<double>& degrees, const Shape& shape = bar()) {
  std::vector<Map> maps;
  for (double d : degrees) maps.push_back(bend(radians(d)));
  return keyframes(shape, maps);
}

inline Keyframes twistedBar(const std::vector<double>& degrees, const Shape& shape = bar()) {
  std::vector<Map> maps;
  for (double d : degrees) maps.push_back(twist(radians(d)));
  return keyframes(shape, maps);
}

inline double diagonalOf(const Keyframes& k) {
  std::vector<const Positions*> poses;
  for (const Key& key : k.keys) poses.push_back(&key.positions);
  return boundingDiagonal(poses);
}

inline EncodingOptions doublePrecision() {
  EncodingOptions options;
  options.precision = Precision::Double;
  return options;
}

inline double largestDistance(const Positions& a, const Positions& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
  return largest;
}

inline Positions toPositions(const std::vector<float>& xyz) {
  Positions p(xyz.size() / 3);
  for (std::size_t v = 0; v < p.size(); ++v) p[v] = Vec3(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]);
  return p;
}

/// `from`, moved rigidly onto `to`.
inline Positions aligned(const Positions& from, const Positions& to) {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) a += from[v] / double(from.size()), b += to[v] / double(to.size());
  const Mat3 r = fitRigid(from, to).rotation;
  return mapped(from, [&](const Vec3& p) -> Vec3 { return r * (p - a) + b; });
}

/// Rotation of each cross-section of a bar along z relative to the next, from rigid fits of its vertices; `perUnit`
/// sections per unit of length.
inline std::vector<Vec3> sectionTurns(const Positions& rest, const Positions& pose, int perUnit) {
  std::map<int, std::pair<Positions, Positions>> sections;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    auto& [a, b] = sections[static_cast<int>(std::lround(rest[v].z() * perUnit))];
    a.push_back(rest[v]), b.push_back(pose[v]);
  }
  std::vector<Vec3> turns;
  Mat3 before = Mat3::Identity();
  bool first = true;
  for (const auto& [z, section] : sections) {
    const Mat3 r = fitRigid(section.first, section.second).rotation;
    if (!first) turns.push_back(logRotation(Mat3(before.transpose() * r)));
    before = r, first = false;
  }
  return turns;
}

}  // namespace shapespline::test
