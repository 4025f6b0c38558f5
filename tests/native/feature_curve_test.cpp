// Motions in shape space, including vertex blends: plane, bending of every method, coordinates of one face over time.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::feature_curve_test {

namespace {

Sequence moved(Method method, const EncodingOptions& encoding = doublePrecision()) {
  MotionOptions motion;
  motion.method = method;
  return sequenceOf(keyframes(box(1, 1, 6, 2, 2, 12), {bend(0), bend(1), twist(1)}), encoding, motion);
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

}  // namespace

TEST_CASE("shape plane: a vertex blend passes through the keys and leaves their plane between them") {
  for (const int ghostFaces : {0, 60}) {
    CAPTURE(ghostFaces);
    EncodingOptions encoding = doublePrecision();
    encoding.ghostFaces = ghostFaces;
    Sequence ours = moved(Method::Lri, encoding), blend = moved(Method::Linear, encoding);
    const std::vector<double> keys = ours.motion().keyTimes();
    const ShapePlane atKeys = blend.featureCurve()->plane(keys);
    for (std::size_t i = 0; i < atKeys.keys.size(); ++i)
      CHECK(atKeys.curve[i] == doctest::Approx(atKeys.keys[i]).epsilon(1e-9));
    CHECK(largest(atKeys.distance) < 1e-6);
    const std::vector<double> between = {0.25 * keys[1], 0.5 * keys[1], keys[1] + 0.5 * (keys[2] - keys[1])};
    // Three keys span a plane, which contains all blends of their coordinates.
    CHECK(largest(ours.featureCurve()->plane(between).distance) < 1e-6);
    for (const double distance : blend.featureCurve()->plane(between).distance) CHECK(distance > 0.05);
  }
}

TEST_CASE("shape plane: a shape of another motion has the place that its own motion gives it") {
  for (const int ghostFaces : {0, 60}) {
    CAPTURE(ghostFaces);
    EncodingOptions encoding = doublePrecision();
    encoding.ghostFaces = ghostFaces;
    Sequence ours = moved(Method::Lri, encoding);
    for (const Method method : {Method::CubicVertex, Method::RotationStrain}) {
      if (ghostFaces > 0 && method == Method::RotationStrain) continue;
      Sequence other = moved(method, encoding);
      for (const double t : {0.3, 0.5 * other.range().second}) {
        Positions shape;
        REQUIRE(other.evaluate(t, shape).ok());
        const ShapePlane given = ours.featureCurve()->planeWith(t, shape), own = other.featureCurve()->plane({t});
        CHECK(given.keys == own.keys);
        REQUIRE(given.curve.size() == 2);
        for (const int axis : {0, 1}) CHECK(given.curve[axis] == doctest::Approx(own.curve[axis]).epsilon(1e-9));
        CHECK(given.distance.at(0) == doctest::Approx(own.distance.at(0)).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("shape plane: the weights are those of the motion") {
  Sequence s = moved(Method::Lri);
  const std::vector<double> times = {-0.5, 0, 0.3, 2};
  const ShapePlane plane = s.featureCurve()->plane(times);
  REQUIRE(plane.weights.size() == 3 * times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double* w = &plane.weights[3 * i];
    CHECK(w[0] + w[1] + w[2] == doctest::Approx(1));
    // The plane's coordinates are affine in the weights.
    for (const int axis : {0, 1})
      CHECK(w[0] * plane.keys[axis] + w[1] * plane.keys[2 + axis] + w[2] * plane.keys[4 + axis] ==
            doctest::Approx(plane.curve[2 * i + axis]));
    if (times[i] < 0 || times[i] > s.range().second) continue;  // stretch is eased beyond the keys
    Frame curve, blend;
    REQUIRE(s.evaluate(times[i], curve).ok());
    REQUIRE(s.evaluateBlend({w[0], w[1], w[2]}, blend).ok());
    for (std::size_t k = 0; k < curve.positions.size(); ++k)
      REQUIRE(std::abs(curve.positions[k] - blend.positions[k]) < 1e-5);
  }
}

TEST_CASE("shape plane: the shapes of end tangents are in the directions of the motion at its ends") {
  const auto bar = box(1, 1, 6, 2, 2, 12);
  MotionOptions motion;
  motion.boundary = BoundaryKind::Hermite;
  motion.endSpeed = 0.5;
  EncodingOptions encoding = doublePrecision();
  encoding.startTangent = mapped(bar.positions, twist(0.7));
  encoding.endTangent = mapped(bar.positions, bend(0.4));
  Sequence s = sequenceOf(keyframes(bar, {bend(0), bend(1), twist(1)}), encoding, motion);
  const std::vector<double> keys = s.motion().keyTimes();
  const double h = 1e-5;
  const ShapePlane plane = s.featureCurve()->plane({keys.front(), keys.front() + h, keys.back() - h, keys.back()});
  REQUIRE(plane.tangents.size() == 4);
  for (const int axis : {0, 1}) {
    CAPTURE(axis);
    const auto curve = [&](int point) { return plane.curve[2 * point + axis]; };
    const double start = (plane.tangents[axis] - plane.keys[axis]) / (keys[1] - keys[0]);
    const double end = 0.5 * (plane.keys[4 + axis] - plane.tangents[2 + axis]) / (keys[2] - keys[1]);
    CHECK((curve(1) - curve(0)) / h == doctest::Approx(start).epsilon(1e-3));
    CHECK((curve(3) - curve(2)) / h == doctest::Approx(end).epsilon(1e-3));
  }
  CHECK(moved(Method::Lri).featureCurve()->plane({0}).tangents.empty());

  // Two keys lie on a line. A tangent pose off this line spans the plane.
  encoding.startTangent.reset();
  Sequence two = sequenceOf(keyframes(bar, {bend(0), twist(1)}), encoding, motion);
  const ShapePlane spanned =
      two.featureCurve()->plane({two.motion().keyTimes().front(), two.motion().keyTimes().back()});
  CHECK(std::abs(spanned.keys[1]) < 1e-9);
  CHECK(std::abs(spanned.keys[3]) < 1e-9);
  REQUIRE(spanned.tangents.size() == 2);
  CHECK(spanned.tangents[1] > 0.1 * (spanned.keys[2] - spanned.keys[0]));
  CHECK(spanned.explained == doctest::Approx(1));
}

TEST_CASE("bending: piecewise linear motions bend at keys only, in shape space and in the space of vertices") {
  for (const Method method : {Method::Geodesic, Method::Linear}) {
    CAPTURE(static_cast<int>(method));
    Sequence s = moved(method);
    const std::vector<double> keys = s.motion().keyTimes();
    const double h = (keys[2] - keys[0]) / 100, a = keys[1] - keys[0], b = keys[2] - keys[1];
    const std::vector<double> energy = s.featureCurve()->bendingEnergy({keys[0] + 0.5 * a, keys[1], keys[1] + 0.5 * b});
    CHECK(energy[0] < 1e-12 * energy[1]);
    CHECK(energy[2] < 1e-12 * energy[1]);
    // |(x2 - x1) / b - (x1 - x0) / a|^2 / h^2 is bounded by the two steps.
    CHECK(energy[1] < 2 * (1 / a + 1 / b) * (1 / a + 1 / b) / (h * h));
    CHECK(energy[1] > 0.01 / (h * h));
  }
  Sequence cubic = moved(Method::CubicVertex), linear = moved(Method::Linear);
  const double key = cubic.motion().keyTimes()[1];
  CHECK(cubic.featureCurve()->bendingEnergy({key})[0] < 0.01 * linear.featureCurve()->bendingEnergy({key})[0]);
}

TEST_CASE("a face over time passes through its coordinates at the keys") {
  Sequence s = moved(Method::Lri), straight = moved(Method::Geodesic);
  const std::vector<double> keys = s.motion().keyTimes();
  for (const int face : {0, 50}) {
    const auto curve = s.featureCurve()->face(face, keys), other = straight.featureCurve()->face(face, keys);
    REQUIRE(curve.ok());
    CHECK(curve->patch == s.encoded().lri().patchOfInputFace()[face]);
    REQUIRE(curve->numbers.size() == 18);
    // Every curve through the keys has these values.
    for (int i = 0; i < 18; ++i) CHECK(curve->numbers[i] == doctest::Approx(other->numbers[i]));
    // The reference is not stretched.
    CHECK(curve->numbers[3] == doctest::Approx(1));
    CHECK(curve->numbers[4] == doctest::Approx(0));
  }
  // A natural motion equals `natural`. Another boundary differs from it, except at the keys.
  const std::vector<double> times = {keys[0], keys[0] + 0.3 * (keys[1] - keys[0]), keys[1], keys[2]};
  const auto own = s.featureCurve()->face(50, times);
  CHECK(own->natural == own->numbers);
  MotionOptions eased;
  eased.boundary = BoundaryKind::Hermite;
  eased.startSpeed = 0;
  Sequence e = sequenceOf(keyframes(box(1, 1, 6, 2, 2, 12), {bend(0), bend(1), twist(1)}), doublePrecision(), eased);
  const auto other = e.featureCurve()->face(50, times);
  double off = 0;
  for (std::size_t i = 0; i < own->natural.size(); ++i) {
    CHECK(other->natural[i] == doctest::Approx(own->natural[i]));
    if (i / 6 != 1) CHECK(other->numbers[i] == doctest::Approx(own->numbers[i]));
    off = std::max(off, std::abs(other->numbers[i] - own->numbers[i]));
  }
  CHECK(off > 1e-3);
  CHECK(s.featureCurve()->face(-1, keys).error().code == ErrorCode::InvalidOption);
  CHECK(s.featureCurve()->face(static_cast<int>(s.faces().size()), keys).error().code == ErrorCode::InvalidOption);
}

TEST_CASE("a patch over time rotates relative to each neighbour as at the keys") {
  Sequence s = moved(Method::Lri);
  const std::vector<double> keys = s.motion().keyTimes();
  const auto turnOf = [](const CoordinateCurve& curve, std::size_t row, std::size_t neighbour) {
    const double* q = &curve.numbers[row * (1 + 4 * curve.neighbours.size()) + 1 + 4 * neighbour];
    return Quaternion(q[0], q[1], q[2], q[3]);
  };
  const std::vector<double> times = {keys[0], keys[1], 0.5 * (keys[1] + keys[2]), keys[2]};
  const auto curve = s.featureCurve()->patch(0, times);
  REQUIRE(curve.ok());
  REQUIRE(!curve->neighbours.empty());
  CHECK(curve->numbers.size() == times.size() * (1 + 4 * curve->neighbours.size()));
  CHECK(curve->natural == curve->numbers);
  // The reference has no rotation and no stretch.
  CHECK(curve->numbers[0] == doctest::Approx(1));
  double turned = 0;
  for (std::size_t n = 0; n < curve->neighbours.size(); ++n) {
    CHECK(turnOf(*curve, 0, n).angularDistance(Quaternion::Identity()) < 1e-9);
    for (const std::size_t row : {0, 1, 3}) {
      std::vector<Quaternion> rotations;
      REQUIRE(s.patchRotations(times[row], rotations).ok());
      const Quaternion expected = rotations[0].conjugate() * rotations[curve->neighbours[n]];
      CHECK(turnOf(*curve, row, n).angularDistance(expected) < 1e-6);
      turned = std::max(turned, expected.angularDistance(Quaternion::Identity()));
    }
    // Relative to the other patch, the rotation is inverted.
    const auto back = s.featureCurve()->patch(curve->neighbours[n], times);
    const auto& around = back->neighbours;
    const auto at = std::find(around.begin(), around.end(), 0) - around.begin();
    REQUIRE(at < static_cast<std::ptrdiff_t>(around.size()));
    CHECK(turnOf(*back, 2, at).angularDistance(turnOf(*curve, 2, n).conjugate()) < 1e-9);
  }
  CHECK(turned > 0.05);

  MotionOptions eased;
  eased.boundary = BoundaryKind::Hermite;
  eased.startSpeed = 0;
  Sequence e = sequenceOf(keyframes(box(1, 1, 6, 2, 2, 12), {bend(0), bend(1), twist(1)}), doublePrecision(), eased);
  const auto other = e.featureCurve()->patch(0, times);
  CHECK(other->natural == curve->natural);
  CHECK(other->numbers != other->natural);
  const int count =
      1 + *std::max_element(s.encoded().lri().patchOfInputFace().begin(), s.encoded().lri().patchOfInputFace().end());
  CHECK(s.featureCurve()->patch(-1, keys).error().code == ErrorCode::InvalidOption);
  CHECK(s.featureCurve()->patch(count, keys).error().code == ErrorCode::InvalidOption);
}

TEST_CASE("the stretch of a patch is weighted by area, so slivers count little") {
  // Faces further along are thinner and more stretched.
  Shape shape = box(1, 1, 6, 2, 2, 12);
  for (Vec3& p : shape.positions) p.z() = std::sqrt(p.z());
  const Positions rest = shape.positions;
  const Map stretched = [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() + p.z() * p.z() * p.z()); };
  Sequence s = sequenceOf(keyframes(shape, {bend(0), stretched}), doublePrecision(), {});
  const double key = s.motion().keyTimes()[1];
  double sum = 0, total = 0, plain = 0;
  int count = 0;
  for (int face = 0; face < static_cast<int>(s.faces().size()); ++face) {
    if (s.encoded().lri().patchOfInputFace()[face] != 0) continue;
    const auto& [a, b, c] = s.faces()[face];
    const double area = (rest[b] - rest[a]).cross(rest[c] - rest[a]).norm();
    const std::vector<double> six = s.featureCurve()->face(face, {key})->numbers;
    sum += area * (six[3] + six[5]) / 2, total += area;
    plain += (six[3] + six[5]) / 2, ++count;
  }
  const double whole = s.featureCurve()->patch(0, {key})->numbers[0];
  CHECK(whole == doctest::Approx(sum / total));
  CHECK(std::abs(whole - plain / count) > 1e-3);
}

}  // namespace shapespline::test::feature_curve_test
