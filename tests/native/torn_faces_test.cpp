// Faces that the keys stretch far, such as the membrane of a mouth, carry no rotation.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/lri/torn_faces.h"
#include "core/rotation/rigid_fit.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"
#include "shapes/random.h"

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
  Random random(7);
  Positions open = closed;
  for (int v = 0; v < static_cast<int>(open.size()); ++v) {
    if (isUpper(v)) continue;
    const Vec3 below = hinge + turn * (closed[v] - hinge);
    const Vec3 wander = angle / 20 * Vec3(1.5 * random.signedUnit(), 3 * random.signedUnit(), 3 * random.signedUnit());
    open[v] = isLower(v) ? below : Vec3((closed[v] + below) / 2 + wander);
  }
  return open;
}

Keyframes keyframesOf(const Shape& shape, const std::vector<Positions>& poses) {
  Keyframes k = keyframes(shape, std::vector<Map>(poses.size(), bend(0)));
  for (std::size_t j = 0; j < poses.size(); ++j) k.keys[j].positions = poses[j];
  return k;
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

ShapeTopology topologyOf(const Shape& shape, const std::vector<Positions>& poses) {
  WeldedShape welded;
  welded.faces = shape.faces;
  welded.poses = poses;
  welded.keys = static_cast<int>(poses.size());
  return shapespline::topologyOf(welded);
}

const std::vector<std::string> facePoses = {"turns/face/1.ply", "turns/face/2.ply", "turns/face/3.ply"};

Keyframes twoKeys(Keyframes k, int first) {
  k.keys = {k.keys[first], k.keys[first + 1]};
  return k;
}

// Vertices of the forehead and of the jaw: half of the largest part that no torn face joins to others, and the second.
struct Parts {
  std::vector<int> forehead, jaw;
};

Parts partsOf(const Keyframes& face) {
  std::vector<Positions> poses;
  for (const Key& key : face.keys) poses.push_back(key.positions);
  const Shape shape{poses[0], face.faces};
  const ShapeTopology topology = topologyOf(shape, poses);
  std::vector<int> faces(topology.components.count, 0), partOf(shape.positions.size(), -1);
  topology.eachUsedFace([&](int f) {
    ++faces[topology.components.ofFace[f]];
    for (const int v : shape.faces[f]) partOf[v] = topology.components.ofFace[f];
  });
  const auto largest = std::max_element(faces.begin(), faces.end());
  const int head = static_cast<int>(largest - faces.begin());
  *largest = 0;
  const int jaw = static_cast<int>(std::max_element(faces.begin(), faces.end()) - faces.begin());
  Parts parts;
  for (std::size_t v = 0; v < partOf.size(); ++v) {
    if (partOf[v] == head) parts.forehead.push_back(static_cast<int>(v));
    if (partOf[v] == jaw) parts.jaw.push_back(static_cast<int>(v));
  }
  Vec3 centre = Vec3::Zero();
  for (const int v : parts.jaw) centre += shape.positions[v] / static_cast<double>(parts.jaw.size());
  const auto far = [&](int v) { return (shape.positions[v] - centre).norm(); };
  std::sort(parts.forehead.begin(), parts.forehead.end(), [&](int a, int b) { return far(a) > far(b); });
  parts.forehead.resize(parts.forehead.size() / 2);
  return parts;
}

double turnBetween(const Parts& parts, const Positions& from, const Positions& to) {
  const auto rotation = [&](const std::vector<int>& vertices) {
    Positions a, b;
    for (const int v : vertices) a.push_back(from[v]), b.push_back(to[v]);
    return Quaternion(fitRigid(a, b).rotation);
  };
  return 180 / pi * rotation(parts.forehead).angularDistance(rotation(parts.jaw));
}

// The largest error of the edge lengths at any of these times. Times count intervals between the keys. The error is the
// rms, over the edges, of the distance from the spline of the keys' lengths, in % of the mean length in the keys.
double worstEdges(const Keyframes& k, const std::vector<double>& times,
                  const EncodingOptions& options = doublePrecision()) {
  const auto lengths = [&](const Positions& p) {
    std::vector<double> result;
    for (const Triangle& t : k.faces)
      for (int i = 0; i < 3; ++i) result.push_back((p[t[i]] - p[t[(i + 1) % 3]]).norm());
    return result;
  };
  std::vector<std::vector<double>> ofKeys;
  for (const Key& key : k.keys) ofKeys.push_back(lengths(key.positions));
  Sequence sequence = sequenceOf(k, options);
  const double start = k.keys[0].time, step = k.keys[1].time - start;
  double worst = 0;
  for (const double time : times) {
    const std::vector<double> weights =
        poseWeights(sequence.motion().at(start + time * step), {static_cast<int>(k.keys.size())}).column;
    const std::vector<double> now = lengths(shapeAt(sequence, start + time * step));
    double squares = 0;
    for (std::size_t e = 0; e < now.size(); ++e) {
      double wanted = 0, mean = 0;
      for (std::size_t j = 0; j < ofKeys.size(); ++j)
        wanted += weights[j] * ofKeys[j][e], mean += ofKeys[j][e] / static_cast<double>(ofKeys.size());
      squares += std::pow((now[e] - wanted) / mean, 2);
    }
    worst = std::max(worst, 100 * std::sqrt(squares / static_cast<double>(now.size())));
  }
  return worst;
}

// Edges, and distances from the blend of vertices.
void checkFace(const Keyframes& k, const std::vector<double>& times,
               const EncodingOptions& options = doublePrecision()) {
  CHECK(worstEdges(k, times, options) < 4.5);
  MotionOptions blend;
  blend.method = Method::CubicVertex;
  Sequence lri = sequenceOf(k, options), vertices = sequenceOf(k, options, blend);
  const double diagonal = boundingDiagonal(std::vector<const Positions*>{&k.keys[0].positions});
  const double start = k.keys[0].time, step = k.keys[1].time - start;
  for (const double t : times) {
    const Positions a = shapeAt(lri, start + t * step), b = shapeAt(vertices, start + t * step);
    double mean = 0;
    for (std::size_t v = 0; v < a.size(); ++v) mean += (a[v] - b[v]).norm() / static_cast<double>(a.size());
    CAPTURE(t);
    CHECK(largestDistance(a, b) < 0.09 * diagonal);
    CHECK(mean < 0.018 * diagonal);
  }
}

}  // namespace

TEST_CASE("parts that only torn faces join keep their shapes and share their rotation evenly") {
  const Shape shape = plates();
  const Keyframes keys = keyframesOf(shape, {shape.positions, opened(shape.positions, 20)});
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
        CHECK(worstEdge(shape, now) < 0.1);
      }
      for (const int key : {0, 1}) CHECK(turnOfLower(keys.keys[key].positions, shapeAt(sequence, key)) < 0.01);
    }
}

TEST_CASE("keys with torn faces are exact in every method, with a ghost mesh and without") {
  const Shape shape = plates();
  const Keyframes keys =
      keyframesOf(shape, {opened(shape.positions, 10), shape.positions, opened(shape.positions, 25)});
  for (const int ghost : {0, 150})
    for (const Transfer transfer : {Transfer::Exact, Transfer::Paper})
      for (const Method method : {Method::Lri, Method::Geodesic, Method::RotationStrain, Method::Rimd}) {
        if (transfer == Transfer::Paper && (ghost == 0 || method != Method::Lri)) continue;
        EncodingOptions options = doublePrecision();
        options.ghostFaces = ghost;
        options.transfer = transfer;
        MotionOptions motion;
        motion.method = method;
        Sequence sequence = sequenceOf(keys, options, motion);
        CHECK(sequence.stats().components == 1);
        CAPTURE(ghost);
        CAPTURE(int(method));
        for (const Key& key : keys.keys) {
          const double error = largestDistance(shapeAt(sequence, key.time), key.positions) / diagonalOf(keys);
          CHECK(error < (transfer == Transfer::Paper ? 0.1 : 1e-8));
        }
      }
}

TEST_CASE("a face becomes torn gradually as the poses move apart") {
  const Shape shape = plates();
  std::vector<double> before(shape.faces.size(), 0);
  double largestStep = 0;
  for (double angle = 0; angle <= 20; angle += 0.002) {
    std::vector<double> torn = topologyOf(shape, {shape.positions, opened(shape.positions, angle)}).torn;
    torn.resize(before.size(), 0);
    for (std::size_t f = 0; f < torn.size(); ++f) largestStep = std::max(largestStep, std::abs(torn[f] - before[f]));
    before = torn;
  }
  CHECK(*std::max_element(before.begin(), before.end()) == 1);
  CHECK(largestStep < 0.2);
}

TEST_CASE("bent, twisted and scaled shapes have no torn faces") {
  const Shape shape = bar();
  Positions bent, larger;
  for (const Vec3& p : shape.positions) bent.push_back(bend(2)(p)), larger.push_back(100 * p);
  CHECK(topologyOf(shape, {shape.positions, bent, larger}).torn.empty());
}

TEST_CASE("a face with a closed mouth in one key keeps its edges, its jaw and its keys") {
  if (!hasData(facePoses)) return;
  const Keyframes face = realKeyframes(facePoses);
  checkFace(face, {0.25, 0.5, 0.75, 1.25, 1.5, 1.75});
  for (const int first : {0, 1}) checkFace(twoKeys(face, first), {0.25, 0.5, 0.75});
  EncodingOptions ghost = doublePrecision();
  ghost.ghostFaces = 2000;
  checkFace(face, {0.25, 0.5, 0.75, 1.25, 1.5, 1.75}, ghost);

  Sequence sequence = sequenceOf(face, doublePrecision());
  for (const Key& key : face.keys)
    CHECK(largestDistance(shapeAt(sequence, key.time), key.positions) < 1e-9 * diagonalOf(face));
  const Parts parts = partsOf(face);
  const double start = face.keys[0].time, step = face.keys[1].time - start;
  for (const double t : {0.25, 0.5}) {
    const double turn = turnBetween(parts, face.keys[0].positions, shapeAt(sequence, start + t * step));
    CHECK(turn > 5);
    CHECK(turn < 15);
  }
}

TEST_CASE("the motion of a torn face does not depend on the order, a mirror, the numbering or noise") {
  if (!hasData(facePoses)) return;
  const Keyframes face = realKeyframes(facePoses);
  const double diagonal = diagonalOf(face), sum = face.keys.front().time + face.keys.back().time;
  Keyframes reversed = face, mirrored = face, renumbered = face, noisy = face;
  std::reverse(reversed.keys.begin(), reversed.keys.end());
  for (Key& key : reversed.keys) key.time = sum - key.time;
  for (Key& key : mirrored.keys)
    for (Vec3& p : key.positions) p.x() = -p.x();
  const int last = face.vertexCount() - 1;
  for (Key& key : renumbered.keys) std::reverse(key.positions.begin(), key.positions.end());
  for (Triangle& t : renumbered.faces) t = {last - t[1], last - t[2], last - t[0]};
  std::reverse(renumbered.faces.begin(), renumbered.faces.end());
  Random random(3);
  for (Key& key : noisy.keys)
    for (Vec3& p : key.positions)
      p += 1e-6 * diagonal * Vec3(random.signedUnit(), random.signedUnit(), random.signedUnit());

  EncodingOptions lastKey = doublePrecision();
  lastKey.reference = 2;
  Sequence sequence = sequenceOf(face, doublePrecision()), back = sequenceOf(reversed, lastKey),
           mirror = sequenceOf(mirrored, doublePrecision()), other = sequenceOf(renumbered, doublePrecision()),
           moved = sequenceOf(noisy, doublePrecision());
  for (const double share : {0.125, 0.25, 0.625, 0.875}) {
    const double t = face.keys[0].time + share * (face.keys[2].time - face.keys[0].time);
    const Positions now = shapeAt(sequence, t);
    CHECK(largestDistance(shapeAt(back, sum - t), now) < 1e-6 * diagonal);
    Positions x = shapeAt(mirror, t);
    for (Vec3& p : x) p.x() = -p.x();
    CHECK(largestDistance(x, now) < 1e-6 * diagonal);
    x = shapeAt(other, t);
    std::reverse(x.begin(), x.end());
    CHECK(largestDistance(x, now) < 1e-6 * diagonal);
    CHECK(largestDistance(shapeAt(moved, t), now) < 0.01 * diagonal);
  }
}

TEST_CASE("a face that rolls up by 200 degrees keeps its edges as well as one that does not") {
  if (!hasData(facePoses)) return;
  Keyframes face = twoKeys(realKeyframes(facePoses), 0);
  const double flat = worstEdges(face, {0.25, 0.5, 0.75});
  Vec3 low = face.keys[1].positions[0], high = low;
  for (const Vec3& p : face.keys[1].positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  for (int step = 1; step <= 10; ++step) {
    // Around an axle behind the head, which the height becomes an arc of.
    const double angle = step * radians(20), radius = (high - low).y() / angle;
    Keyframes rolled = face, turned = face;
    for (Vec3& p : rolled.keys[1].positions) {
      const double a = (p.y() - low.y()) / radius, r = radius + p.z() - low.z();
      p = Vec3(p.x(), r * std::sin(a), r * std::cos(a));
    }
    turned.keys[1].positions = mapped(face.keys[1].positions, turn(Vec3(1, 0.3, 0), angle));
    CAPTURE(step);
    CHECK(worstEdges(rolled, {0.25, 0.5, 0.75}) < 1.3 * flat);
    CHECK(worstEdges(turned, {0.25, 0.5, 0.75}) < 1.01 * flat);
  }
}

}  // namespace shapespline::test::torn_faces_test
