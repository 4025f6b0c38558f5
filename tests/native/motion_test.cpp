// Effects of the options on a motion: boundaries, turns, tangents, periods, measures.
#include <doctest/doctest.h>

#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "kg_error.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::motion_test {

namespace {

Sequence make(const Keyframes& k, const MotionOptions& motion = {},
              const EncodingOptions& encoding = doublePrecision()) {
  return sequenceOf(k, encoding, motion);
}

Vec3 mean(const Positions& p) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : p) sum += x / double(p.size());
  return sum;
}

MotionOptions with(BoundaryKind boundary) {
  MotionOptions m;
  m.boundary = boundary;
  return m;
}

// A walk: the bar bends and straightens while it moves on. The last key is the first key, moved.
Keyframes walk() {
  const auto step = [](double bendAngle, double x) -> Map {
    const Map b = bend(bendAngle);
    return [=](const Vec3& p) -> Vec3 { return b(p) + Vec3(0, x, 0); };
  };
  return keyframes(bar(), {step(0, 0), step(0.8, 1), step(-0.5, 2), step(0, 3)}, {0, 1, 2, 3});
}

}  // namespace

TEST_CASE("boundaries change the motion between the keys") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1), bend(-0.5)});
  Sequence s = make(k);
  const Positions natural = shapeAt(s, 0.2);
  REQUIRE(s.update(with(BoundaryKind::Hermite), evenTimes(3)).ok());
  CHECK(largestDistance(natural, shapeAt(s, 0.2)) > 0.01);
  REQUIRE(s.update(with(BoundaryKind::Periodic), evenTimes(3)).ok());
  CHECK(largestDistance(natural, shapeAt(s, 0.2)) > 0.01);
}

TEST_CASE("a periodic motion in place does not move on") {
  MotionOptions inPlace = with(BoundaryKind::Periodic);
  inPlace.inPlace = true;
  Sequence s = make(walk(), inPlace);
  CHECK(s.range().second == 3);
  CHECK((mean(shapeAt(s, 0.7)) - mean(shapeAt(s, 9.7))).norm() < 1e-7);
}

TEST_CASE("an open periodic motion returns over a closing interval") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1), bend(-0.5)}, {0, 1, 2});
  Sequence s = make(k, with(BoundaryKind::Periodic));
  CHECK(s.range().second == doctest::Approx(3));
  CHECK(largestDistance(shapeAt(s, 3), k.keys[0].positions) < 1e-8);
  CHECK(largestDistance(shapeAt(s, 4), k.keys[1].positions) < 1e-8);
  MotionOptions longer = with(BoundaryKind::Periodic);
  longer.period = 5;
  REQUIRE(s.update(longer, {0, 1, 2}).ok());
  CHECK(largestDistance(shapeAt(s, 6), k.keys[1].positions) < 1e-8);
  longer.period = 2;
  CHECK(s.update(longer, {0, 1, 2}).error().code == ErrorCode::InvalidOption);
}

TEST_CASE("full turns are added before a key") {
  const Keyframes k = keyframes(bar(), {turn(Vec3::UnitY(), 0), turn(Vec3::UnitY(), radians(60))});
  Sequence s = make(k);
  const auto halfway = [&] {
    return logRotation(Mat3(fitRigid(k.keys[0].positions, shapeAt(s, 0.25)).rotation)).norm();
  };
  CHECK(halfway() == doctest::Approx(radians(15)));
  MotionOptions m;
  m.turns = {{1, 1}};
  REQUIRE(s.update(m, evenTimes(2)).ok());
  CHECK(halfway() == doctest::Approx(radians(105)));
  CHECK(largestDistance(shapeAt(s, 1), k.keys[1].positions) < 1e-9 * diagonalOf(k));
}

TEST_CASE("ambiguous turns between keys give a warning") {
  const auto codes = [](double degrees) {
    Sequence s = make(keyframes(bar(), {turn(Vec3::UnitY(), 0), turn(Vec3::UnitY(), radians(degrees))}));
    std::vector<std::string> list;
    for (const Warning& w : s.warnings()) list.push_back(w.code);
    return list;
  };
  CHECK(codes(140).empty());
  CHECK(codes(160) == std::vector<std::string>{"ambiguous-turn"});
}

TEST_CASE("a blend at the curve's weights is the curve") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1)});
  Sequence s = make(k, {}, {});
  Frame a, b;
  REQUIRE(s.evaluate(0.25, a).ok());
  REQUIRE(s.evaluateBlend({0.75, 0.25}, b).ok());
  CHECK(a.positions == b.positions);
}

TEST_CASE("volume, area and the KG error of known shapes") {
  const Shape b = box(1, 2, 3, 2, 2, 2);
  CHECK(enclosedVolume(b.positions, b.faces) == doctest::Approx(6));
  CHECK(surfaceArea(b.positions, b.faces) == doctest::Approx(22));
  const std::vector<Positions> a = {{{1, 0, 0}, {-1, 0, 0}}}, c = {{{1, 0.1, 0}, {-1, 0, 0}}};
  CHECK(kgError(a, a) == 0);
  CHECK(kgError(a, c) == doctest::Approx(100 * 0.1 / std::sqrt(2.0)));
}

TEST_CASE("distances between keys, and the tensions without overshoot") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(0.1), bend(1.1), bend(1.1), bend(0.6)});
  Sequence s = make(k);
  const KeySpacing spacing = s.featureCurve()->keySpacing();
  REQUIRE(spacing.distance.size() == 4);
  CHECK(spacing.distance[1] / spacing.distance[0] == doctest::Approx(10).epsilon(0.02));
  CHECK(spacing.distance[2] < 1e-9 * spacing.distance[1]);
  REQUIRE(spacing.tension.size() == 5);
  CHECK(spacing.tension[1] > 0);
  CHECK(spacing.tension[1] < 1);
  CHECK(spacing.tension[2] == doctest::Approx(1));
  CHECK(spacing.tension[3] == doctest::Approx(1));
  const double between = (k.keys[2].time + k.keys[3].time) / 2, diagonal = diagonalOf(k);
  CHECK(largestDistance(shapeAt(s, between), k.keys[2].positions) > 1e-2 * diagonal);
  MotionOptions calm;
  calm.tension = spacing.tension;
  REQUIRE(s.update(calm, evenTimes(5)).ok());
  CHECK(largestDistance(shapeAt(s, between), k.keys[2].positions) < 1e-9 * diagonal);
  const KeySpacing again = s.featureCurve()->keySpacing();
  for (int j = 0; j < 5; ++j) CHECK(again.tension[j] == spacing.tension[j]);
}

TEST_CASE("speed of the motion, and its overshoot past a key") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(0.1), bend(1.1), bend(1.1), bend(0.6)});
  Sequence s = make(k);
  const KeySpacing keys = s.featureCurve()->keySpacing();
  const std::vector<double>& times = s.motion().keyTimes();
  const double mean = (keys.distance[0] + keys.distance[1] + keys.distance[2] + keys.distance[3]) / 4;
  const auto middle = [&](int j) { return (times[j] + times[j + 1]) / 2; };
  const MotionSpeed motion = s.featureCurve()->speedAt({middle(1), middle(2), -1, times[1]});
  CHECK(motion.overshoot[0] == 0);
  CHECK(motion.overshoot[1] > 0.01);  // the keys are equal, and the motion leaves them
  CHECK(motion.overshoot[2] == 0);    // extrapolated
  CHECK(motion.overshoot[3] < 1e-9);
  CHECK(s.featureCurve()->speedAt({middle(0)}).overshoot[0] > 0.01);  // swings back before the long interval
  MotionOptions straight;
  straight.method = Method::Geodesic;
  REQUIRE(s.update(straight, times).ok());
  const MotionSpeed steps = s.featureCurve()->speedAt({middle(0), middle(1), middle(2), middle(3)});
  for (int j = 0; j < 4; ++j) {
    CHECK(steps.speed[j] * (times[j + 1] - times[j]) == doctest::Approx(keys.distance[j]).epsilon(1e-6).scale(mean));
    CHECK(steps.overshoot[j] < 1e-9);
  }
}

TEST_CASE("the speed of the motion is the length of its step over a short time") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1), bend(-0.5)});
  Sequence s = make(k);
  const double h = 1e-4;
  const ShapePlane plane = s.featureCurve()->plane({0.3 - h, 0.3 + h});  // three keys span a plane
  const double step = std::hypot(plane.curve[2] - plane.curve[0], plane.curve[3] - plane.curve[1]) / (2 * h);
  const double chord = std::hypot(plane.keys[2] - plane.keys[0], plane.keys[3] - plane.keys[1]);
  CHECK(s.featureCurve()->speedAt({0.3}).speed[0] / s.featureCurve()->keySpacing().distance[0] ==
        doctest::Approx(step / chord).epsilon(1e-5));
}

TEST_CASE("the keys are in their own principal plane, and the spline bends less than the geodesic") {
  const Keyframes k = keyframes(bar(), {bend(0), bend(1), bend(-0.5)});
  Sequence s = make(k);
  const ShapePlane plane = s.featureCurve()->plane({0, 0.5, 1});
  CHECK(plane.explained == doctest::Approx(1));  // three keys span a plane
  for (int i = 0; i < 6; ++i) CHECK(plane.keys[i] == doctest::Approx(plane.curve[i]).epsilon(1e-9));
  const double spline = s.featureCurve()->bendingEnergy({0.5})[0];
  MotionOptions geodesic;
  geodesic.method = Method::Geodesic;
  REQUIRE(s.update(geodesic, evenTimes(3)).ok());
  CHECK(s.featureCurve()->bendingEnergy({0.5})[0] > 10 * spline);
  CHECK(s.featureCurve()->bendingEnergy({0.25})[0] < 1e-6 * s.featureCurve()->bendingEnergy({0.5})[0]);
}

TEST_CASE("keys of needles are exact in single precision too") {
  const std::pair<double, int> ribbons[] = {{300, 3000}, {2e3, 40}, {1e4, 40}, {1e5, 40}};
  for (const auto& [slenderness, rows] : ribbons) {
    CAPTURE(slenderness);
    const double step = 1 / slenderness, length = rows * step;
    Shape ribbon;
    for (int i = 0; i <= rows; ++i)
      for (const double y : {0.0, 1.0}) ribbon.positions.emplace_back(i * step, y, 0);
    for (int i = 0; i < rows; ++i)
      ribbon.faces.push_back({2 * i, 2 * i + 2, 2 * i + 1}), ribbon.faces.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
    const auto rolled = [&](double angle) {
      return [=](const Vec3& p) -> Vec3 {
        const double radius = length / angle, turn = p.x() / radius;
        return {radius * std::sin(turn), p.y(), radius * (1 - std::cos(turn))};
      };
    };
    const Keyframes k = keyframes(ribbon, {rolled(0.01), rolled(1), rolled(2)});
    Sequence sequence = sequenceOf(k, {});
    for (const Key& key : k.keys)
      CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-5 * diagonalOf(k));
  }
}

}  // namespace shapespline::test::motion_test
