// Motions fitted to lengths and dihedral angles: derivatives of the measures, preserved lengths, intervals without a
// fit, and the transfer from the coarse mesh to the full shape.
#include <doctest/doctest.h>

#include <limits>

#include "core/mesh/measures.h"
#include "dense.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "shells/deformation_transfer.h"
#include "shells/fit_shape.h"
#include "shells/shell_bending.h"
#include "shells/shell_motion.h"
#include "shells/shell_spline.h"

namespace shapespline::test::shells_test {

namespace {

// A square sheet, n x n cells.
Shape sheet(int n) {
  Shape shape;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) shape.positions.emplace_back(double(i) / n, double(j) / n, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      if ((i + j) % 2) shape.faces.push_back({a, b, d}), shape.faces.push_back({a, d, c});
      else shape.faces.push_back({a, b, c}), shape.faces.push_back({b, d, c});
    }
  return shape;
}

// Rolls the sheet up along a direction in its plane, by an angle over its side.
Map roll(double direction, double angle) {
  return [=](const Vec3& p) -> Vec3 {
    const Vec3 along(std::cos(direction), std::sin(direction), 0), across(-along.y(), along.x(), 0);
    const double arc = p.dot(along) * angle;
    return along * (std::sin(arc) / angle) + across * p.dot(across) + Vec3(0, 0, (1 - std::cos(arc)) / angle);
  };
}

Keyframes rolledSheet(int n) { return keyframes(sheet(n), {roll(0.3, 2.5), roll(0.3 + pi / 2, 2.5)}); }

std::vector<Positions> posesOf(const Keyframes& k) {
  std::vector<Positions> poses;
  for (const Key& key : k.keys) poses.push_back(key.positions);
  return poses;
}

// K + 1 evenly spaced times of a motion, including the times of its keys.
std::vector<ShellSample> samplesOf(const Keyframes& k, int count, const MotionOptions& motion = {}) {
  Sequence sequence = sequenceOf(k, doublePrecision(), motion);
  std::vector<ShellSample> samples;
  for (int i = 0; i <= count; ++i) {
    ShellSample sample;
    sample.time = k.keys.front().time + (k.keys.back().time - k.keys.front().time) * i / count;
    const Weights weights = sequence.motion().curve().at(sample.time).weights;
    sample.weights.assign(weights.data(), weights.data() + k.keyCount());
    sample.start = shapeAt(sequence, sample.time);
    for (int j = 0; j < k.keyCount(); ++j)
      if (std::abs(k.keys[j].time - sample.time) < 1e-9) sample.key = j;
    samples.push_back(sample);
  }
  return samples;
}

ShellShapes fitted(const Keyframes& k, const std::vector<ShellSample>& samples,
                   ShellMethod method = ShellMethod::Lengths) {
  auto shapes = shellShapes(k.faces, posesOf(k), samples, method);
  REQUIRE_MESSAGE(shapes.ok(), (shapes.ok() ? "" : shapes.error().message));
  return std::move(*shapes);
}

// LRI's motion through the shapes.
Sequence motionThrough(const Keyframes& k, const std::vector<ShellSample>& samples, const ShellShapes& found) {
  Keyframes through;
  through.faces = k.faces;
  for (std::size_t s = 0; s < samples.size(); ++s) through.keys.push_back({"", samples[s].time, found.shapes[s]});
  return sequenceOf(through, doublePrecision());
}

// Root mean square deviation of edge lengths from their spline, as a mean over time, in percent.
double lengthError(Sequence& sequence, const Keyframes& k) {
  const std::vector<Positions> keys = posesOf(k);
  const ShellMetric metric(k.faces, keys);
  const std::vector<ShellMeasures> measures = metric.measuresOfKeys(keys);
  const auto curve = Curve::fit({k.keys.front().time, k.keys.back().time}, {});
  double mean = 0;
  for (int i = 1; i < 20; ++i) {
    const double t = i / 20.0;
    const ShellMeasures now = metric.measuresOf(shapeAt(sequence, t));
    const Weights weights = curve->at(t).weights;
    double sum = 0;
    for (int e = 0; e < metric.edgeCount(); ++e)
      sum += std::pow(now[e] / (weights[0] * measures[0][e] + weights[1] * measures[1][e]) - 1, 2);
    mean += 100 * std::sqrt(sum / metric.edgeCount()) / 19;
  }
  return mean;
}

struct Energies {
  double lri, lengths, spline;
};

Energies energiesOf(const Keyframes& k, int count) {
  const std::vector<ShellSample> samples = samplesOf(k, count);
  const ShellMetric metric(k.faces, posesOf(k));
  auto system = ShellSystem::create(metric);
  REQUIRE(system.ok());
  std::vector<double> times;
  for (const ShellSample& s : samples) times.push_back(s.time);
  const auto energy = [&](const std::vector<Positions>& shapes) {
    return ShellSpline(*system, times, diagonalOf(k)).energy(shapes);
  };
  std::vector<Positions> starts;
  for (const ShellSample& s : samples) starts.push_back(s.key >= 0 ? k.keys[s.key].positions : s.start);
  return {energy(starts), energy(fitted(k, samples).shapes), energy(fitted(k, samples, ShellMethod::Spline).shapes)};
}

}  // namespace

TEST_CASE("shells: derivatives of lengths and angles agree with differences") {
  const Keyframes k = keyframes(box(1, 1, 4, 2, 2, 8), {bend(0, 4), bend(1, 4)});
  const ShellMetric metric(k.faces, posesOf(k));
  REQUIRE(metric.angleCount() == metric.edgeCount());
  const Positions& pose = k.keys[1].positions;
  constexpr double step = 1e-6;
  for (int m = 0; m < metric.measureCount(); ++m) {
    const ShellMetric::Row row = metric.rowOf(m, pose);
    for (int a = 0; a < row.count; ++a)
      for (int c = 0; c < 3; ++c) {
        Positions up = pose, down = pose;
        up[row.vertex[a]][c] += step, down[row.vertex[a]][c] -= step;
        const double difference = (metric.measuresOf(up)[m] - metric.measuresOf(down)[m]) / (2 * step);
        CHECK(row.gradient[a][c] == doctest::Approx(difference).epsilon(1e-6));
      }
  }
}

TEST_CASE("shells: a sheet between two roll-ups keeps its lengths and its area") {
  const Keyframes k = rolledSheet(8);
  const std::vector<ShellSample> samples = samplesOf(k, 12);
  const ShellShapes found = fitted(k, samples);
  CHECK(found.failed.empty());
  Sequence lri = sequenceOf(k, doublePrecision()), sequence = motionThrough(k, samples, found);
  CHECK(lengthError(lri, k) > 1);
  CHECK(lengthError(sequence, k) < 1);
  const double area = surfaceArea(k.keys[0].positions, k.faces);
  for (const double t : {0.1, 0.37, 0.5, 0.8})
    CHECK(std::abs(surfaceArea(shapeAt(sequence, t), k.faces) / area - 1) < 0.001);
  for (const Key& key : k.keys)
    CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-11 * diagonalOf(k));
}

TEST_CASE("shells: fits from LRI space and from blended vertices end in the same shape") {
  const Keyframes k = rolledSheet(6);
  MotionOptions cubic;
  cubic.method = Method::CubicVertex;
  const ShellShapes one = fitted(k, samplesOf(k, 4)), other = fitted(k, samplesOf(k, 4, cubic));
  REQUIRE(one.failed.empty());
  REQUIRE(other.failed.empty());
  for (int s = 1; s < 4; ++s)
    CHECK(largestDistance(one.shapes[s], aligned(other.shapes[s], one.shapes[s])) < 1e-5 * diagonalOf(k));
}

TEST_CASE("shells: a bent bar keeps its volume, and where the keys are moved, so are the shapes") {
  const Shape bar = box(1, 1, 10, 2, 2, 20);
  const Keyframes k = keyframes(bar, {bend(0), bend(radians(120))});
  const std::vector<ShellSample> samples = samplesOf(k, 4);
  const ShellShapes found = fitted(k, samples);
  const double whole = enclosedVolume(bar.positions, bar.faces);
  for (int s = 1; s < 4; ++s) CHECK(std::abs(enclosedVolume(found.shapes[s], bar.faces) / whole - 1) < 0.002);
  const Map move = turn({1, 2, -1}, 2.1, {3, -1, 2});
  Keyframes moved = k;
  for (Key& key : moved.keys) key.positions = mapped(key.positions, move);
  const ShellShapes there = fitted(moved, samplesOf(moved, 4));
  for (int s = 0; s <= 4; ++s)
    CHECK(largestDistance(mapped(found.shapes[s], move), there.shapes[s]) < 1e-8 * diagonalOf(k));
}

TEST_CASE("shells: the spline's energy is least, and its derivative agrees with differences") {
  const Keyframes k = rolledSheet(5);
  const Energies e = energiesOf(k, 8);
  CHECK(e.lengths < e.lri);
  CHECK(e.spline < e.lengths);
  const std::vector<ShellSample> samples = samplesOf(k, 8);
  const ShellShapes found = fitted(k, samples);
  const ShellMetric metric(k.faces, posesOf(k));
  auto system = ShellSystem::create(metric);
  REQUIRE(system.ok());
  std::vector<double> times;
  for (const ShellSample& s : samples) times.push_back(s.time);
  ShellSpline spline(*system, times, diagonalOf(k));
  std::vector<Positions> gradient;
  spline.energy(found.shapes, &gradient);
  Positions direction;
  for (const Vec3& p : found.shapes[3]) direction.push_back(Vec3(std::sin(9 * p.x()), std::cos(7 * p.y()), p.x()));
  std::vector<Positions> up = found.shapes, down = found.shapes;
  constexpr double step = 1e-5;
  addScaled(up[3], step, direction), addScaled(down[3], -step, direction);
  const double difference = (spline.energy(up) - spline.energy(down)) / (2 * step);
  CHECK(dot(gradient[3], direction) == doctest::Approx(difference).epsilon(1e-3));
}

TEST_CASE("shells: components, loose vertices, flat faces, seams and edges with three faces") {
  Shape shape = joined(box(1, 1, 4, 1, 1, 4), sphere({0, 0, 6}, 0.6, 4, 8));
  const int corners = static_cast<int>(shape.positions.size());
  shape.positions.emplace_back(0.2, 0.1, 2);                          // in no face
  shape.faces.push_back({0, 0, 1});                                   // two corners are one
  shape.faces.push_back({shape.faces[0][0], shape.faces[0][1], 20});  // a third face along an edge
  for (int c = 0; c < 3; ++c) shape.positions.push_back(shape.positions[shape.faces[5][c]]);
  shape.faces[5] = {corners + 1, corners + 2, corners + 3};  // copies at a seam
  const Keyframes k = keyframes(shape, {bend(0, 4), bend(0.8, 4), twist(0.7, 4)});
  for (const ShellMethod method : {ShellMethod::Lengths, ShellMethod::Spline}) {
    const std::vector<ShellSample> samples = samplesOf(k, 4);
    const ShellShapes found = fitted(k, samples, method);
    CHECK(found.failed.empty());
    for (std::size_t s = 0; s < samples.size(); ++s) {
      CHECK(largestDistance(found.shapes[s], samples[s].start) < 0.05 * diagonalOf(k));
      CHECK((found.shapes[s][corners] - samples[s].start[corners]).norm() < 1e-9);
      CHECK((found.shapes[s][corners + 1] - found.shapes[s][k.faces[4][0]]).norm() < diagonalOf(k));
    }
    CHECK(found.shapes[0] == k.keys[0].positions);
  }
}

TEST_CASE("shells: if a fit does not converge, its interval is that of LRI space") {
  const Keyframes k = keyframes(sheet(4), {roll(0.3, 1.5), roll(1.9, 1.5), roll(0.3, 1)});
  std::vector<ShellSample> samples = samplesOf(k, 6);
  samples[2].start[7].x() = std::numeric_limits<double>::quiet_NaN();
  const ShellShapes found = fitted(k, samples);
  REQUIRE(found.failed.size() == 1);
  CHECK(found.failed[0] == 1);
  CHECK(found.shapes[1] == samples[1].start);
  CHECK(found.shapes[4] != samples[4].start);
}

TEST_CASE("shells: a fit goes around shapes in which a triangle is flat, because angles jump there") {
  const Shape shape = sheet(3);
  std::vector<Positions> keys(2, shape.positions);
  Positions middle;
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const double phase = 3.0 * static_cast<double>(v);
    keys[0][v] += 0.1 * Vec3(std::cos(phase), std::cos(phase + 1), std::cos(phase + 2));
    keys[1][v] += 0.3 * Vec3(std::sin(phase + 1), std::sin(phase + 2), std::sin(phase + 3));
    middle.push_back((keys[0][v] + keys[1][v]) / 2);
  }
  const ShellMetric metric(shape.faces, keys);
  const std::vector<ShellMeasures> measures = metric.measuresOfKeys(keys);
  ShellMeasures target;
  for (std::size_t m = 0; m < measures[0].size(); ++m) target.push_back((measures[0][m] + measures[1][m]) / 2);
  auto system = ShellSystem::create(metric);
  REQUIRE(system.ok());
  const auto fit = fitShape(*system, target, middle, 1, [](const Positions&) { return true; });
  REQUIRE(fit);
  const auto least = [&](const Positions& at) {
    double area = 1;
    for (const Triangle& face : shape.faces) area = std::min(area, surfaceArea(at, {face}));
    return area;
  };
  CHECK(least(middle) > 0.005);
  CHECK(least(*fit) < 1e-5);
  const auto found = shellShapes(shape.faces, keys, {{0, {1, 0}, {}, 0}, {0.5, {0.5, 0.5}, middle}, {1, {0, 1}, {}, 1}},
                                 ShellMethod::Lengths);
  REQUIRE(found.ok());
  CHECK(found->failed.empty());
  CHECK(least(found->shapes[1]) > 1e-5);
  const auto residual = [&](const Positions& at) {
    return metric.squaredNorm(metric.difference(metric.measuresOf(at), target));
  };
  CHECK(residual(found->shapes[1]) < 0.5 * residual(middle));
}

TEST_CASE("shells: the spline goes on where a mean is not found, and its shapes stay") {
  const Keyframes k = rolledSheet(5);
  const std::vector<ShellSample> samples = samplesOf(k, 12);
  const ShellMetric metric(k.faces, posesOf(k));
  auto system = ShellSystem::create(metric);
  REQUIRE(system.ok());
  std::vector<double> times;
  std::vector<char> fixed;
  for (const ShellSample& s : samples) times.push_back(s.time), fixed.push_back(s.key >= 0);
  const std::vector<Positions> fits = fitted(k, samples).shapes;
  std::vector<Positions> shapes = fits;
  shapes[2][7] = shapes[2][8];
  const std::vector<char> unchanged = ShellSpline(*system, times, diagonalOf(k)).minimise(shapes, fixed);
  CHECK(unchanged == std::vector<char>{0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(shapes[3] == fits[3]);
  for (std::size_t s = 5; s < 12; ++s) CHECK(shapes[s] != fits[s]);
}

TEST_CASE("shells: a search that ends at its limit of steps says so") {
  const Keyframes far = keyframes(sheet(5), {roll(0.3, 7), roll(1.5, -7), roll(2.5, 7), roll(1.2, -7)}),
                  near = rolledSheet(5);
  CHECK(!fitted(far, samplesOf(far, 24), ShellMethod::Spline).finished);
  CHECK(fitted(near, samplesOf(near, 8), ShellMethod::Spline).finished);
  CHECK(fitted(far, samplesOf(far, 6)).finished);
}

TEST_CASE("shells: a shape follows its coarse mesh") {
  const Shape full = box(1, 1, 4, 4, 4, 16);
  // Here the coarse mesh is the full one.
  Leader leader{full.faces, {}, {}};
  for (int f = 0; f < static_cast<int>(full.faces.size()); ++f) leader.faceOf.push_back(f);
  for (int v = 0; v < static_cast<int>(full.positions.size()); ++v) leader.vertexOf.push_back(v);
  auto transfer = DeformationTransfer::create(full.faces, {full.positions}, leader);
  REQUIRE(transfer.ok());
  const Positions bent = mapped(full.positions, bend(1, 4)), more = mapped(full.positions, bend(1.3, 4));
  CHECK(largestDistance(transfer->follow(bent, bent, bent), bent) < 1e-11);
  CHECK(largestDistance(transfer->follow(bent, bent, more), more) < 1e-9);
  const Map move = turn({1, 2, -1}, 2.1, {3, -1, 2});
  CHECK(largestDistance(transfer->follow(bent, bent, mapped(bent, move)), mapped(bent, move)) < 1e-9);
}

TEST_CASE("shells: the bending energy of lengths and angles that are quadratic in time") {
  constexpr double slope = 0.3, curving = 0.7, step = 0.125;
  const auto square = [](double x) { return x * x; };
  const auto at = [&](double t) { return slope * t + curving * t * t; };
  const double known = square(2 * curving / at(1));  // x'' over the change between keys at 0 and 1

  // Lengths: a box that grows, and turns at the same time.
  const Shape ball = box(1, 1, 2, 2, 2, 4);
  const auto grown = [&](double t) {
    return mapped(ball.positions,
                  [&](const Vec3& p) { return turn({1, 2, -1}, 5 * t, {3 * t, 0, t})((1 + at(t)) * p); });
  };
  const auto lengths = ShellBending::create(ball.faces, {grown(0), grown(1)});
  REQUIRE(lengths.ok());
  // An angle: two triangles that fold beyond 180 degrees.
  const auto folded = [&](double t) {
    const double angle = 2.9 + at(t);
    return Positions{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -std::cos(angle), std::sin(angle)}};
  };
  const auto angle = ShellBending::create({{0, 1, 2}, {1, 0, 3}}, {folded(0), folded(1)});
  REQUIRE(angle.ok());
  for (const double t : {0.2, 0.5, 0.77}) {
    const auto energyOf = [&](const ShellBending& bending, const auto& shape) {
      return bending.energy(bending.measuresOf(shape(t - step)), bending.measuresOf(shape(t)),
                            bending.measuresOf(shape(t + step)), step);
    };
    CHECK(energyOf(*lengths, grown) == doctest::Approx(known).epsilon(1e-9));
    CHECK(energyOf(*angle, folded) == doctest::Approx(known).epsilon(1e-9));
  }
  const auto resting = ShellBending::create(ball.faces, {grown(0), grown(0)});
  const ShellMeasures rest = resting->measuresOf(grown(0));
  CHECK(resting->energy(rest, rest, rest, step) == 0);
  CHECK(!ShellBending::create({{0, 1, 1}}, {folded(0), folded(1)}).ok());
}

TEST_CASE("shells: real sheets and bodies" * dense) {
  const std::vector<std::string> plates = {"turns/plate/plate121_rolledA.ply", "turns/plate/plate121_rolledB.ply"};
  if (!hasData(plates)) return;
  const Keyframes k = realKeyframes(plates);
  const std::vector<ShellSample> samples = samplesOf(k, 24);
  const ShellShapes found = fitted(k, samples);
  CHECK(found.failed.empty());
  Sequence lri = sequenceOf(k, doublePrecision()), sequence = motionThrough(k, samples, found);
  MESSAGE("lengths off their spline: " << lengthError(lri, k) << " % in LRI space, " << lengthError(sequence, k)
                                       << " % fitted");
  CHECK(lengthError(sequence, k) < 1);
  const Energies plate = energiesOf(k, 16);
  MESSAGE("energies of the plate: " << plate.lri << ", " << plate.lengths << ", " << plate.spline);
  CHECK(plate.lengths < plate.lri);
  const ShellMetric metric(k.faces, posesOf(k));
  const std::vector<ShellMeasures> measures = metric.measuresOfKeys(posesOf(k));
  // Between two keys, the spline is a geodesic, whose energy is 0.
  CHECK(plate.spline < 1e-5 * metric.squaredNorm(metric.difference(measures[1], measures[0])));
}

TEST_CASE("shells: the saddle halfway between its keys is fitted" * dense) {
  const std::vector<std::string> saddle = {"turns/saddle/monkey_saddle_1.ply", "turns/saddle/monkey_saddle_2.ply"};
  if (!hasData(saddle)) return;
  const Keyframes k = realKeyframes(saddle);
  const ShellMetric metric(k.faces, posesOf(k));
  const std::vector<ShellMeasures> keys = metric.measuresOfKeys(posesOf(k));
  ShellMeasures target;
  for (std::size_t m = 0; m < keys[0].size(); ++m) target.push_back((keys[0][m] + keys[1][m]) / 2);
  const auto residual = [&](const Positions& shape) {
    return metric.squaredNorm(metric.difference(metric.measuresOf(shape), target));
  };
  const std::vector<ShellSample> samples = samplesOf(k, 2);
  const ShellShapes found = fitted(k, samples);
  CHECK(found.failed.empty());
  MESSAGE("residuals halfway: " << residual(samples[1].start) << " in LRI space, " << residual(found.shapes[1]));
  CHECK(residual(found.shapes[1]) < 0.15);
}

}  // namespace shapespline::test::shells_test
