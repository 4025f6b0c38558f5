// A sequence after updates equals a sequence created with the final options, bit for bit.
#include <doctest/doctest.h>

#include <algorithm>

#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::update_test {

namespace {

struct Change {
  std::string name;
  MotionOptions motion;
  std::vector<double> times = {0, 0.2, 0.7, 1.5};
};

template <class Edit>
Change change(const std::string& name, const Edit& edit) {
  Change c{name, {}};
  edit(c);
  return c;
}

// One change for each option of `update`, and some combinations.
std::vector<Change> changes() {
  return {change("defaults", [](Change&) {}),
          change("geodesic", [](Change& c) { c.motion.method = Method::Geodesic; }),
          change("linear", [](Change& c) { c.motion.method = Method::Linear; }),
          change("cubic vertex", [](Change& c) { c.motion.method = Method::CubicVertex; }),
          change("rotation-strain", [](Change& c) { c.motion.method = Method::RotationStrain; }),
          change("rimd", [](Change& c) { c.motion.method = Method::Rimd; }),
          change("hermite, speeds 4 and 0",
                 [](Change& c) {
                   c.motion.boundary = BoundaryKind::Hermite;
                   c.motion.startSpeed = 4, c.motion.endSpeed = 0;
                 }),
          change("periodic", [](Change& c) { c.motion.boundary = BoundaryKind::Periodic; }),
          change("periodic with a period",
                 [](Change& c) { c.motion.boundary = BoundaryKind::Periodic, c.motion.period = 2.25; }),
          change("tension", [](Change& c) { c.motion.tension = {0, 0.5, 1, -0.5}; }),
          change("bias", [](Change& c) { c.motion.bias = {0, 0.5, -1, 1}; }),
          change("held", [](Change& c) { c.motion.hold = true; }),
          change("held, tension", [](Change& c) { c.motion.hold = true, c.motion.tension = {0, 0.5, 0, 0.3}; }),
          change("held, tension, key times",
                 [](Change& c) {
                   c.motion.hold = true, c.motion.tension = {0, 0.5, 0, 0.3};
                   c.times = {0, 0.2, 0.9, 1.5};
                 }),
          change("turns", [](Change& c) { c.motion.turns = {{2, 1}}; }),
          change("turns of a component", [](Change& c) { c.motion.turns = {{1, -1, 1}}; }),
          change("in place", [](Change& c) { c.motion.inPlace = true; }),
          change("key times", [](Change& c) { c.times = {-3, -2.9, 4, 4.5}; }),
          change("periodic with turns, tension and other times", [](Change& c) {
            c.motion.boundary = BoundaryKind::Periodic;
            c.motion.turns = {{1, 1}, {3, -1}};
            c.motion.tension = {0, 0.5, 0, 0};
            c.times = {0, 1, 2, 2.5};
          })};
}

std::vector<double> bitsOf(Sequence& sequence) {
  std::vector<double> all;
  const auto [start, end] = sequence.range();
  for (const double share : {-0.4, 0.0, 0.31, 0.77, 1.0, 1.4}) {
    const double t = start + share * (end - start);
    Frame frame;
    REQUIRE(sequence.evaluate(t, frame).ok());
    all.insert(all.end(), frame.positions.begin(), frame.positions.end());
    all.insert(all.end(), frame.normals.begin(), frame.normals.end());
    all.push_back(frame.indefiniteFaces);
    for (const Vec3& p : shapeAt(sequence, t)) all.insert(all.end(), {p.x(), p.y(), p.z()});
  }
  return all;
}

std::string warningsOf(const Sequence& sequence) {
  std::string all;
  for (const Warning& w : sequence.warnings())
    all += w.code + " " + std::to_string(w.key) + " " + std::to_string(w.face) + "; ";
  return all;
}

struct Shown {
  std::vector<double> bits;
  std::string warnings;
};

Sequence created(const Keyframes& k, const EncodingOptions& encoding, const Change& c) {
  Keyframes timed = k;
  for (int j = 0; j < timed.keyCount(); ++j) timed.keys[j].time = c.times[j];
  return sequenceOf(std::move(timed), encoding, c.motion);
}

// Updates one sequence through all changes, forwards, backwards and with strides, and compares each result with a new
// sequence.
void checkUpdates(const Keyframes& k, const EncodingOptions& encoding) {
  std::vector<Change> all = changes();
  if (created(k, encoding, all.front()).stats().components == 1)
    all.erase(std::remove_if(all.begin(), all.end(), [](const Change& c) { return c.name == "turns of a component"; }),
              all.end());
  std::vector<Shown> alone;
  for (const Change& c : all) {
    Sequence sequence = created(k, encoding, c);
    alone.push_back({bitsOf(sequence), warningsOf(sequence)});
  }
  const int count = static_cast<int>(all.size());
  for (const auto& [first, stride] : {std::pair{0, 1}, std::pair{count - 1, -1}, std::pair{5, 5}}) {
    CAPTURE(stride);
    Sequence sequence = created(k, encoding, all[first]);
    for (int i = 1; i <= count; ++i) {
      const int at = ((first + i * stride) % count + count) % count;
      CAPTURE(all[at].name);
      REQUIRE(sequence.update(all[at].motion, all[at].times).ok());
      CHECK(bitsOf(sequence) == alone[at].bits);
      CHECK(warningsOf(sequence) == alone[at].warnings);
    }
  }
}

// A bar that bends and rotates, next to an independently rotating ball.
Keyframes barAndBall() {
  const Shape both = joined(box(1, 1, 10, 2, 2, 20), sphere({1.2, 0, 5}, 0.4, 6, 10));
  const auto pose = [](double bending, double turning, double rolling) -> Map {
    const Map bent = bend(radians(bending)), turned = turn({1, 2, 3}, radians(turning), {turning / 50, 0, 0}),
              rolled = turn(Vec3::UnitX(), radians(rolling));
    const Vec3 centre(1.2, 0, 5);
    return [=](const Vec3& p) -> Vec3 {
      const bool ball = (p - centre).norm() < 0.401;
      return turned(ball ? Vec3(bent(centre) + rolled(p - centre)) : bent(p));
    };
  };
  return keyframes(both, {pose(0, 0, 0), pose(60, 70, 100), pose(-40, 120, 190), pose(20, 30, 300)});
}

}  // namespace

TEST_CASE("update: a sequence updated to any options equals one created with them, bit for bit") {
  checkUpdates(barAndBall(), {});
  checkUpdates(barAndBall(), doublePrecision());
}

TEST_CASE("update: the same for a bar whose end speeds determine its rotation") {
  checkUpdates(
      keyframes(box(1, 1, 10, 2, 2, 20), {twist(0), twist(radians(150)), twist(radians(40)), twist(radians(290))}), {});
}

TEST_CASE("update: the same with a ghost, and with logarithmic stretch") {
  EncodingOptions ghost;
  ghost.ghostFaces = 150;
  checkUpdates(barAndBall(), ghost);
  EncodingOptions log;
  log.stretch = Stretch::Log;
  checkUpdates(barAndBall(), log);
}

}  // namespace shapespline::test::update_test
