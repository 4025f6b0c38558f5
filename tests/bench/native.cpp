// shapespline_bench_native FILE.glb REFERENCE T...: the file's second system, native, as lines of JSON on stdout. The
// shape at the k-th time, computed in double, is written to REFERENCE followed by k, from 0 on: 3 doubles a vertex. The
// first line has our own solver in both precisions; then each line on stdin asks for a whole solution by
// Eigen, until stdin ends.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/base/stopwatch.h"
#include "core/lri/welded_shape.h"
#include "core/mesh/canonical_order.h"
#include "core/mesh/weld.h"
#include "core/reconstruct/poisson.h"
#include "core/sequence/sequence.h"
#include "core/sparse/cholesky.h"
#include "io/import.h"

using namespace shapespline;

namespace {

constexpr int repeats = 5;
constexpr double longEnoughMs = 3000;  // no further repetition of what has taken so long

std::vector<std::uint8_t> bytesOf(const char* name) {
  std::vector<std::uint8_t> bytes;
  std::FILE* file = std::fopen(name, "rb");
  if (!file) return bytes;
  std::uint8_t buffer[1 << 16];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
    bytes.insert(bytes.end(), buffer, buffer + n);
  std::fclose(file);
  return bytes;
}

template <class Work>
double medianMs(Work work) {
  std::vector<double> ms;
  double sum = 0;
  while (static_cast<int>(ms.size()) < repeats && sum < longEnoughMs) {
    Stopwatch watch;
    work();
    ms.push_back(watch.lap());
    sum += ms.back();
  }
  std::sort(ms.begin(), ms.end());
  return ms[ms.size() / 2];
}

// The reference pose's system, as Sequence makes it.
CotangentLaplacian laplacianOf(const Keyframes& keyframes) {
  std::vector<const Positions*> poses;
  for (const Key& key : keyframes.keys) poses.push_back(&key.positions);
  const Welding welding = weld(poses, weldTolerances(poses));
  WeldedShape shape;
  shape.keys = keyframes.keyCount();
  shape.faces = weldFaces(keyframes.faces, welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, welding));
  const MeshOrder order = canonicalOrder(shape.faces, shape.poses);
  shape.faces = order.apply(shape.faces);
  for (Positions& pose : shape.poses) pose = order.apply(pose);
  const ShapeTopology parts = topologyOf(shape);
  return cotangentLaplacian(shape.faces, parts.hasArea, parts.components, shape.poses[0]);
}

// Whose solution is known: the places of the vertices.
struct KnownSystem {
  Eigen::SparseMatrix<double> matrix;  // lower triangle
  Eigen::MatrixX3d places, b;
};

Eigen::SparseMatrix<double> lowerTriangle(const SymmetricMatrix& matrix) {
  using Map = Eigen::Map<const Eigen::SparseMatrix<double>>;
  return Map(matrix.size, matrix.size, static_cast<Eigen::Index>(matrix.row.size()), matrix.columnStart.data(),
             matrix.row.data(), matrix.value.data());
}

KnownSystem knownSystemOf(const CotangentLaplacian& laplacian) {
  KnownSystem system;
  system.matrix = lowerTriangle(laplacian.matrix);
  system.places.resize(laplacian.matrix.size, 3);
  for (Eigen::Index i = 0; i < system.places.rows(); ++i) system.places.row(i) = laplacian.coordinates[i];
  system.b = system.matrix.selfadjointView<Eigen::Lower>() * system.places;
  return system;
}

// Largest distance to the places that the right-hand side was made from, over the diagonal of their bounding box.
double errorOf(const Eigen::MatrixX3d& solution, const Eigen::MatrixX3d& places) {
  const double diagonal = (places.colwise().maxCoeff() - places.colwise().minCoeff()).norm();
  return (solution - places).rowwise().norm().maxCoeff() / diagonal;
}

template <class Real>
Eigen::MatrixX3d solveOwn(const Cholesky& cholesky, const Eigen::MatrixX3d& b, double& ms) {
  const auto position = cholesky.eliminationPosition();
  std::vector<Real, Eigen::aligned_allocator<Real>> start(4 * static_cast<std::size_t>(cholesky.paddedSize()), Real(0)),
      x;
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) start[4 * static_cast<std::size_t>(position[i]) + k] = static_cast<Real>(b(i, k));
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    x = start;
    Stopwatch watch;
    cholesky.solve(x.data());
    times.push_back(watch.lap());
  }
  std::sort(times.begin(), times.end());
  ms = times[times.size() / 2];
  Eigen::MatrixX3d result(b.rows(), 3);
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = x[4 * static_cast<std::size_t>(position[i]) + k];
  return result;
}

bool benchOwn(const CotangentLaplacian& laplacian, const KnownSystem& system) {
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    Cholesky own;
    Stopwatch watch;
    if (!own.analyse(laplacian.matrix, laplacian.coordinates, precision)) return false;
    const double orderMs = watch.lap();
    bool good = true;
    const double factorMs = medianMs([&] { good = good && own.factorise(laplacian.matrix).ok(); });
    if (!good) return false;
    double solveMs = 0;
    const bool isSingle = precision == Precision::Single;
    const Eigen::MatrixX3d x =
        isSingle ? solveOwn<float>(own, system.b, solveMs) : solveOwn<double>(own, system.b, solveMs);
    std::printf(",\"%s\":{\"orderMs\":%.3f,\"factorMs\":%.3f,\"solveMs\":%.4f,\"error\":%.3g}",
                isSingle ? "single" : "double", orderMs, factorMs, solveMs, errorOf(x, system.places));
  }
  return true;
}

using EigenSolver = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>;

bool solveByEigen(const KnownSystem& system) {
  EigenSolver eigen;
  Stopwatch watch;
  eigen.analyzePattern(system.matrix);
  const double orderMs = watch.lap();
  const double factorMs = medianMs([&] { eigen.factorize(system.matrix); });
  if (eigen.info() != Eigen::Success) return false;
  Eigen::MatrixX3d x;
  const double solveMs = medianMs([&] { x = eigen.solve(system.b); });
  std::printf("{\"orderMs\":%.3f,\"factorMs\":%.3f,\"solveMs\":%.4f,\"error\":%.3g}\n", orderMs, factorMs, solveMs,
              errorOf(x, system.places));
  return std::fflush(stdout) == 0;
}

bool writeShape(const Positions& positions, const std::string& name) {
  std::FILE* file = std::fopen(name.c_str(), "wb");
  if (!file) return false;
  const bool written = std::fwrite(positions.data(), sizeof(Vec3), positions.size(), file) == positions.size();
  return std::fclose(file) == 0 && written;
}

bool writeReferences(Keyframes keyframes, const std::string& name, std::span<const double> times) {
  EncodingOptions encoding;
  encoding.precision = Precision::Double;
  auto sequence = Sequence::create(std::move(keyframes), encoding, {});
  if (!sequence) return false;
  Positions positions;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (!sequence->evaluate(times[k], positions) || !writeShape(positions, name + std::to_string(k))) return false;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: shapespline_bench_native FILE.glb REFERENCE T...\n");
    return 2;
  }
  const auto failed = [&](const char* why) {
    std::fprintf(stderr, "%s: %s\n", argv[1], why);
    return 1;
  };
  const std::vector<std::uint8_t> bytes = bytesOf(argv[1]);
  const NamedBytes file{argv[1], bytes};
  auto import = importKeyframes({&file, 1}, {});
  if (!import) return failed(import.error().message.c_str());
  const CotangentLaplacian laplacian = laplacianOf(import->keyframes);
  const KnownSystem system = knownSystemOf(laplacian);
  std::printf("{\"unknowns\":%d", laplacian.matrix.size);
  if (!benchOwn(laplacian, system)) return failed("the system cannot be factorised");
  std::printf("}\n");
  std::vector<double> times;
  for (int i = 3; i < argc; ++i) times.push_back(std::atof(argv[i]));
  if (!writeReferences(std::move(import->keyframes), argv[2], times)) return failed("the reference cannot be written");
  std::fflush(stdout);
  for (int c; (c = std::getchar()) != EOF;)
    if (c == '\n' && !solveByEigen(system)) return failed("Eigen cannot factorise the system");
  return 0;
}
