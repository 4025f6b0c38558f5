// Uses an elimination order from elsewhere, as a second worker provides it.
#include <doctest/doctest.h>

#include <numeric>
#include <vector>

#include "core/sequence/elimination_order.h"
#include "core/sequence/sequence.h"
#include "shapes.h"
#include "shapes/bench_mesh.h"

namespace shapespline::test::elimination_order_test {

namespace {

std::vector<int> found;  // the order passed on
int asked = 0;           // number of unknowns requested

std::vector<int> handOver(int unknowns) {
  asked = unknowns;
  return found;
}

std::vector<float> shapeOf(const Keyframes& keys, const EncodingOptions& encoding, OrderSource order) {
  auto sequence = Sequence::create(keys, encoding, {}, {}, order);
  REQUIRE(sequence.ok());
  Frame frame;
  REQUIRE(sequence->evaluate(0.37, frame).ok());
  return frame.positions;
}

}  // namespace

TEST_CASE("elimination order: an order found elsewhere gives the same shapes bit for bit") {
  EncodingOptions ghost, tangent;
  ghost.ghostFaces = 300;
  const Keyframes capsule = makeBenchKeyframes(3000, 3, 1);
  tangent.startTangent = capsule.keys[1].positions;
  tangent.reference = 1;
  const Keyframes parts =
      keyframes(joined(bar(), sphere({3, 0, 5}, 1)), {twist(0), twist(radians(100)), twist(radians(200))});
  for (const auto& [keys, encoding] :
       {std::pair{&capsule, EncodingOptions()}, {&capsule, ghost}, {&capsule, tangent}, {&parts, EncodingOptions()}}) {
    auto order = eliminationOrder(*keys, encoding);
    REQUIRE(order.ok());
    found = *order;
    const std::vector<float> given = shapeOf(*keys, encoding, handOver);
    CHECK(asked == static_cast<int>(found.size()));
    CHECK(given == shapeOf(*keys, encoding, nullptr));
  }
}

TEST_CASE("elimination order: the provided order is used") {
  const Keyframes keys = keyframes(bar(), {twist(0), twist(1), twist(2)});
  const auto entriesOf = [&](OrderSource order) {
    return Sequence::create(keys, {}, {}, {}, order)->stats().factorBytes;
  };
  found = *eliminationOrder(keys, {});
  const auto best = entriesOf(handOver);
  CHECK(best == entriesOf(nullptr));
  // Every other unknown first: a different factor with more fill.
  std::vector<int> poor;
  for (std::size_t begin : {0, 1})
    for (std::size_t i = begin; i < found.size(); i += 2) poor.push_back(found[i]);
  found = poor;
  CHECK(entriesOf(handOver) > best);
}

TEST_CASE("elimination order: invalid orders are not used") {
  const Keyframes keys = keyframes(bar(), {twist(0), twist(1), twist(2)});
  const std::vector<float> plain = shapeOf(keys, {}, nullptr);
  const std::vector<int> good = *eliminationOrder(keys, {});
  for (const auto& wrong : {std::vector<int>(), std::vector<int>(good.begin() + 1, good.end()),
                            std::vector<int>(good.size(), 0), std::vector<int>(good.size(), -1)}) {
    found = wrong;
    CHECK(shapeOf(keys, {}, handOver) == plain);
  }
}

TEST_CASE("elimination order: errors are those of the sequence") {
  EncodingOptions wrong;
  wrong.reference = 9;
  const auto order = eliminationOrder(keyframes(bar(), {twist(0), twist(1)}), wrong);
  REQUIRE_FALSE(order.ok());
  CHECK(order.error().code == ErrorCode::InvalidOption);
}

}  // namespace shapespline::test::elimination_order_test
