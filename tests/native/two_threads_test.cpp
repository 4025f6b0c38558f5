// Splitting work in two, and bitwise equality of whole frames with those of one thread.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/mesh/face_order.h"
#include "core/sequence/sequence.h"
#include "core/sparse/graph.h"
#include "core/sparse/ordering.h"
#include "core/sparse/subtree_partition.h"
#include "helper_thread.h"
#include "laplacian_meshes.h"
#include "shapes.h"
#include "shapes/bench_mesh.h"

namespace shapespline::test::two_threads_test {

namespace {

SymbolicFactor factorOf(const PlainMesh& mesh) {
  const Graph graph = graphOf(pinnedLaplacian(mesh));
  return analyseFactor(graph, fillReducingOrder(graph, mesh.positions));
}

}  // namespace

TEST_CASE("tree cut: the parts have no common column and share rows only in the top") {
  Random random(3);
  PlainMesh two = bumpySphere(20, random);
  const PlainMesh other = irregularSheet(31, 30, random);
  const int offset = static_cast<int>(two.positions.size());
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& f : other.faces) two.faces.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  for (const PlainMesh& mesh : {bumpySphere(2, random), irregularSheet(61, 47, random), two}) {
    const SymbolicFactor factor = factorOf(mesh);
    const std::vector<int> part = cutTree(factor);
    std::vector<int> partOfColumn(factor.size());
    for (int s = 0; s < factor.supernodes(); ++s)
      std::fill(partOfColumn.begin() + factor.first[s], partOfColumn.begin() + factor.first[s + 1], part[s]);
    bool apart = true;
    for (int s = 0; s < factor.supernodes(); ++s)
      for (int r = 0; r < factor.rows(s); ++r) {
        const int row = partOfColumn[factor.rowsOf(s)[r]];
        apart = apart && (row == topPart || row == part[s]);
      }
    CHECK(apart);
  }
}

TEST_CASE("tree cut: two threads have less than two thirds of the work of one") {
  Random random(4);
  const SymbolicFactor factor = factorOf(bumpySphere(66, random));  // 43,562 vertices
  const std::vector<int> part = cutTree(factor);
  std::array<double, 3> work = {};
  for (int s = 0; s < factor.supernodes(); ++s)
    work[part[s]] += factor.columns(s) * (0.5 * factor.columns(s) + factor.rows(s));
  const auto [first, second, top] = work;
  CHECK(std::max(first, second) + top < 2.0 / 3 * (first + second + top));
}

TEST_CASE("face order: every face once, sorted by its last corner, no corner in both halves, complete groups of four") {
  Random random(5);
  const PlainMesh mesh = irregularSheet(23, 17, random);
  const int count = static_cast<int>(mesh.positions.size()), faces = static_cast<int>(mesh.faces.size());
  for (const int shared : {-1, 40}) {
    const FaceOrder ordered = orderFaces(mesh.faces, count, shared);
    const auto& [first, second, rest] = ordered.ranges;
    CHECK((first.begin == 0 && second.begin == first.end && rest.begin == second.end && rest.end == faces));
    CHECK(std::max(first.end, second.end - second.begin) + rest.end - rest.begin < 2.0 / 3 * faces);
    std::vector<int> users(count, 0);
    if (shared >= 0) users[shared] = 3;
    for (int half = 0; half < 2; ++half) {
      const auto [begin, end] = ordered.ranges[half];
      CHECK((end - begin) % 4 == 0);
      int before = 0;
      for (int i = begin; i < end; ++i) {
        const Triangle& t = mesh.faces[ordered.order[i]];
        for (int c : t) users[c] |= 1 << half;
        const int last = *std::max_element(t.begin(), t.end());
        CHECK(last >= before);
        before = last;
      }
    }
    CHECK(std::count(users.begin(), users.end(), 3) == (shared >= 0 ? 1 : 0));
    std::vector<int> sorted = ordered.order;
    std::sort(sorted.begin(), sorted.end());
    for (int f = 0; f < faces; ++f) CHECK(sorted[f] == f);
  }
}

#if SHAPESPLINE_THREADS

namespace {

Shape parts() {
  Shape shape = joined(joined(box(1, 1, 4, 5, 6, 20), sphere({0, 3, 5}, 1)), sphere({2, 0, 1}, 0.5));
  shape.faces.push_back({0, 0, 1});  // degenerate
  shape.faces.push_back(
      {3, 4, static_cast<int>(shape.positions.size())});  // no area: its third corner coincides with the second
  shape.positions.push_back(shape.positions[4]);
  shape.positions.push_back({9, 9, 9});  // unreferenced
  return shape;
}

void checkSameBits(const Keyframes& keyframes, const EncodingOptions& encoding, int wantedHelp) {
  auto sequence = Sequence::create(keyframes, encoding, {});
  REQUIRE(sequence.ok());
  ForkJoin forkJoin;
  const HelperThread helper(forkJoin);
  Frame alone, together;
  bool same = true;
  // On a busy machine the helper may be late, so frames are repeated until it has done its share.
  for (int i = 0; i < 2000 && (i < 6 || forkJoin.helped() < wantedHelp); ++i) {
    const double t = -0.2 + 0.25 * (i % 6);
    sequence->setForkJoin(nullptr);
    REQUIRE(sequence->evaluate(t, alone).ok());
    sequence->setForkJoin(&forkJoin);
    REQUIRE(sequence->evaluate(t, together).ok());
    same = same && alone.positions == together.positions && alone.normals == together.normals &&
           alone.indefiniteFaces == together.indefiniteFaces;
  }
  CHECK(same);
  CHECK(forkJoin.helped() >= wantedHelp);
}

}  // namespace

TEST_CASE("two threads give the same bits as one: parts, degenerate faces, every precision") {
  const Keyframes k = keyframes(parts(), {bend(0, 4), bend(1, 4), twist(1, 4)});
  for (const Precision precision : {Precision::Single, Precision::Exact, Precision::Double}) {
    EncodingOptions encoding;
    encoding.precision = precision;
    checkSameBits(k, encoding, 1);
  }
  EncodingOptions withGhost;
  withGhost.ghostFaces = 200;
  checkSameBits(k, withGhost, 1);
}

TEST_CASE("two threads give the same bits as one: a large mesh") {
  checkSameBits(makeBenchKeyframes(90000, 2, 1), {}, 10);
}

#endif

}  // namespace shapespline::test::two_threads_test
