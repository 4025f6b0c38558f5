// Two threads must give the same bits as one: solve, right-hand side, normals. Also runs under ThreadSanitizer.
#include "helper_thread.h"

#if SHAPESPLINE_THREADS

#include <doctest/doctest.h>

#include <numeric>
#include <vector>

#include "core/mesh/vertex_normals.h"
#include "core/reconstruct/face_kernel.h"
#include "core/sparse/cholesky.h"
#include "laplacian_meshes.h"

namespace shapespline::test::kernels_in_two_test {

namespace {

PlainMesh sheet() {
  Random random(1);
  return irregularSheet(40, 30, random);
}

std::vector<int> ascending(std::size_t count) {
  std::vector<int> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

// Checks run(forkJoin) with and without a helper. On a busy machine the helper may be late, so the check repeats until
// it has helped.
template <class Run>
void checkSameBits(const Run& run) {
  const auto alone = run(nullptr);
  ForkJoin forkJoin;
  const HelperThread helper(forkJoin);
  bool same = true;
  for (int i = 0; i < 20000 && (i < 20 || forkJoin.helped() < 10); ++i) same = same && run(&forkJoin) == alone;
  CHECK(same);
  CHECK(forkJoin.helped() >= 10);
}

template <class Real>
std::vector<Real> solution(const Cholesky& cholesky, ForkJoin* forkJoin) {
  Random random(3);
  std::vector<Real> x(4 * static_cast<std::size_t>(cholesky.paddedSize()), Real(0));
  for (const int i : cholesky.eliminationPosition())
    for (int k = 0; k < 3; ++k) x[4 * static_cast<std::size_t>(i) + k] = static_cast<Real>(random.signedUnit());
  cholesky.solve(x.data(), forkJoin);
  x.resize(4 * cholesky.eliminationPosition().size());
  return x;
}

template <class Real>
std::vector<Real> rightHandSide(const FaceKernel<Real>& kernel, const FaceCoordinates<Real>& coordinates, int vertices,
                                ForkJoin* forkJoin) {
  std::vector<Real> frame = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::vector<Real> sums(4 * (static_cast<std::size_t>(vertices) + 1), Real(0));
  const auto weights = coordinates.weights({.column = {0.7, 0.3}, .keys = 2});
  kernel.accumulate(coordinates, {.frames = frame.data()}, weights, sums.data(), forkJoin);
  return sums;
}

}  // namespace

TEST_CASE_TEMPLATE("in two: a solve", Real, float, double) {
  const PlainMesh mesh = sheet();
  const SymmetricMatrix matrix = pinnedLaplacian(mesh);
  Cholesky cholesky;
  REQUIRE(cholesky.analyse(matrix, mesh.positions, sizeof(Real) == 4 ? Precision::Single : Precision::Double).ok());
  REQUIRE(cholesky.factorise(matrix).ok());
  checkSameBits([&](ForkJoin* forkJoin) { return solution<Real>(cholesky, forkJoin); });
}

TEST_CASE_TEMPLATE("in two: the right-hand side of faces", Real, float, double) {
  const PlainMesh mesh = sheet();
  WeldedShape shape;
  shape.faces = mesh.faces;
  shape.keys = 1;
  shape.poses = {mesh.positions};
  const int faces = shape.faceCount(), vertices = shape.vertexCount();
  const FaceKernel<Real> kernel(shape, {}, std::vector<int>(faces, 0), Stretch::Linear,
                                ascending(mesh.positions.size()), vertices);
  FaceCoordinates<Real> coordinates(faces, 2, Real(1));
  coordinates.store();
  Random random(2);
  for (int f = 0; f < faces; ++f)
    for (int c = 0; c < 2; ++c)
      for (int k = 0; k < 6; ++k)
        coordinates.set(f, c, k, static_cast<Real>((k == 3 || k == 5 ? 1 : 0) + 0.1 * random.signedUnit()));
  coordinates.reorder(kernel.order());
  checkSameBits([&](ForkJoin* forkJoin) { return rightHandSide(kernel, coordinates, vertices, forkJoin); });
}

TEST_CASE("in two: normals of vertices") {
  const PlainMesh mesh = sheet();
  const std::vector<int> own = ascending(mesh.positions.size());
  const VertexNormals drawing(mesh.faces, own, static_cast<int>(own.size()), own);
  std::vector<float> places;
  for (const Vec3& p : mesh.positions)
    for (const double x : {p.x(), p.y(), p.z(), 0.0}) places.push_back(static_cast<float>(x));
  checkSameBits([&](ForkJoin* forkJoin) {
    VertexNormals::Scratch scratch;
    std::vector<float> positions, normals;
    drawing.draw(places, Vec3(1, 2, 3), scratch, positions, normals, forkJoin);
    positions.insert(positions.end(), normals.begin(), normals.end());
    return positions;
  });
}

}  // namespace shapespline::test::kernels_in_two_test

#endif
