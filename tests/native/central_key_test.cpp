// The choice of the reference pose hardly affects a motion.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/patches/central_key.h"
#include "core/sequence/weld_keys.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::central_key_test {

namespace {

int centralKeyOf(const Keyframes& keys, int reference = 0) {
  auto welded = weldKeys(keys, {});
  REQUIRE(welded.ok());
  welded->shape.reference = reference;
  return centralKey(welded->shape, topologyOf(welded->shape, {}));
}

// The largest distance between motions with different references, as a share of the diagonal.
double effectOfReference(const Keyframes& keys) {
  std::vector<Positions> first;
  double largest = 0;
  for (int reference = 0; reference < keys.keyCount(); ++reference) {
    EncodingOptions encoding = doublePrecision();
    encoding.reference = reference;
    Sequence sequence = sequenceOf(keys, encoding);
    const auto [start, end] = sequence.range();
    for (int i = 0; i <= 30; ++i) {
      const Positions positions = shapeAt(sequence, start + (end - start) * i / 30);
      if (reference == 0) first.push_back(positions);
      else largest = std::max(largest, largestDistance(first[i], positions));
    }
  }
  return largest / diagonalOf(keys);
}

}  // namespace

TEST_CASE("central key: the key with the least rotation to all keys, in any order of the keys") {
  CHECK(centralKeyOf(bentBar({0, 30, 60})) == 1);
  CHECK(centralKeyOf(bentBar({60, 30, 0})) == 1);
  CHECK(centralKeyOf(bentBar({0, 90, 10, 20})) == 3);
  CHECK(centralKeyOf(bentBar({20, 10, 90, 0})) == 0);
}

TEST_CASE("central key: among equally central keys of equal area, the one nearest to the reference") {
  for (const int reference : {0, 1}) CHECK(centralKeyOf(bentBar({0, 60}), reference) == reference);
  CHECK(centralKeyOf(bentBar({-60, -20, 20, 60}), 0) == 1);
  CHECK(centralKeyOf(bentBar({-60, -20, 20, 60}), 3) == 2);
}

TEST_CASE("central key: another reference does not change how a lion rotates, in arbitrary orders of its poses") {
  if (!hasData(lionPoses)) return;
  const std::vector<std::vector<int>> orders = {{2, 1, 9, 8}, {4, 9, 2, 6}, {3, 1, 9, 8}, {1, 8, 9, 6}, {1, 9, 2, 7}};
  for (const std::vector<int>& order : orders) {
    std::vector<std::string> poses;
    for (const int n : order) poses.push_back(lionPoses[n - 1]);
    CAPTURE(order);
    CHECK(effectOfReference(realKeyframes(poses)) < 0.03);
  }
}

TEST_CASE("central key: of two poses of a lion, the one with the larger area") {
  if (!hasData(lionPoses)) return;
  // With the reference as the central key, up to 62 %.
  for (const auto& [a, b] : {std::pair{1, 9}, {1, 4}, {2, 5}, {6, 8}}) {
    CAPTURE(a);
    CHECK(effectOfReference(realKeyframes({lionPoses[a - 1], lionPoses[b - 1]})) < 0.05);
  }
}

}  // namespace shapespline::test::central_key_test
