// Faces that the keys stretch far, such as the membrane of a mouth, carry no rotation.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "core/lri/torn_faces.h"
#include "core/rotation/rigid_fit.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::torn_faces_test {

namespace {

// Two plates joined by three rows of a membrane. A closed mouth: the plates almost touch. An open one: the lower plate
// has rotated by `angle` about a hinge behind it, and the inner vertices of the membrane lie at random places.
constexpr int columns = 16, rows = 23, upperRows = 10, membraneRows = 3;

Shape plates() {
  Shape shape;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double gap = 0.004 * std::clamp(j - upperRows + 1, 0, membraneRows);
      const int solid = j < upperRows ? j : std::max(upperRows - 1, j - membraneRows);
      shape.positions.emplace_back(i, -solid - gap, 0.2 * std::sin(i + 0.7 * j));
    }
  const auto at = [](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      shape.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      shape.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return shape;
}

bool isUpper(int v) { return v / (columns + 1) < upperRows; }
bool isLower(int v) { return v / (columns + 1) >= upperRows + membraneRows - 1; }

Positions opened(const Positions& closed, double angle) {
  const Vec3 hinge(0, -upperRows, -20);
  const Quaternion turn(Eigen::AngleAxisd(radians(angle), Vec3::UnitX()));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-0.5, 0.5);
  Positions open = closed;
  for (int v = 0; v < static_cast<int>(open.size()); ++v) {
    if (isUpper(v)) continue;
    const Vec3 below = hinge + turn * (closed[v] - hinge);
    const Vec3 wander = angle / 20 * Vec3(3 * anywhere(random), 6 * anywhere(random), 6 * anywhere(random));
    open[v] = isLower(v) ? below : Vec3((closed[v] + below) / 2 + wander);
  }
  return open;
}

double turnOfLower(const Positions& from, const Positions& to) {
  Positions a, b, c, d;
  for (int v = 0; v < static_cast<int>(from.size()); ++v) {
    if (isUpper(v)) a.push_back(from[v]), b.push_back(to[v]);
    if (isLower(v)) c.push_back(from[v]), d.push_back(to[v]);
  }
  return 180 / pi * Quaternion(fitRigid(a, b).rotation).angularDistance(Quaternion(fitRigid(c, d).rotation));
}

// Largest change of an edge of both plates, relative to its length.
double worstEdge(const Shape& shape, const Positions& now) {
  double worst = 0;
  for (const Triangle& t : shape.faces)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (!(isUpper(a) && isUpper(b)) && !(isLower(a) && isLower(b))) continue;
      const double length = (shape.positions[a] - shape.positions[b]).norm();
      worst = std::max(worst, std::abs((now[a] - now[b]).norm() / length - 1));
    }
  return worst;
}

std::vector<double> sharesOf(const Shape& shape, const std::vector<Positions>& poses) {
  WeldedShape welded{.faces = shape.faces, .poses = poses, .keys = static_cast<int>(poses.size()), .closing = {}};
  return topologyOf(welded).torn;
}

}  // namespace

TEST_CASE("parts that only torn faces join keep their shapes and share their rotation evenly") {
  const Shape shape = plates();
  Keyframes keys{shape.faces, {{"closed", 0, shape.positions, {}}, {"open", 1, opened(shape.positions, 20), {}}}};
  for (const int reference : {0, 1})
    for (const Stretch stretch : {Stretch::Linear, Stretch::Log}) {
      EncodingOptions options;
      options.reference = reference;
      options.stretch = stretch;
      Sequence sequence = sequenceOf(keys, options);
      for (const double t : {0.25, 0.5, 0.75}) {
        const Positions now = shapeAt(sequence, t);
        CAPTURE(t);
        CHECK(turnOfLower(shape.positions, now) == doctest::Approx(20 * t).epsilon(0.05));
        CHECK(worstEdge(shape, now) < 0.05);
      }
      for (const int key : {0, 1}) CHECK(turnOfLower(keys.keys[key].positions, shapeAt(sequence, key)) < 0.01);
    }
}

TEST_CASE("a face becomes torn gradually as the poses move apart") {
  const Shape shape = plates();
  std::vector<double> before(shape.faces.size(), 0);
  double largestStep = 0;
  for (double angle = 0; angle <= 20; angle += 0.002) {
    std::vector<double> torn = sharesOf(shape, {shape.positions, opened(shape.positions, angle)});
    torn.resize(before.size(), 0);
    for (std::size_t f = 0; f < torn.size(); ++f) largestStep = std::max(largestStep, std::abs(torn[f] - before[f]));
    before = torn;
  }
  CHECK(*std::max_element(before.begin(), before.end()) == 1);
  CHECK(largestStep < 0.1);
}

TEST_CASE("bent, twisted and scaled shapes have no torn faces") {
  const Shape shape = bar();
  Positions bent, larger;
  for (const Vec3& p : shape.positions) bent.push_back(bend(2)(p)), larger.push_back(100 * p);
  CHECK(sharesOf(shape, {shape.positions, bent, larger}).empty());
}

TEST_CASE("a face with a closed mouth in one key keeps its jaw") {
  if (!hasData({"turns/face/1.ply"})) return;
  const Keyframes keys = realKeyframes({"turns/face/1.ply", "turns/face/2.ply", "turns/face/3.ply"});
  const double diagonal = boundingDiagonal(std::vector<const Positions*>{&keys.keys[0].positions});
  MotionOptions cubic;
  cubic.method = Method::CubicVertex;
  Sequence lri = sequenceOf(keys, {}), vertices = sequenceOf(keys, {}, cubic);
  const double start = keys.keys[0].time, step = keys.keys[1].time - start;
  for (const double t : {0.25, 0.5, 0.75, 1.25, 1.5, 1.75}) {
    const Positions a = shapeAt(lri, start + t * step), b = shapeAt(vertices, start + t * step);
    double worst = 0, mean = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
      worst = std::max(worst, (a[v] - b[v]).norm() / diagonal);
      mean += (a[v] - b[v]).norm() / diagonal / static_cast<double>(a.size());
    }
    CAPTURE(t);
    CHECK(worst < 0.09);
    CHECK(mean < 0.018);
  }
}

}  // namespace shapespline::test::torn_faces_test
