// Compares the kernels over faces and vertices with plain implementations of their formulas.
#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/lri/face_frame.h"
#include "core/mesh/vertex_normals.h"
#include "core/reconstruct/face_kernel.h"
#include "core/rotation/rotation.h"
#include "laplacian_meshes.h"

namespace shapespline::test::kernels_test {

namespace {

// A bumpy sheet whose number of faces is not a multiple of the block size.
PlainMesh sheet() {
  PlainMesh mesh;
  Random random(1);
  constexpr int size = 12;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      mesh.positions.push_back(
          {x + 0.2 * random.signedUnit(), y + 0.2 * random.signedUnit(), 0.5 * random.signedUnit()});
  for (int y = 0; y + 1 < size; ++y)
    for (int x = 0; x + 1 < size; ++x) {
      const int a = y * size + x;
      mesh.faces.push_back({a, a + 1, a + size});
      if (x + y > 0) mesh.faces.push_back({a + 1, a + size + 1, a + size});
    }
  return mesh;
}

// Weights of three columns, all keys, and the end key from which the curve continues, or -1.
struct Blend {
  std::vector<double> weights = {0.4, 0.9, -0.3};
  int beyond = -1;
};

constexpr int columns = 3;

// Random coordinates on the sheet, one frame per three faces; some faces have none. In the first column all faces rest.
template <class Real>
struct Coordinates {
  PlainMesh mesh = sheet();
  Stretch stretch;
  std::vector<int> localFrameOf;
  std::vector<Mat3> frames;
  FaceCoordinates<Real> numbers;

  // largestTurn: in radians.
  Coordinates(double largestTurn, Stretch how)
      : stretch(how), numbers(static_cast<int>(mesh.faces.size()), columns, static_cast<Real>(atRest())) {
    const int faceCount = static_cast<int>(mesh.faces.size());
    for (int f = 0; f < faceCount; ++f) localFrameOf.push_back(f % 7 == 3 ? -1 : f / 3);
    Random random(2);
    numbers.store();
    for (int f = 0; f < faceCount; ++f)
      for (int c = 1; c < columns; ++c) {
        for (int k = 0; k < 3; ++k) numbers.set(f, c, k, static_cast<Real>(largestTurn * random.signedUnit()));
        numbers.set(f, c, 3, static_cast<Real>(atRest() + 0.2 * random.signedUnit()));
        numbers.set(f, c, 4, static_cast<Real>(0.2 * random.signedUnit()));
        numbers.set(f, c, 5, static_cast<Real>(atRest() + 0.2 * random.signedUnit()));
      }
    numbers.dropIfAtRest(0);
    for (int i = 0; i <= faceCount / 3; ++i) {
      Mat3 frame;
      for (double& x : frame.reshaped()) x = static_cast<double>(static_cast<Real>(random.signedUnit()));
      frames.push_back(frame);
    }
  }

  double atRest() const { return stretch == Stretch::Log ? 0 : 1; }

  Mat2 stretchOf(int face, int column) const {
    const auto at = [&](int k) { return static_cast<double>(numbers.at(face, column, k)); };
    Mat2 m;
    m << at(3), at(4), at(4), at(5);
    return m;
  }
};

struct RightHandSide {
  Positions at;  // per vertex
  IndefiniteFaces indefinite;
};

template <class Real>
RightHandSide byKernel(Coordinates<Real> coordinates, const Blend& blend) {
  WeldedShape shape;
  shape.faces = coordinates.mesh.faces;
  shape.keys = 1;
  shape.poses = {coordinates.mesh.positions};
  const int n = shape.vertexCount();
  std::vector<int> position(n);
  for (int v = 0; v < n; ++v) position[v] = n - 1 - v;
  const FaceKernel<Real> kernel(shape, {}, coordinates.localFrameOf, coordinates.stretch, position, n);
  coordinates.numbers.reorder(kernel.order());
  std::vector<Real> frames;
  for (const Mat3& frame : coordinates.frames)
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) frames.push_back(static_cast<Real>(frame(r, c)));
      frames.push_back(0);
    }
  std::vector<Real> sums(4 * (static_cast<std::size_t>(n) + 1), Real(0));
  RightHandSide result;
  const PoseWeights weights{.column = blend.weights, .keys = columns, .beyond = blend.beyond};
  result.indefinite = kernel.accumulate(coordinates.numbers, {.frames = frames.data()},
                                        coordinates.numbers.weights(weights), sums.data());
  for (int v = 0; v < n; ++v) {
    const Real* const at = &sums[4 * static_cast<std::size_t>(position[v])];
    result.at.emplace_back(at[0], at[1], at[2]);
  }
  return result;
}

// The largest u >= 0 for which u A + D is singular, or 0 if none exists.
double nearness(const Mat2& a, const Mat2& d) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat2> solver(-d, a);
  return std::max(solver.eigenvalues().maxCoeff(), 0.0);
}

// The stretch beyond the keys: the change from the end key eases before 1.5 times the range of the keys.
template <class Real>
Mat2 beyondKeys(const Coordinates<Real>& coordinates, int face, const Mat2& end, const Mat2& change) {
  const bool isLog = coordinates.stretch == Stretch::Log;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (int c = 0; c < columns; ++c) {
    const Eigen::SelfAdjointEigenSolver<Mat2> eigen(coordinates.stretchOf(face, c));
    low = std::min(low, eigen.eigenvalues().minCoeff()), high = std::max(high, eigen.eigenvalues().maxCoeff());
  }
  const Mat2 one = Mat2::Identity();
  double u = nearness(end - (isLog ? low - std::log(1.5) : low / 1.5) * one, change);
  if (isLog) u = std::max(u, nearness((high + std::log(1.5)) * one - end, -change));
  return end + std::pow(1 + std::pow(u, 4), -0.25) * change;
}

// Per face: area times frame exp(r) [t1 t2] S times the gradient of each corner's hat function.
template <class Real>
RightHandSide byFormula(const Coordinates<Real>& coordinates, const Blend& blend) {
  RightHandSide result;
  result.at.assign(coordinates.mesh.positions.size(), Vec3::Zero());
  const Positions& p = coordinates.mesh.positions;
  for (std::size_t i = 0; i < coordinates.localFrameOf.size(); ++i) {
    const int f = static_cast<int>(i);
    Vec3 r = Vec3::Zero();
    Mat2 s = Mat2::Zero();
    for (int c = 0; c < columns; ++c) {
      r += blend.weights[c] * coordinates.numbers.rotation(f, c);
      s += blend.weights[c] * coordinates.stretchOf(f, c);
    }
    if (blend.beyond >= 0) {
      const Mat2 end = coordinates.stretchOf(f, blend.beyond);
      s = beyondKeys(coordinates, f, end, s - end);
    }
    if (coordinates.stretch == Stretch::Log) s = expSymmetric(s);
    else if (!(s.determinant() > 0 && s.trace() > 0)) ++result.indefinite.count;
    if (coordinates.localFrameOf[f] < 0) continue;
    const Triangle& t = coordinates.mesh.faces[f];
    const FaceFrame frame = faceFrame(p[t[0]], p[t[1]], p[t[2]]);
    const Mat2 gradients = frame.edges.inverse().transpose();  // columns: corners 1 and 2
    const Eigen::Matrix<double, 3, 2> moved =
        frame.area * coordinates.frames[coordinates.localFrameOf[f]] * expRotation(r) * frame.basis.leftCols<2>() * s;
    result.at[t[1]] += moved * gradients.col(0);
    result.at[t[2]] += moved * gradients.col(1);
    result.at[t[0]] -= moved * gradients.rowwise().sum();
  }
  return result;
}

// Relative to the extent.
double largestDifference(const Positions& a, const Positions& b) {
  double largest = 0, extent = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    largest = std::max(largest, (a[v] - b[v]).cwiseAbs().maxCoeff());
    extent = std::max(extent, b[v].cwiseAbs().maxCoeff());
  }
  return std::isfinite(largest) ? largest / extent : std::numeric_limits<double>::infinity();
}

template <class Real>
constexpr double tolerance = std::is_same_v<Real, float> ? 4e-6 : 1e-13;

Positions normalsOf(const PlainMesh& mesh) {
  const int n = static_cast<int>(mesh.positions.size());
  std::vector<int> group(n), slotOf(n);
  std::vector<float> places(4 * static_cast<std::size_t>(n)), positions, normals;
  for (int v = 0; v < n; ++v) {
    group[v] = v / 2, slotOf[v] = (n - 1) / 2 - v / 2;  // pairs of vertices are copies of one vertex
    for (int k = 0; k < 3; ++k)
      places[4 * static_cast<std::size_t>(slotOf[v]) + k] = static_cast<float>(mesh.positions[v][k]);
  }
  const VertexNormals shading(mesh.faces, group, (n + 1) / 2, slotOf);
  VertexNormals::Scratch sums;
  shading.draw(places, Vec3::Zero(), sums, positions, normals);
  Positions result;
  for (int v = 0; v < n; ++v) result.emplace_back(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
  return result;
}

// Normals by sums in double. Copies use the position of the last one.
Positions plainNormals(const PlainMesh& mesh) {
  const int n = static_cast<int>(mesh.positions.size());
  Positions sums((n + 1) / 2, Vec3::Zero()), result;
  const auto at = [&](int v) { return mesh.positions[std::min(v | 1, n - 1)]; };
  for (const Triangle& t : mesh.faces) {
    const Vec3 normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    for (const int v : t) sums[v / 2] += normal;
  }
  for (int v = 0; v < n; ++v) result.push_back(sums[v / 2].normalized());
  return result;
}

}  // namespace

TEST_CASE_TEMPLATE("kernels: right-hand sides are the divergence of R_f S_f", Real, float, double) {
  for (const Stretch stretch : {Stretch::Linear, Stretch::Log})
    // few terms (twice), all terms, the end of the series, beyond the series
    for (const double largestTurn : {0.1, 0.28, 1.0, 3.0, 12.0}) {
      CAPTURE(largestTurn);
      const Coordinates<Real> coordinates(largestTurn, stretch);
      const RightHandSide kernel = byKernel(coordinates, {}), formula = byFormula(coordinates, {});
      CHECK(largestDifference(kernel.at, formula.at) < tolerance<Real>);
      CHECK(kernel.indefinite.count == formula.indefinite.count);
    }
}

// Continues from the key at rest and from a stored key, by a short and a long distance.
TEST_CASE_TEMPLATE("kernels: right-hand sides beyond the keys are limited, and no face is indefinite", Real, float,
                   double) {
  for (const Stretch stretch : {Stretch::Linear, Stretch::Log})
    for (const Blend& blend : {Blend{{1.1, -0.3, 0.2}, 0}, {{11, -13, 3}, 0}, {{0.2, -0.3, 1.1}, 2}, {{-9, 4, 6}, 2}}) {
      CAPTURE(blend.weights[0]);
      const Coordinates<Real> coordinates(1.0, stretch);
      const RightHandSide kernel = byKernel(coordinates, blend);
      CHECK(largestDifference(kernel.at, byFormula(coordinates, blend).at) < 10 * tolerance<Real>);
      CHECK(kernel.indefinite.count == 0);
      CHECK(kernel.at != byKernel(coordinates, {blend.weights, -1}).at);
    }
}

TEST_CASE("kernels: indefinite faces are counted, and one of them is named") {
  const Coordinates<double> coordinates(0.1, Stretch::Linear);
  const Blend blend{{1, -3, 3}, -1};
  const RightHandSide kernel = byKernel(coordinates, blend), formula = byFormula(coordinates, blend);
  CHECK(formula.indefinite.count > 0);
  CHECK(kernel.indefinite.count == formula.indefinite.count);
  CHECK(kernel.indefinite.slot >= 0);
}

TEST_CASE("kernels: normals are area-weighted, and unit vectors at every scale") {
  PlainMesh mesh = sheet();
  const Positions normals = normalsOf(mesh), plain = plainNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    CHECK((normals[v] - plain[v]).norm() < 1e-5);
    CHECK(normals[v].norm() == doctest::Approx(1).epsilon(1e-6));
  }
  PlainMesh tiny = mesh;
  for (Vec3& p : tiny.positions) p *= 1e-15;  // squared areas exceed the range of float
  const Positions same = normalsOf(tiny);
  for (std::size_t v = 0; v < normals.size(); ++v) CHECK((same[v] - normals[v]).norm() < 1e-4);
  for (Vec3& p : mesh.positions) p = Vec3::Ones();
  for (const Vec3& up : normalsOf(mesh)) CHECK(up == Vec3::UnitZ());
}

TEST_CASE("kernels: a column in which every face rests is not stored, any other is") {
  FaceCoordinates<float> coordinates(6, 3, 1.0f);
  coordinates.store();
  for (int f = 0; f < 6; ++f) coordinates.set(f, 1, 0, 0.1f * static_cast<float>(f)), coordinates.set(f, 2, 3, 2.0f);
  coordinates.dropIfAtRest(1);
  CHECK(coordinates.weights({.column = {0.25, 0.5, 0.25}}).stored.size() == 3);
  coordinates.dropIfAtRest(0);
  const auto weights = coordinates.weights({.column = {0.25, 0.5, 0.25}});
  REQUIRE(weights.stored.size() == 2);
  CHECK(weights.lanes[0] == 0.5f);
  CHECK(weights.lanes[faceLanes] == 0.25f);
  CHECK(weights.lanes[2 * faceLanes] == 0.25f);  // at rest
  coordinates.reorder({5, 3, 1, 0, 2, 4});
  for (int f = 0; f < 6; ++f) {
    CHECK(coordinates.at(f, 0, 0) == 0.0f);
    CHECK(coordinates.at(f, 0, 5) == 1.0f);
    CHECK(coordinates.at(f, 1, 0) == 0.1f * static_cast<float>(f));
    CHECK(coordinates.at(f, 2, 3) == 2.0f);
  }
}

TEST_CASE("kernels: columns with a weight below the precision are omitted, and the others keep their positions") {
  const PoseWeights weights{.column = {1e-3, 1e-9, -1e-10, 0.5, 1e-19, 0.499}, .keys = 6};
  FaceCoordinates<float> single(4, 6, 1.0f);
  FaceCoordinates<double> full(4, 6, 1.0);
  single.store(), full.store();
  CHECK(single.weights(weights).stored == std::vector<int>{0, 3, 5});
  CHECK(full.weights(weights).stored == std::vector<int>{0, 1, 2, 3, 5});
}

TEST_CASE("kernels: a spline blend of many columns equals the complete one, up to a rounding step") {
  // With each key farther from t, weights shrink to 0.27 of their value.
  std::vector<double> weights(100);
  double sum = 0;
  for (int c = 0; c < 100; ++c) sum += weights[c] = std::pow(-0.27, std::abs(c - 40));
  for (double& w : weights) w /= sum;
  FaceCoordinates<float> coordinates(1, 100, 1.0f);
  coordinates.store();
  const auto list = coordinates.weights({.column = weights, .keys = 100});
  CHECK(list.stored.size() < 40);
  CHECK(list.stored.size() > 20);
  double left = 0;
  for (const double w : weights) left += std::abs(w);
  for (const int column : list.stored) left -= std::abs(weights[column]);
  CHECK(10 * left < 6e-8);  // for numbers of size ten, half a rounding step of a sum of size one
}

}  // namespace shapespline::test::kernels_test
