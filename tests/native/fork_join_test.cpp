// Two threads give the bits of one, and no helper, a late one or a dead one changes anything.
#include "core/base/fork_join.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "core/mesh/face_order.h"
#include "core/sequence/sequence.h"
#include "core/sparse/graph.h"
#include "core/sparse/ordering.h"
#include "core/sparse/subtree_partition.h"
#include "laplacian_meshes.h"
#include "samples/bench_mesh.h"
#include "shapes.h"

#if !defined(__wasm__)  // which is tested without threads here; the engine's tests have them
#define WITH_THREADS 1
#include <thread>
#endif

using namespace shapespline;
using namespace shapespline::test;

namespace {

SymbolicFactor factorOf(const testing::PlainMesh& mesh) {
  const Graph graph = graphOf(testing::pinnedLaplacian(mesh));
  return analyseFactor(graph, fillReducingOrder(graph, mesh.positions));
}

double workOf(const SymbolicFactor& factor, const std::vector<int>& part, int which) {
  double work = 0;
  for (int s = 0; s < factor.supernodes(); ++s) {
    const double columns = factor.columns(s);
    if (part[s] == which) work += columns * (columns + 1) / 2 + columns * factor.rows(s);
  }
  return work;
}

}  // namespace

TEST_CASE("tree cut: the parts have no column in common and share rows in the top alone") {
  testing::Random random(3);
  testing::PlainMesh two = testing::bumpySphere(20, random);
  const testing::PlainMesh other = testing::irregularSheet(31, 30, random);
  const int offset = static_cast<int>(two.positions.size());
  two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& f : other.faces) two.faces.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  for (const testing::PlainMesh& mesh :
       {testing::bumpySphere(2, random), testing::irregularSheet(61, 47, random), two}) {
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

TEST_CASE("tree cut: the parts of a mesh are balanced and the top is small") {
  testing::Random random(4);
  const SymbolicFactor factor = factorOf(testing::bumpySphere(66, random));  // 43,562 vertices
  const std::vector<int> part = cutTree(factor);
  const double first = workOf(factor, part, 0), second = workOf(factor, part, 1), top = workOf(factor, part, topPart);
  CHECK(std::max(first, second) < 1.1 * std::min(first, second));
  CHECK(top < 0.2 * (first + second));
}

TEST_CASE("face halves: every face once, by its last corner, no corner in both halves, whole groups of four") {
  testing::Random random(5);
  const testing::PlainMesh mesh = testing::irregularSheet(23, 17, random);
  const int count = static_cast<int>(mesh.positions.size()), faces = static_cast<int>(mesh.faces.size());
  for (const int shared : {-1, 40}) {
    const FaceHalves halves = halveFaces(mesh.faces, count, shared);
    const auto& [first, second, rest] = halves.ranges;
    CHECK((first.begin == 0 && second.begin == first.end && rest.begin == second.end && rest.end == faces));
    CHECK(rest.end - rest.begin < 0.2 * faces);
    std::vector<int> users(count, 0);
    if (shared >= 0) users[shared] = 3;
    for (int half = 0; half < 2; ++half) {
      const auto [begin, end] = halves.ranges[half];
      CHECK((end - begin) % 4 == 0);
      int before = 0;
      for (int i = begin; i < end; ++i) {
        const Triangle& t = mesh.faces[halves.order[i]];
        for (int c : t) users[c] |= 1 << half;
        const int last = *std::max_element(t.begin(), t.end());
        CHECK(last >= before);
        before = last;
      }
    }
    CHECK(std::count(users.begin(), users.end(), 3) == (shared >= 0 ? 1 : 0));
    std::vector<int> sorted = halves.order;
    std::sort(sorted.begin(), sorted.end());
    for (int f = 0; f < faces; ++f) CHECK(sorted[f] == f);
  }
}

TEST_CASE("forkJoin: without a helper all is done by the caller") {
  ForkJoin forkJoin;
  std::array<int, 2> done = {0, 0};
  for (ForkJoin* someone : {&forkJoin, static_cast<ForkJoin*>(nullptr)})
    inTwo(someone, [&](int part) { ++done[part]; });
  CHECK(done == std::array{2, 2});
  CHECK(forkJoin.helped() == 0);
}

#if WITH_THREADS

namespace {

// A helper for as long as it lives.
class Helper {
 public:
  explicit Helper(ForkJoin& forkJoin)
      : forkJoin_(forkJoin), thread_([&forkJoin] {
          try {
            forkJoin.serve();
          } catch (const std::exception&) {
            forkJoin.breakDown();
          }
        }) {}
  ~Helper() {
    forkJoin_.dismiss();
    thread_.join();
  }

 private:
  ForkJoin& forkJoin_;
  std::thread thread_;
};

Shape parts() {
  Shape shape = joined(joined(box(1, 1, 4, 5, 6, 20), sphere({0, 3, 5}, 1)), sphere({2, 0, 1}, 0.5));
  shape.faces.push_back({0, 0, 1});  // degenerate
  shape.faces.push_back(
      {3, 4, static_cast<int>(shape.positions.size())});  // of no area: its third corner lies on the second
  shape.positions.push_back(shape.positions[4]);
  shape.positions.push_back({9, 9, 9});  // unreferenced
  return shape;
}

void checkSameBits(const Keyframes& keyframes, const EncodingOptions& encoding, int wantedHelp) {
  auto sequence = Sequence::create(keyframes, encoding, {});
  REQUIRE(sequence.ok());
  ForkJoin forkJoin;
  const Helper helper(forkJoin);
  Frame alone, together;
  bool same = true;
  // A busy machine may leave the helper waiting: then frames are made until it had its share.
  for (int i = 0; i < 2000 && (i < 6 || forkJoin.helped() < wantedHelp); ++i) {
    const double t = -0.2 + 0.25 * (i % 6);
    sequence->setForkJoin(nullptr);
    REQUIRE(sequence->evaluate(t, alone).ok());
    sequence->setForkJoin(&forkJoin);
    REQUIRE(sequence->evaluate(t, together).ok());
    same = same && alone.positions == together.positions && alone.normals == together.normals &&
           alone.lostDefiniteness == together.lostDefiniteness;
  }
  CHECK(same);
  CHECK(forkJoin.helped() >= wantedHelp);
}

}  // namespace

TEST_CASE("forkJoin: every part is done once, by one or the other") {
  ForkJoin forkJoin;
  const Helper helper(forkJoin);
  std::array<std::vector<int>, 2> done;
  for (auto& list : done) list.reserve(20000);
  for (int i = 0; i < 20000; ++i) inTwo(&forkJoin, [&, i](int part) { done[part].push_back(i); });
  std::vector<int> all(20000);
  std::iota(all.begin(), all.end(), 0);
  CHECK(done[0] == all);
  CHECK(done[1] == all);
  std::atomic<bool> began = false;
  inTwo(&forkJoin, [&](int part) {  // the caller waits for the helper to begin
    if (part == 1) began.store(true);
    else
      while (!began.load()) std::this_thread::yield();
  });
  CHECK(forkJoin.helped() > 0);
}

TEST_CASE("forkJoin: a helper that breaks down is told of, and the caller goes on alone") {
  ForkJoin forkJoin;
  const Helper helper(forkJoin);
  std::atomic<bool> began = false;
  CHECK_THROWS_AS(inTwo(&forkJoin,
                        [&](int part) {
                          while (part == 0 && !began.load()) std::this_thread::yield();
                          if (part == 1) began.store(true), throw std::runtime_error("broken");
                        }),
                  std::runtime_error);
  std::array<int, 2> done = {0, 0};
  inTwo(&forkJoin, [&](int part) { ++done[part]; });
  CHECK(done == std::array{1, 1});
}

TEST_CASE("forkJoin: a helper that breaks down before the caller is done is told of, too: its part is half written") {
  ForkJoin forkJoin;
  const Helper helper(forkJoin);
  CHECK_THROWS_AS(inTwo(&forkJoin,
                        [&](int part) {
                          if (part == 1 && !forkJoin.lost()) throw std::runtime_error("broken");
                          while (!forkJoin.lost()) std::this_thread::yield();
                        }),
                  std::runtime_error);
}

TEST_CASE("forkJoin: a helper that never comes back is given up, and what it does later changes nothing") {
  std::atomic<bool> began = false, late = false;
  const auto stuck = [&](int part) {  // outlives the helper
    if (part == 1) began.store(true);
    while (part == 0 ? !began.load() : !late.load()) std::this_thread::yield();
  };
  ForkJoin forkJoin(2);
  const Helper helper(forkJoin);
  CHECK_THROWS_AS(inTwo(&forkJoin, stuck), std::runtime_error);
  std::array<int, 2> done = {0, 0};
  const auto count = [&](int part) { ++done[part]; };
  inTwo(&forkJoin, count);
  late.store(true);
  inTwo(&forkJoin, count);
  CHECK(done == std::array{2, 2});
  CHECK(forkJoin.helped() == 0);
}

TEST_CASE("two threads give the bits of one: parts, degenerate faces, every precision") {
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

TEST_CASE("two threads give the bits of one: a large mesh") { checkSameBits(makeBenchKeyframes(90000, 2, 1), {}, 10); }

#endif
