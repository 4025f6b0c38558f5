// shapespline_bench_native FILE.glb REFERENCE T...: solves the file's second system natively and prints lines of JSON.
// Writes the shape at the k-th time, computed in double precision, to the file REFERENCE followed by k (from 0), 3
// doubles per vertex. The first printed line has the number of unknowns. For each line on stdin, the program then runs
// one round: our own solver in both precisions, Eigen and CHOLMOD. It ends with stdin.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/lri/welded_shape.h"
#include "core/mesh/canonical_order.h"
#include "core/mesh/weld.h"
#include "core/reconstruct/poisson.h"
#include "core/sequence/sequence.h"
#include "io/import.h"
#include "solver.h"

using namespace shapespline;
using namespace shapespline::bench;

namespace {

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

// Rounds positions to float, as an import does for the engine.
void roundToFloats(Keyframes& keyframes) {
  for (Key& key : keyframes.keys)
    for (Vec3& position : key.positions) position = position.cast<float>().cast<double>();
}

// The reference pose's system, as in Sequence.
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

void print(const char* name, const std::optional<SolverRound>& round) {
  if (!round) {
    std::printf("\"%s\":null", name);
    return;
  }
  std::printf(
      "\"%s\":{\"orderMs\":%.3f,\"factorMs\":%.3f,\"solveMs\":%.4f,\"entries\":%lld,\"bytes\":%lld,\"error\":%.3g}",
      name, round->orderMs, round->factorMs, round->solveMs, static_cast<long long>(round->entries),
      static_cast<long long>(round->bytes), round->error);
}

bool printRound(const KnownSystem& system) {
  const auto single = solveByOurs(system, Precision::Single), inDouble = solveByOurs(system, Precision::Double),
             eigen = solveByEigen(system);
  if (!single || !inDouble || !eigen) return false;
  std::printf("{"), print("single", single);
  std::printf(","), print("double", inDouble);
  std::printf(","), print("eigen", eigen);
  std::printf(","), print("cholmod", solveByCholmod(system));
  std::printf("}\n");
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
  roundToFloats(import->keyframes);
  const CotangentLaplacian laplacian = laplacianOf(import->keyframes);
  const KnownSystem system(laplacian);
  std::printf("{\"unknowns\":%d}\n", laplacian.matrix.size);
  std::vector<double> times;
  for (int i = 3; i < argc; ++i) times.push_back(std::atof(argv[i]));
  if (!writeReferences(std::move(import->keyframes), argv[2], times)) return failed("the reference cannot be written");
  std::fflush(stdout);
  for (int c; (c = std::getchar()) != EOF;)
    if (c == '\n' && !printRound(system)) return failed("the system cannot be factored");
  return 0;
}
