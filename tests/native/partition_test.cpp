// The partition of large meshes, which starts with clusters of faces.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "core/patches/face_clusters.h"
#include "core/patches/patch_coordinates.h"
#include "core/sequence/weld_keys.h"
#include "shapes.h"
#include "shapes/bench_mesh.h"
#include "shapes/bench_parts.h"

namespace shapespline::test::partition_test {

namespace {

constexpr int largeFaces = 64000;

struct Partitioned {
  WeldedShape shape;
  ShapeTopology topology;
  Patches patches;
};

Partitioned partitioned(Keyframes keys) {
  auto welded = weldKeys(std::move(keys), {});
  REQUIRE(welded.ok());
  Partitioned result{std::move(welded->shape), {}, {}};
  result.topology = topologyOf(result.shape, {});
  auto coordinates = encodePatches(result.shape, result.topology, 0);
  REQUIRE(coordinates.ok());
  result.patches = std::move(coordinates->patches);
  return result;
}

// Number of connected pieces formed by the faces of each label.
int piecesOf(const FaceGraph& graph, const std::vector<int>& label) {
  std::vector<char> met(label.size(), 0);
  int pieces = 0;
  for (int f = 0; f < static_cast<int>(label.size()); ++f) {
    if (met[f] || label[f] < 0) continue;
    ++pieces;
    std::queue<int> queue;
    const auto meet = [&](int g) {
      if (!met[g]) met[g] = 1, queue.push(g);
    };
    for (meet(f); !queue.empty(); queue.pop())
      for (const int g : graph.of(queue.front()))
        if (label[g] == label[f]) meet(g);
  }
  return pieces;
}

void checkPartition(const Partitioned& p) {
  const int used = p.topology.usedFaces();
  CHECK(piecesOf(p.topology.graph, p.patches.ofFace) == p.patches.count);
  CHECK(std::abs(p.patches.count - defaultPatchCount(used)) <= p.topology.components.count);
  std::vector<int> faces(p.patches.count, 0);
  for (std::size_t f = 0; f < p.patches.ofFace.size(); ++f) {
    const int patch = p.patches.ofFace[f];
    REQUIRE((patch >= 0) == (p.topology.turns[f] != 0));
    if (patch < 0) continue;
    ++faces[patch];
    REQUIRE(p.patches.componentOf[patch] == p.topology.components.ofFace[f]);
  }
  const double mean = static_cast<double>(used) / p.patches.count;
  CHECK(*std::max_element(faces.begin(), faces.end()) < 6 * mean);
  CHECK(*std::min_element(faces.begin(), faces.end()) > 0);
}

}  // namespace

TEST_CASE("partition: patches of a large mesh are connected, in the requested number, each within one component") {
  checkPartition(partitioned(makeBenchKeyframes(largeFaces, 3, 1)));
  checkPartition(partitioned(makeBenchParts(largeFaces, 3, 1)));
}

TEST_CASE("partition: a common rigid motion of all keys changes no patch of a large mesh") {
  Keyframes keys = makeBenchKeyframes(largeFaces, 3, 1);
  const std::vector<int> before = partitioned(keys).patches.ofFace;
  const Map moved = turn(Vec3(1, 2, 3), 0.7, Vec3(0.3, -2, 5));
  for (Key& key : keys.keys) key.positions = mapped(key.positions, moved);
  CHECK(partitioned(std::move(keys)).patches.ofFace == before);
}

TEST_CASE("clusters: connected, with few faces each, and the sums over their faces") {
  const Partitioned p = partitioned(makeBenchParts(6000, 3, 1));
  const int faces = p.shape.faceCount();
  std::vector<double> area(faces, 0);
  Positions centroid(faces, Vec3::Zero());
  const FaceRotations rotations(faces, 2);
  for (int f = 0; f < faces; ++f) area[f] = 1 + f % 3, centroid[f] = centroidOf(p.shape.poses[0], p.shape.faces[f]);
  const PatchInput input{p.topology.graph, p.topology.components, area, centroid, rotations, 2};
  const FaceClusters clusters = clusterFaces(input, 8);
  const int used = static_cast<int>(clusters.member.size());
  CHECK(used == p.topology.usedFaces());
  CHECK(piecesOf(p.topology.graph, clusters.ofFace) == clusters.count());
  CHECK(used > 4 * clusters.count());
  std::vector<double> sum(clusters.count(), 0);
  std::vector<int> size(clusters.count(), 0);
  for (int f = 0; f < faces; ++f) {
    const int c = clusters.ofFace[f];
    if (c < 0) continue;
    sum[c] += area[f], ++size[c];
    REQUIRE(clusters.components.ofFace[c] == p.topology.components.ofFace[f]);
    for (const int g : p.topology.graph.of(f)) {
      const int other = clusters.ofFace[g];
      const auto neighbours = clusters.graph.of(c);
      REQUIRE((other == c || std::find(neighbours.begin(), neighbours.end(), other) != neighbours.end()));
    }
  }
  CHECK(sum == clusters.area);
  CHECK(*std::max_element(size.begin(), size.end()) <= 8);
  for (int c = 0; c < clusters.count(); ++c)
    CHECK(clusters.rotations.of(c)->angularDistance(Quaternion::Identity()) < 1e-12);
}

}  // namespace shapespline::test::partition_test
