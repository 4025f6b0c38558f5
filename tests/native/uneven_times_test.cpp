// Key times that carry the motion far from its keys give a warning; other times do not.
#include <doctest/doctest.h>

#include <algorithm>

#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::uneven_times_test {

namespace {

std::vector<Warning> warningsOf(const Keyframes& keys, const MotionOptions& motion = {}) {
  const Sequence sequence = sequenceOf(keys, {}, motion);
  std::vector<Warning> found = sequence.warnings();
  std::erase_if(found, [](const Warning& w) { return w.code != "uneven-times"; });
  return found;
}

Keyframes bentAt(std::vector<double> times) {
  Keyframes keys = bentBar({0, 60, -50, 20}, box(1, 1, 10, 2, 2, 20));
  keys.keys.resize(times.size());
  for (std::size_t j = 0; j < times.size(); ++j) keys.keys[j].time = times[j];
  return keys;
}

}  // namespace

TEST_CASE("keys a millionth apart between others give a warning that names the interval") {
  const std::vector<Warning> found = warningsOf(bentAt({0, 1, 1 + 1e-6, 2}));
  REQUIRE(!found.empty());
  CHECK((found[0].key == 1 || found[0].key == 3));
  CHECK(found[0].face >= 0);
  CHECK(found[0].message.find("Space keys") != std::string::npos);
  CHECK(found[0].message.find("--key-times") != std::string::npos);
}

TEST_CASE("intervals of 1 and 100 give a warning about times after the last key, or before the first") {
  const std::vector<Warning> after = warningsOf(bentAt({0, 100, 101})), before = warningsOf(bentAt({0, 1, 101}));
  REQUIRE(!after.empty());
  CHECK(after.back().message.starts_with("After the last key"));
  CHECK(after.back().key == 2);
  REQUIRE(!before.empty());
  CHECK(std::any_of(before.begin(), before.end(), [](const Warning& w) { return w.key == 0; }));
}

TEST_CASE("one short interval makes a tube rotate far past its keys, which its box does not show") {
  Keyframes keys = twistedBar({0, 90, 0, 90, 0}, box(1, 1, 10, 2, 2, 20));
  const auto at = [&](double shortness) {
    const std::vector<double> times = {0, 1, 2, 2 + 1 / shortness, 3 + 1 / shortness};
    for (std::size_t j = 0; j < times.size(); ++j) keys.keys[j].time = times[j];
    return warningsOf(keys);
  };
  const std::vector<Warning> found = at(30);
  REQUIRE(!found.empty());
  CHECK(found[0].message.find(" degrees, because this interval is 30 times as long") != std::string::npos);
  CHECK(at(3).empty());
}

TEST_CASE("one short interval makes lengths pass those of the keys") {
  const Shape bar = box(1, 1, 10, 2, 2, 20);
  const auto longer = [](double factor) { return [=](const Vec3& p) { return Vec3(p.x(), p.y(), factor * p.z()); }; };
  const std::vector<Warning> found =
      warningsOf(keyframes(bar, {longer(1), longer(2), longer(1), longer(2)}, {0, 1, 1.03, 2}));
  REQUIRE(!found.empty());
  CHECK(found[0].message.find(" % of their edge lengths, because") != std::string::npos);
}

TEST_CASE("typical times give no warning") {
  for (const std::vector<double>& times : std::vector<std::vector<double>>{
           {0, 1}, {0, 1, 2, 3}, {0, 0.2, 1.4, 1.9}, {0, 1, 5, 6}, {0, 4, 5, 9}, {0, 0.1, 1, 2}, {0, 1, 1.2, 2}})
    for (BoundaryKind boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
      MotionOptions motion;
      motion.boundary = boundary;
      CAPTURE(times.size());
      CHECK(warningsOf(bentAt(times), motion).empty());
    }
}

TEST_CASE("uneven times of a shape that hardly moves give no warning") {
  Keyframes keys = bentBar({0, 0.01, 0.02, 0.03}, box(1, 1, 10, 2, 2, 20));
  const std::vector<double> times = {0, 1, 1.02, 2};
  for (int j = 0; j < 4; ++j) keys.keys[j].time = times[j];
  CHECK(warningsOf(keys).empty());
}

TEST_CASE("the warning disappears when an update makes the key times even") {
  Sequence sequence = sequenceOf(bentAt({0, 1, 1 + 1e-6, 2}), {});
  CHECK(!sequence.warnings().empty());
  REQUIRE(sequence.update({}, {0, 1, 2, 3}).ok());
  CHECK(sequence.warnings().empty());
}

}  // namespace shapespline::test::uneven_times_test
