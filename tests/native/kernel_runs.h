// Runs of the vector kernels on plain data. Included twice: as the core is built, and as it is without vector
// instructions (scalar_kernels.cpp, where the namespace has another name).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/mesh/vertex_normals.h"
#include "core/reconstruct/face_kernel.h"
#include "core/sparse/dense_front.h"
#include "core/sparse/panel_factor.h"

namespace kernels {

using Faces = std::vector<std::array<int, 3>>;

/// xyz interleaved.
struct Surface {
  std::vector<double> xyz;
  Faces faces;
};

/// Weights of three columns, and the end key that they go on from or -1.
struct Blend {
  std::vector<double> weights = {0.4, 0.9, -0.3};
  int beyond = -1;
};

// Reproducible numbers in [-1, 1).
class Noise {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) * 0x1.0p-52 - 1.0;
  }

 private:
  unsigned long long state_ = 1;
};

}  // namespace kernels

namespace shapespline::kernelRuns {

/// Right-hand side of random coordinates on the surface, one frame for every three faces. In the first
/// column all faces rest. largestTurn: radians.
template <class Real>
std::vector<Real> rightHandSide(const kernels::Surface& surface, double largestTurn, bool logarithmic,
                                const kernels::Blend& blend = {}) {
  WeldedShape shape;
  shape.faces = surface.faces;
  shape.keys = 1;
  shape.poses.emplace_back();
  for (std::size_t i = 0; i < surface.xyz.size(); i += 3)
    shape.poses[0].push_back({surface.xyz[i], surface.xyz[i + 1], surface.xyz[i + 2]});
  const int faceCount = shape.faceCount(), vertexCount = shape.vertexCount(), columns = 3;
  std::vector<int> frameOf(faceCount), position(vertexCount);
  for (int f = 0; f < faceCount; ++f) frameOf[f] = f % 7 == 3 ? -1 : f / 3;
  for (int v = 0; v < vertexCount; ++v) position[v] = vertexCount - 1 - v;

  kernels::Noise noise;
  const double one = logarithmic ? 0 : 1;
  FaceCoordinates<Real> coordinates(faceCount, columns, static_cast<Real>(one));
  coordinates.store();
  for (int f = 0; f < faceCount; ++f)
    for (int c = 1; c < columns; ++c) {
      for (int k = 0; k < 3; ++k) coordinates.set(f, c, k, static_cast<Real>(largestTurn * noise.next()));
      coordinates.set(f, c, 3, static_cast<Real>(one + 0.2 * noise.next()));
      coordinates.set(f, c, 4, static_cast<Real>(0.2 * noise.next()));
      coordinates.set(f, c, 5, static_cast<Real>(one + 0.2 * noise.next()));
    }
  coordinates.dropIfAtRest(0);
  const FaceKernel<Real> kernel(shape, frameOf, logarithmic ? Stretch::Log : Stretch::Linear, position, vertexCount);
  coordinates.reorder(kernel.order());
  std::vector<Real> frames(numbersPerFrame * static_cast<std::size_t>(faceCount / 3 + 1), Real(0));
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (i % 4 != 3) frames[i] = static_cast<Real>(noise.next());
  std::vector<Real> result(4 * (static_cast<std::size_t>(vertexCount) + 1), Real(0));
  const int lost =
      kernel
          .accumulate(coordinates, frames,
                      coordinates.weights({.column = blend.weights, .keys = columns, .beyond = blend.beyond}),
                      result.data())
          .count;
  result.push_back(static_cast<Real>(lost));
  return result;
}

/// A front of a definite matrix with so many pivots and rows below them, eliminated.
struct EliminatedFront {
  std::vector<double> columns, inverse, update;

  EliminatedFront(int pivotCount, int rows, kernels::Noise& noise) {
    const Pivots pivots(pivotCount);
    const int pivotRows = 4 * pivots.strips, strips = pivots.strips + stripsFor(rows);
    columns.assign(pivots.stripAt(strips), 0.0);
    inverse.resize(4 * static_cast<std::size_t>(pivotRows));
    update.resize(stripOffset(stripsFor(rows)));
    std::vector<double> reference(pivotRows, 1.0);
    for (int r = 0; r < pivotRows + rows; ++r)
      for (int c = 0; c <= std::min(r, pivotRows - 1); ++c) {
        double& entry = columns[pivots.stripAt(r / 4) + 4 * static_cast<std::size_t>(c) + r % 4];
        entry = c >= pivots.padding && c < r ? noise.next() : 0;
        if (c == r) entry = r < pivots.padding ? 1 : pivotCount;
        if (c == r) reference[r] = entry;
      }
    PivotReport report;
    eliminateStrips(columns.data(), update.data(), pivots, 0, strips, reference.data(), inverse.data(), report);
  }
};

inline std::vector<double> denseUpdate(int pivotCount, int rows) {
  kernels::Noise noise;
  return EliminatedFront(pivotCount, rows, noise).update;
}

/// Solution of a dense definite system of `size` unknowns, through the dense elimination and the panels.
template <class Real>
std::vector<Real> denseSolution(int size) {
  SymbolicFactor symbolic;
  for (int i = 0; i < size; ++i) symbolic.order.push_back(i), symbolic.position.push_back(i);
  symbolic.first = {0, size};
  symbolic.rowStart = {0, 0};
  symbolic.parent = {-1};
  kernels::Noise noise;
  const EliminatedFront front(size, 0, noise);
  PanelFactor<Real> factor;
  factor.allocate(symbolic);
  factor.store(symbolic, 0, front.columns.data(), front.inverse.data());
  std::vector<Real> x(4 * static_cast<std::size_t>(factor.paddedSize()), Real(0));
  for (int i = 0; i < 4 * size; ++i) x[i] = static_cast<Real>(noise.next());
  factor.solve(x.data());
  return x;
}

inline std::vector<float> vertexNormals(const kernels::Surface& surface) {
  const int n = static_cast<int>(surface.xyz.size() / 3);
  std::vector<int> group(n), placeOf(n);
  std::vector<float> places(4 * static_cast<std::size_t>(n)), positions, normals;
  for (int v = 0; v < n; ++v) {
    group[v] = v / 2, placeOf[v] = (n - 1) / 2 - v / 2;  // copies of one vertex
    for (int k = 0; k < 3; ++k)
      places[4 * static_cast<std::size_t>(placeOf[v]) + k] =
          static_cast<float>(surface.xyz[3 * static_cast<std::size_t>(v) + k]);
  }
  const VertexNormals shading(surface.faces, group, (n + 1) / 2, placeOf);
  VertexNormals::Scratch sums;
  shading.draw(places, Vec3::Zero(), sums, positions, normals);
  return normals;
}

}  // namespace shapespline::kernelRuns
