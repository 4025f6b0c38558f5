// Defects revealed by the inputs in tests/repro.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "../repro/repro_shapes.h"
#include "core/rotation/rigid_fit.h"
#include "sequences.h"

namespace shapespline::test::repro_test {
using namespace shapespline::repro;

namespace {

// Rotation of a wheel relative to its car.
struct Turning {
  double total = 0;                 // degrees from the first key to the last, forwards positive
  double slowest = 0, fastest = 0;  // degrees per second; opposite signs if the direction changes
  double offAxis = 0;               // largest tilt of the rotation axis, degrees
};

Turning turningOf(Sequence& sequence, const Car& car, int wheel) {
  const std::vector<double>& times = sequence.motion().keyTimes();
  const double start = times.front(), end = times.back();
  const int samples = 24 * static_cast<int>(times.size() - 1);
  const Positions rest = shapeAt(sequence, start);
  const auto relative = [&](double t) -> Mat3 {
    const Positions p = shapeAt(sequence, t);
    return fitRigid(car.body(rest), car.body(p)).rotation.transpose() *
           fitRigid(car.wheel(rest, wheel), car.wheel(p, wheel)).rotation;
  };
  Turning found{0, INFINITY, -INFINITY, 0};
  Mat3 before = relative(start);
  for (int i = 1; i <= samples; ++i) {
    const Mat3 now = relative(start + (end - start) * i / samples);
    const Vec3 step = logRotation(Mat3(now * before.transpose())) * (180 / pi);
    const double speed = step.y() * samples / (end - start);
    found.total += step.y();
    found.slowest = std::min(found.slowest, speed), found.fastest = std::max(found.fastest, speed);
    found.offAxis = std::max(found.offAxis, std::acos(std::min(1.0, now(1, 1))) * (180 / pi));
    before = now;
  }
  return found;
}

void checkRolls(Sequence& sequence, const Car& car, int wheel, double total) {
  CAPTURE(wheel);
  const Turning turning = turningOf(sequence, car, wheel);
  CHECK(turning.total == doctest::Approx(total).epsilon(0.1 / total));
  CHECK(turning.slowest > 0);
  CHECK(turning.slowest > 0.9 * turning.fastest);
  CHECK(turning.offAxis < 0.1);
}

const Warning* warningOf(const Sequence& sequence, const std::string& code) {
  for (const Warning& warning : sequence.warnings())
    if (warning.code == code) return &warning;
  return nullptr;
}

}  // namespace

TEST_CASE("repro: a wheel keeps turning in one direction") {
  const Car car = oneWheeled();
  for (const double step : {90.0, 100.0, 120.0, 170.0}) {
    CAPTURE(step);
    Sequence sequence = sequenceOf(car.keys(drive(step, 5)), doublePrecision());
    checkRolls(sequence, car, 0, 4 * step);
  }
}

TEST_CASE("repro: a car's wheels keep turning in one direction") {
  const Car car = fourWheeled();
  Sequence sequence = sequenceOf(car.keys(drive(90, 5)), doublePrecision());
  CHECK(sequence.stats().components == 5);
  for (int wheel = 0; wheel < car.wheels(); ++wheel) checkRolls(sequence, car, wheel, 360);
}

TEST_CASE("repro: a wheel keeps turning in a loop as well") {
  const Car car = oneWheeled();
  MotionOptions motion;
  motion.boundary = BoundaryKind::Periodic;
  Sequence sequence =
      sequenceOf(car.keys({{0, 0, 0}, {0, 0, 90}, {0, 0, 180}, {0, 0, 270}, {0, 0, 360}}), doublePrecision(), motion);
  checkRolls(sequence, car, 0, 360);
}

TEST_CASE("repro: parts with large rotations between two keys give a warning with the location") {
  const Car car = oneWheeled();
  for (const double degrees : {155.0, 175.0, 185.0}) {
    CAPTURE(degrees);
    Sequence sequence = sequenceOf(car.keys({{0, 0, 0}, {1, 10, 20}, {2, 20, 20 + degrees}}), doublePrecision());
    const Warning* warning = warningOf(sequence, "ambiguous-component-turn");
    REQUIRE(warning != nullptr);
    CHECK(warning->key == 2);
    REQUIRE(warning->face >= 0);
    CHECK(car.wheelOfFace(warning->face) == 0);
    CHECK(!warning->patches.empty());
  }
  Sequence calm = sequenceOf(car.keys({{0, 0, 0}, {1, 10, 20}, {2, 20, 160}}), doublePrecision());
  CHECK(warningOf(calm, "ambiguous-component-turn") == nullptr);
}

TEST_CASE("repro: turns added to one part remove its warning only") {
  const Car car = fourWheeled();
  const Keyframes keys = car.keys({{0, 0, 0}, {1, 10, 170}});
  const std::vector<double> times = {0, 1};
  Sequence sequence = sequenceOf(keys, doublePrecision());
  const auto wheelsWarnedOf = [&](const std::vector<AddedTurns>& turns) {
    MotionOptions motion;
    motion.turns = turns;
    REQUIRE(sequence.update(motion, times).ok());
    const Warning* warning = warningOf(sequence, "ambiguous-component-turn");
    return warning ? warning->count : 0;
  };
  CHECK(wheelsWarnedOf({}) == 4);
  const std::vector<int> component = sequence.encoded().componentOfInputFace();
  std::vector<AddedTurns> turns;
  for (std::size_t f = 0; f < component.size(); ++f)
    if (car.wheelOfFace(static_cast<int>(f)) == 2) {
      turns = {{1, 0, component[f]}};
      break;
    }
  CHECK(wheelsWarnedOf(turns) == 4);  // 0 turns have no effect
  turns[0].turns = -1;
  CHECK(wheelsWarnedOf(turns) == 3);
  CHECK(wheelsWarnedOf({{1, 1}}) == 4);  // turns of the whole
}

TEST_CASE("repro: full turns can be added to a part") {
  const Car car = oneWheeled();
  const std::vector<double> times = {0, 1};
  Sequence sequence = sequenceOf(car.keys(drive(90, 2)), doublePrecision());
  MotionOptions motion;
  motion.turns = {{1, 1, 1}};
  REQUIRE(sequence.update(motion, times).ok());
  checkRolls(sequence, car, 0, 450);
  const Positions rest = shapeAt(sequence, 0);
  const Mat3 body = fitRigid(car.body(rest), car.body(shapeAt(sequence, 0.5))).rotation;
  CHECK(logRotation(body).norm() == doctest::Approx(radians(5.5)).epsilon(1e-3));  // the body's rotation is unchanged

  // 240 degrees forwards look like 120 backwards in the keys: one turn less about that axis.
  Sequence far = sequenceOf(car.keys(drive(240, 2)), doublePrecision());
  motion.turns = {{1, -1, 1}};
  REQUIRE(far.update(motion, times).ok());
  checkRolls(far, car, 0, 240);
}

TEST_CASE("repro: a wheel that rests in the keys turns about its axle, not about an axis determined by noise") {
  const Car car = oneWheeled();
  Keyframes k = car.keys({{0, 0, 0}, {1, 0, 0}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
  for (Vec3& p : k.keys[1].positions) p += Vec3(noise(random), noise(random), noise(random));
  MotionOptions motion;
  motion.turns = {{1, 1, 1}};
  Sequence sequence = sequenceOf(k, doublePrecision(), motion);
  const Turning turning = turningOf(sequence, car, 0);
  CHECK(std::abs(turning.total) == doctest::Approx(360).epsilon(1e-3));
  CHECK(turning.offAxis < 1);
  CHECK(largestDistance(shapeAt(sequence, k.keys[1].time), k.keys[1].positions) < 1e-9 * diagonalOf(k));
}

TEST_CASE("repro: half a turn of the whole has the same direction at any position") {
  const Shape bar = box(1, 1, 6, 3, 3, 12);
  for (const std::vector<double>& degrees : {std::vector<double>{0, 180}, {0, 180, 360}}) {
    std::vector<Map> maps;
    for (double d : degrees) maps.push_back(turn(Vec3(0.3, 1, 0.2), radians(d)));
    const Keyframes k = keyframes(bar, maps);
    for (const double angle : {0.7, 2.2, 3.1}) {
      const Map move = turn(Vec3(1, 2, -0.5), angle, Vec3(3, -7, 11));
      Keyframes moved = k;
      for (Key& key : moved.keys) key.positions = mapped(key.positions, move);
      Sequence a = sequenceOf(k, doublePrecision()), b = sequenceOf(moved, doublePrecision());
      for (const double t : {0.2, 0.8})
        CHECK(largestDistance(mapped(shapeAt(a, t), move), shapeAt(b, t)) < 1e-8 * diagonalOf(k));
    }
  }
}

TEST_CASE("repro: invalid added turns and key times are refused") {
  const Keyframes k = keyframes(box(1, 1, 6, 2, 2, 4), {bend(0), bend(1), bend(-0.5), bend(0.2)});
  Sequence sequence = sequenceOf(k, doublePrecision());
  for (const AddedTurns& t : {AddedTurns{1, std::numeric_limits<int>::min(), -1},
                              {std::numeric_limits<int>::max(), 1, -1},
                              {1, 1, std::numeric_limits<int>::max()},
                              {1, 1, -5}}) {
    MotionOptions motion;
    motion.turns = {t};
    const Status status = sequence.update(motion, evenTimes(4));
    REQUIRE(!status.ok());
    CHECK(status.error().message.find("-2147483648.") == std::string::npos);
  }
  CHECK(sequence.update({}, {0, 1e-320, 2e-320, 1}).error().code == ErrorCode::TimesNotIncreasing);
  CHECK(sequence.update({}, {0, 1e-9, 0.5, 1}).ok());
}

}  // namespace shapespline::test::repro_test
