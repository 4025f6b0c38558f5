// Senses of turns, as signs of quaternions, from neighbouring parts.
#include <doctest/doctest.h>

#include "core/patches/turn_senses.h"
#include "shapes.h"
#include "shapes/random.h"

namespace shapespline::test::turn_senses_test {

namespace {

Quaternion about(const Vec3& axis, double degrees) { return expQuaternion(axis * radians(degrees)); }

// A strip of parts in which each is joined to the next, with arbitrary signs.
struct Strip {
  std::vector<TurnJoint> joints;
  std::vector<double> area;
  std::vector<Quaternion> turn;

  void add(const Quaternion& q) {
    if (!turn.empty()) joints.push_back({static_cast<int>(turn.size()) - 1, static_cast<int>(turn.size()), 1});
    turn.push_back(turn.size() % 3 == 1 ? Quaternion(-q.coeffs()) : q);
    area.push_back(1);
  }

  // Rotation of the last part relative to the first in degrees, up to a full turn.
  double lastTurn() const { return 2 * std::acos(turn.front().dot(turn.back())) * 180 / pi; }
};

}  // namespace

TEST_CASE("turns that add up from part to part keep their direction beyond half a turn") {
  for (const double degrees : {170.0, 185.0, 247.0, 350.0}) {
    Strip strip;
    for (int i = 0; i <= 10; ++i) strip.add(about(Vec3::UnitZ(), degrees * i / 10));
    CHECK(chooseTurnSenses(strip.joints, strip.area, strip.turn).empty());
    CHECK(strip.lastTurn() == doctest::Approx(degrees));
  }
}

TEST_CASE("if joints contradict each other, the longer side determines the direction, and the turn is ambiguous") {
  // Two bodies of three parts. One joint between them takes the short way of 160 degrees, through a part halfway. The
  // other joint takes the long way.
  for (const double longSide : {0.5, 2.0}) {
    std::vector<Quaternion> turn;
    for (int i = 0; i < 3; ++i) turn.push_back(Quaternion::Identity());
    for (int i = 0; i < 3; ++i) turn.push_back(about(Vec3::UnitZ(), 160));
    turn.push_back(about(Vec3::UnitZ(), 80));
    turn.push_back(about(Vec3::UnitZ(), -100));
    const std::vector<TurnJoint> joints = {{0, 1, 1}, {1, 2, 1}, {3, 4, 1},        {4, 5, 1},
                                           {2, 6, 1}, {6, 3, 1}, {1, 7, longSide}, {7, 4, longSide}};
    const std::vector<OpenTurn> open = chooseTurnSenses(joints, std::vector<double>(8, 1), turn);
    const bool goesShort = turn[0].dot(turn[3]) > 0;
    CHECK(goesShort == (longSide < 1));
    REQUIRE(!open.empty());
    CHECK(open.back().angle >= radians(144));
    CHECK(open.back().share >= 0.1);
  }
}

TEST_CASE("directions do not depend on the initial signs") {
  Random random(3);
  const auto coordinate = [&] { return random.uniform(-2, 2); };
  std::vector<TurnJoint> joints;
  std::vector<Quaternion> turn;
  const int side = 12;
  for (int i = 0; i < side * side; ++i) {
    turn.push_back(expQuaternion(Vec3{coordinate(), coordinate(), coordinate()}));
    if (i % side > 0) joints.push_back({i - 1, i, random.uniform(1, 1.2)});
    if (i >= side) joints.push_back({i - side, i, random.uniform(1, 1.2)});
  }
  const std::vector<double> area(turn.size(), 1);
  std::vector<Quaternion> flipped = turn;
  for (Quaternion& q : flipped)
    if (random.below(2) == 0) q.coeffs() *= -1;
  chooseTurnSenses(joints, area, turn);
  chooseTurnSenses(joints, area, flipped);
  const double sign = turn[0].dot(flipped[0]);
  for (std::size_t i = 0; i < turn.size(); ++i) CHECK(turn[i].dot(flipped[i]) == doctest::Approx(sign));
}

}  // namespace shapespline::test::turn_senses_test
