// Regions with timings of their own (timing_regions.h).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::timing_regions_test {

namespace {

const KeyTiming none, ahead{{0.2, 0.2, -0.1, 0}, {0.5, -1, 0.4, 0}};

Keyframes bends() { return keyframes(bar(), {bend(0), bend(1.2), bend(-0.4), bend(0.9)}); }

MotionOptions timed(KeyTiming whole, std::vector<TimingRegion> regions = {}) {
  MotionOptions options;
  options.timing = std::move(whole);
  options.regions = std::move(regions);
  return options;
}

std::vector<int> all(const Keyframes& k) { return {0, k.faceCount()}; }

}  // namespace

TEST_CASE("a region of all faces moves as the whole, and the position has its own timing") {
  const Keyframes k = bends();
  Sequence whole = sequenceOf(k, doublePrecision(), timed(ahead));
  Sequence plain = sequenceOf(k, doublePrecision());
  for (const bool soft : {false, true}) {
    CAPTURE(soft);
    Sequence region = sequenceOf(k, doublePrecision(), timed(none, {{all(k), ahead, soft}, {{}, ahead}}));
    Sequence shapeOnly = sequenceOf(k, doublePrecision(), timed(none, {{all(k), ahead, soft}}));
    for (const double t : {0.1, 0.2, 0.5, 0.8, 1.3, -0.2}) {
      CAPTURE(t);
      const Positions wanted = shapeAt(whole, t), found = shapeAt(region, t), moved = shapeAt(shapeOnly, t);
      CHECK(largestDistance(wanted, found) < 1e-9);
      const Vec3 move = wanted[0] - moved[0];
      CHECK(largestDistance(mapped(moved, turn(Vec3::UnitX(), 0, move)), wanted) < 1e-9);
      if (t > 0 && t < 1) CHECK(largestDistance(shapeAt(plain, t), found) > 0.01);
    }
  }
}

TEST_CASE("with regions, keys are exact, nothing changes beyond them, and zeros change no bit") {
  const Keyframes k = bends();
  const std::vector<TimingRegion> half = {{{0, k.faceCount() / 2}, ahead}, {{}, {{0, 0.1, 0, 0}, {}}}};
  const std::vector<TimingRegion> still = {{{0, k.faceCount() / 2}, {{0, 0, 0, 0}, {}}}, {{}, none}};
  for (const auto boundary : {BoundaryKind::Natural, BoundaryKind::Hermite, BoundaryKind::Periodic}) {
    MotionOptions options = timed(none, half), zero = timed(none, still), empty;
    for (MotionOptions* o : {&options, &zero, &empty}) o->boundary = boundary;
    Sequence region = sequenceOf(k, doublePrecision(), options), plain = sequenceOf(k, doublePrecision(), empty);
    Sequence zeros = sequenceOf(k, doublePrecision(), zero);
    for (const Key& key : k.keys) CHECK(largestDistance(shapeAt(region, key.time), key.positions) < 1e-6);
    for (const double t : {-0.3, 0.2, 0.5, 1.2}) {
      CAPTURE(t);
      const bool beyond = boundary != BoundaryKind::Periodic && (t < 0 || t > 1);
      CHECK(shapeAt(zeros, t) == shapeAt(plain, t));
      CHECK((shapeAt(region, t) == shapeAt(plain, t)) == beyond);
    }
  }
}

TEST_CASE("frames with regions are smooth: the second difference at a key falls with the step") {
  const Keyframes k = bends();
  Sequence s = sequenceOf(k, doublePrecision(), timed(none, {{{0, k.faceCount() / 2}, ahead}}));
  const double key = k.keys[1].time;
  const auto jump = [&](double h) {
    const auto second = [&](double t) {
      const Positions a = shapeAt(s, t - h), b = shapeAt(s, t), c = shapeAt(s, t + h);
      return Positions{(a[0] - 2 * b[0] + c[0]) / (h * h), (a[600] - 2 * b[600] + c[600]) / (h * h)};
    };
    return largestDistance(second(key - h), second(key + h));
  };
  CHECK(jump(0.01) > 2.5 * jump(0.0025));
}

TEST_CASE("a component follows the timing of its region alone") {
  const Shape one = box(1, 2, 1, 3, 3, 3);
  const int faces = static_cast<int>(one.faces.size());
  const Shape both = joined(one, {mapped(one.positions, turn(Vec3::UnitX(), 0, Vec3(6, 0, 0))), one.faces});
  const auto pose = [&](double angle) -> Map {
    const Map a = turn(Vec3::UnitZ(), angle), b = turn(Vec3::UnitZ(), -angle);
    return [=](const Vec3& p) -> Vec3 { return p.x() < 3 ? a(p) : Vec3(b(p - Vec3(6, 0, 0)) + Vec3(6, 0, 0)); };
  };
  const Keyframes k = keyframes(both, {pose(0), pose(0.9), pose(0.3), pose(1)});
  Sequence whole = sequenceOf(k, doublePrecision(), timed(ahead)), plain = sequenceOf(k, doublePrecision());
  Sequence region = sequenceOf(k, doublePrecision(), timed(none, {{{faces, faces}, ahead, false}}));
  const auto part = [&](const Positions& p, bool second) {
    const auto middle = p.begin() + static_cast<std::ptrdiff_t>(p.size() / 2);
    return second ? Positions(middle, p.end()) : Positions(p.begin(), middle);
  };
  for (const double t : {0.1, 0.2, 0.45, 0.8}) {
    CAPTURE(t);
    const Positions p = shapeAt(plain, t), w = shapeAt(whole, t), r = shapeAt(region, t);
    CHECK(largestDistance(aligned(part(p, false), part(r, false)), part(r, false)) < 1e-7);
    // The turns, not only the shapes: edges of both components in the world.
    CHECK((r[1] - r[0] - (p[1] - p[0])).norm() < 1e-7);
    const std::size_t v = r.size() / 2;
    CHECK((r[v + 1] - r[v] - (w[v + 1] - w[v])).norm() < 1e-7);
  }
}

TEST_CASE("with a ghost mesh, its patches carry the timing, and keys are exact") {
  const Keyframes k = bends();
  EncodingOptions encoding = doublePrecision();
  encoding.ghostFaces = 300;
  Sequence s = sequenceOf(k, encoding, timed(none, {{{0, k.faceCount() / 2}, ahead}}));
  Sequence plain = sequenceOf(k, encoding);
  for (const Key& key : k.keys) CHECK(largestDistance(shapeAt(s, key.time), key.positions) < 1e-6);
  CHECK(largestDistance(shapeAt(s, 0.2), shapeAt(plain, 0.2)) > 0.01);
}

TEST_CASE("derivatives by the timing agree with differences of motions") {
  const Keyframes k = bends();
  const double t = 0.4, step = 0.02;
  Sequence plain = sequenceOf(k, doublePrecision());
  const std::vector<int>& patchOf = plain.encoded().lri().patchOfInputFace();
  std::vector<int> regionOf(static_cast<std::size_t>(1 + *std::max_element(patchOf.begin(), patchOf.end())), 0);
  for (std::size_t patch = 0; patch < regionOf.size() / 2; ++patch) regionOf[patch] = 1;
  std::vector<int> runs;  // of the faces of region 1
  for (int f = 0; f < k.faceCount(); ++f)
    if (patchOf[f] >= 0 && regionOf[patchOf[f]] == 1) runs.insert(runs.end(), {f, 1});

  const auto derivatives = plain.timingDerivatives(t, regionOf);
  REQUIRE(derivatives.ok());
  CHECK(derivatives->intervals == std::vector<int>{0, 1, 2});
  const auto numbers = static_cast<std::size_t>(3 * k.vertexCount());
  REQUIRE(derivatives->shapes.size() == 3 * 2 * 3 * numbers);
  for (std::size_t interval = 0; interval < 3; ++interval)
    for (const bool swing : {false, true})
      for (const std::size_t part : {1, 2}) {
        CAPTURE(interval);
        CAPTURE(swing);
        CAPTURE(part);
        const auto at = [&](double value) {
          KeyTiming timing{{0, 0, 0, 0}, {0, 0, 0, 0}};
          (swing ? timing.swing : timing.earlier)[interval] = value;
          Sequence s =
              sequenceOf(k, doublePrecision(), timed(none, {{part == 1 ? runs : std::vector<int>{}, timing, false}}));
          return shapeAt(s, t);
        };
        const Positions ahead = at(step), behind = at(-step);
        const float* found = derivatives->shapes.data() + ((interval * 2 + swing) * 3 + part) * numbers;
        double off = 0, largest = 0;
        for (std::size_t v = 0; v < ahead.size(); ++v) {
          const Vec3 wanted = (ahead[v] - behind[v]) / (2 * step);
          off = std::max(off, (wanted - Vec3(found[3 * v], found[3 * v + 1], found[3 * v + 2])).norm());
          largest = std::max(largest, wanted.norm());
        }
        CHECK(off < 0.05 * largest);
      }
  CHECK(plain.timingDerivatives(t, {}).error().code == ErrorCode::InvalidOption);
  CHECK(plain.timingDerivatives(2, regionOf).error().code == ErrorCode::InvalidOption);
}

TEST_CASE("wrong regions give messages") {
  const Keyframes k = bends();
  const auto message = [&](const MotionOptions& options) {
    const auto s = Sequence::create(k, doublePrecision(), options);
    REQUIRE(!s.ok());
    CHECK(s.error().code == ErrorCode::InvalidOption);
    return s.error().message;
  };
  CHECK(message(timed(none, {{{0, 9999}, none}})).find("9,999") != std::string::npos);
  CHECK(message(timed(none, {{{0, -1}, none}})).find("A region has faces") == 0);
  CHECK(message(timed(none, {{{0}, none}})).find("runs") != std::string::npos);
  CHECK(message(timed(none, {{{}, none}, {{}, none}})).find("Two regions") == 0);
  CHECK(message(timed(none, {{all(k), {{1, 2}, {}}}})).find("2 values for 4 keys") != std::string::npos);
  CHECK(message(timed(none, {{all(k), {{1, 2, NAN, 0}, {}}}})).find("finite") != std::string::npos);
  MotionOptions cubic = timed(none, {{all(k), none}});
  cubic.method = Method::CubicVertex;
  CHECK(message(cubic).find("'lri'") != std::string::npos);
}

}  // namespace shapespline::test::timing_regions_test
