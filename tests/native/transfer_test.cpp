// Shapes that follow a ghost mesh agree with those without; invariants_test.cpp has the properties of both.
#include <doctest/doctest.h>

#include "core/ghost/correspondence.h"
#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "kg_error.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::transfer_test {

namespace {

EncodingOptions ghostly(int faces = 1000, Transfer transfer = Transfer::Exact) {
  EncodingOptions options = doublePrecision();
  options.ghostFaces = faces;
  options.transfer = transfer;
  return options;
}

Sequence make(const Keyframes& k, const EncodingOptions& encoding = ghostly(), const MotionOptions& motion = {}) {
  return sequenceOf(k, encoding, motion);
}

Positions ghostAt(Sequence& sequence, double t) {
  std::vector<float> xyz;
  REQUIRE(sequence.evaluateGhost(t, xyz).ok());
  return toPositions(xyz);
}

/// The bar 1 x 1 x 10, much finer than a ghost of 1000 faces.
Shape fineBar() { return box(1, 1, 10, 8, 8, 80); }

Keyframes bentFineBar(const std::vector<double>& degrees) { return bentBar(degrees, fineBar()); }
Keyframes twistedFineBar(const std::vector<double>& degrees) { return twistedBar(degrees, fineBar()); }

const std::vector<double> slider = {-0.4, -0.05, 0.13, 0.5, 0.77, 1.1, 1.4};

/// KG error (centroids) of the sequence with a ghost relative to the one without, over the keys' range.
double errorOfGhost(const Keyframes& k, const EncodingOptions& encoding) {
  EncodingOptions without = encoding;
  without.ghostFaces = 0;
  Sequence plain = make(k, without), led = make(k, encoding);
  std::vector<Positions> a, b;
  for (int i = 0; i <= 30; ++i) {
    const double t = k.keys.front().time + (k.keys.back().time - k.keys.front().time) * i / 30;
    a.push_back(shapeAt(plain, t));
    b.push_back(shapeAt(led, t));
  }
  return kgError(a, b);
}

double worstKey(Sequence& s, const Keyframes& k) {
  double worst = 0;
  for (const Key& key : k.keys) worst = std::max(worst, largestDistance(shapeAt(s, key.time), key.positions));
  return worst / diagonalOf(k);
}

}  // namespace

TEST_CASE("ghost: the distance to a triangle is the distance to its nearest point") {
  const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  CHECK(squaredDistance({0.5, 0.5, 3}, a, b, c) == doctest::Approx(9));
  CHECK(squaredDistance({-3, -4, 0}, a, b, c) == doctest::Approx(25));
  CHECK(squaredDistance({1, -2, 1}, a, b, c) == doctest::Approx(5));
  CHECK(squaredDistance({2, 2, 0}, a, b, c) == doctest::Approx(2));
  CHECK(squaredDistance({5, 0, 0}, a, b, c) == doctest::Approx(9));
  CHECK(squaredDistance({3, 0, 0}, a, b, b) == doctest::Approx(1));  // a triangle without area
}

TEST_CASE("ghost: a sequence describes its ghost") {
  const Keyframes k = bentFineBar({0, 70, -120});
  for (const bool optimal : {false, true}) {
    EncodingOptions options = ghostly(600);
    options.optimalPlacement = optimal;
    Sequence s = make(k, options);
    const Ghost& ghost = s.encoded().lri().ghost();
    const SequenceStats stats = s.stats();
    CHECK(stats.ghostFaces == int(ghost.faces.size()));
    CHECK(stats.ghostFaces <= 600);
    CHECK(stats.ghostFaces >= 599);
    CHECK(stats.ghostVertices == int(ghost.vertexOf.size()));
    CHECK(stats.patches == doctest::Approx(600 / 16).epsilon(0.1));
    REQUIRE(ghost.ghostVertexOf.size() == k.keys[0].positions.size());
    REQUIRE(ghost.ghostFaceOf.size() == k.faces.size());
    for (int g : ghost.ghostFaceOf) CHECK((g >= 0 && g < stats.ghostFaces));
    for (const Key& key : k.keys) {
      const Positions p = ghostAt(s, key.time);
      REQUIRE(p.size() == ghost.vertexOf.size());
      for (std::size_t g = 0; g < p.size(); ++g) {
        const double distance = (p[g] - key.positions[ghost.vertexOf[g]]).norm();
        CHECK(distance < (optimal ? 0.3 : 1e-5));  // the cell size is 0.125
        CHECK(ghost.ghostVertexOf[ghost.vertexOf[g]] == int(g));
      }
      // Every face must follow a nearby ghost face.
      for (std::size_t f = 0; f < k.faces.size(); ++f) {
        const Triangle& t = ghost.faces[ghost.ghostFaceOf[f]];
        const Triangle& u = k.faces[f];
        const Vec3 centroid = (key.positions[u[0]] + key.positions[u[1]] + key.positions[u[2]]) / 3;
        CHECK(squaredDistance(centroid, p[t[0]], p[t[1]], p[t[2]]) < 0.3 * 0.3);
      }
    }
    // Patches of the shape are those of the ghost.
    for (int patch : s.encoded().lri().patchOfInputFace()) CHECK((patch >= 0 && patch < stats.patches));
  }
}

TEST_CASE("ghost: end tangents that are shapes") {
  const Keyframes k = bentFineBar({0, 70, 100});
  EncodingOptions options = ghostly(800);
  options.startTangent = mapped(fineBar().positions, twist(radians(60)));
  options.endTangent = mapped(fineBar().positions, bend(radians(80)));
  MotionOptions motion;
  motion.boundary = BoundaryKind::Hermite;
  Sequence led = make(k, options, motion);
  CHECK(worstKey(led, k) < 1e-9);
  options.ghostFaces = 0;
  Sequence plain = make(k, options, motion);
  CHECK(largestDistance(shapeAt(plain, 0.2), shapeAt(led, 0.2)) < 0.005 * diagonalOf(k));
}

TEST_CASE("ghost: stays close to the shape without a ghost") {
  for (const Keyframes& k : {bentFineBar({0, 70, -50, 120}), twistedFineBar({0, 120, 240})}) {
    const double exact = errorOfGhost(k, ghostly(2000)), coarse = errorOfGhost(k, ghostly(500));
    const double paper = errorOfGhost(k, ghostly(2000, Transfer::Paper));
    MESSAGE("KG against no ghost: exact " << exact << " (500 faces: " << coarse << "), paper " << paper);
    CHECK(exact <= 1);
    CHECK(coarse <= 3);
    CHECK(paper <= 5);
    CHECK(exact > 0);
  }
}

TEST_CASE("ghost: of the cactus with 2,000 faces: KG 1 exact, 5 as published; keys in exact") {
  const std::vector<std::string> poses = {"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"};
  if (!hasData(poses)) return;
  const Keyframes k = realKeyframes(poses);
  for (const bool optimal : {false, true}) {
    EncodingOptions options = ghostly(2000);
    options.optimalPlacement = optimal;
    const double exact = errorOfGhost(k, options);
    options.transfer = Transfer::Paper;
    const double paper = errorOfGhost(k, options);
    MESSAGE(std::string(optimal ? "optimal placement" : "half-edge") << ": exact " << exact << ", paper " << paper);
    CHECK(exact <= 1);
    CHECK(paper <= 5);
  }
  Sequence s = make(k, ghostly(2000));
  CHECK(worstKey(s, k) < 1e-9);
  EncodingOptions single = ghostly(2000);
  single.precision = Precision::Single;
  Sequence inSingle = make(k, single);
  for (const Key& key : k.keys) {
    Frame frame;
    REQUIRE(inSingle.evaluate(key.time, frame).ok());
    CHECK(largestDistance(toPositions(frame.positions), key.positions) < 1e-5 * diagonalOf(k));
  }
}

TEST_CASE("ghost: the paper's transfer passes through the reference, and near the other keys") {
  const Keyframes k = bentFineBar({0, 70, -50});
  EncodingOptions options = ghostly(1000, Transfer::Paper);
  options.reference = 1;
  Sequence s = make(k, options);
  CHECK(largestDistance(shapeAt(s, 0.5), k.keys[1].positions) < 1e-9 * diagonalOf(k));
  const double other = largestDistance(shapeAt(s, 0), k.keys[0].positions) / diagonalOf(k);
  CHECK(other < 0.02);
  CHECK(other > 1e-6);  // otherwise this would not test the mode
}

TEST_CASE("ghost: faces without area, loose vertices and repeated faces") {
  Shape shape = fineBar();
  const int n = static_cast<int>(shape.positions.size());
  shape.positions.emplace_back(0.5, 0.9, 5);  // an unused vertex
  shape.positions.emplace_back(0.5, 0.7, 5);  // in a face without area
  shape.faces.push_back({n + 1, n + 1, 0});
  shape.faces.push_back(shape.faces[7]);
  shape.faces.push_back({shape.faces[9][0], shape.faces[9][2], shape.faces[9][1]});
  const Keyframes k = keyframes(shape, {bend(0), bend(radians(60)), bend(radians(130))});
  for (const Transfer transfer : {Transfer::Exact, Transfer::Paper}) {
    Sequence s = make(k, ghostly(700, transfer));
    if (transfer == Transfer::Exact) CHECK(worstKey(s, k) < 1e-9);
    CHECK(s.encoded().lri().ghost().ghostVertexOf[n] == -1);
    CHECK(s.encoded().lri().ghost().ghostFaceOf[shape.faces.size() - 3] == -1);
    CHECK(s.encoded().lri().ghost().ghostFaceOf.back() >= 0);
    for (double t : slider)
      for (const Vec3& p : shapeAt(s, t)) CHECK(p.allFinite());
  }
}

TEST_CASE("ghost: seams are welded, and all copies move") {
  Shape shape = fineBar();
  // Gives every face separate vertices.
  Shape split;
  for (const Triangle& t : shape.faces) {
    const int first = static_cast<int>(split.positions.size());
    for (int v : t) split.positions.push_back(shape.positions[v]);
    split.faces.push_back({first, first + 1, first + 2});
  }
  const Keyframes whole = bentFineBar({0, 70, -120}),
                  k = keyframes(split, {bend(0), bend(radians(70)), bend(radians(-120))});
  Sequence a = make(whole), b = make(k);
  CHECK(b.encoded().lri().ghost().vertexOf.size() == a.encoded().lri().ghost().vertexOf.size());
  CHECK(b.encoded().lri().ghost().ghostVertexOf.size() == split.positions.size());
  for (int v : b.encoded().lri().ghost().vertexOf) CHECK((v >= 0 && v < int(split.positions.size())));
  CHECK(worstKey(b, k) < 1e-9);
  const Positions p = shapeAt(b, 0.3);
  std::map<std::array<double, 3>, int> copies;
  for (const Vec3& q : p) ++copies[{q.x(), q.y(), q.z()}];
  CHECK(copies.size() == shape.positions.size());
}

TEST_CASE("ghost: a frame and the ghost's own shape are timed separately") {
  Sequence s = make(bentFineBar({0, 70}));
  Frame frame;
  REQUIRE(s.evaluate(0.4, frame).ok());
  const SequenceStats exact = s.stats();
  CHECK(exact.localFramesMs > 0);
  CHECK(exact.facesMs > 0);
  CHECK(exact.ghostMs == 0);  // its shape was not requested
  std::vector<float> ghost;
  REQUIRE(s.evaluateGhost(0.4, ghost).ok());
  CHECK(s.stats().ghostMs > 0);
  CHECK(s.stats().localFramesMs == exact.localFramesMs);
}

TEST_CASE("ghost: invalid options and options without effect") {
  const Keyframes k = keyframes(box(1, 1, 2, 2, 2, 4), {bend(0, 2), bend(1, 2)});
  for (int faces : {-1, 1, 3}) {
    const auto sequence = Sequence::create(k, ghostly(faces), {});
    REQUIRE(!sequence.ok());
    CHECK(sequence.error().code == ErrorCode::InvalidOption);
  }
  Sequence s = make(k, ghostly(5000)), plain = make(k, doublePrecision());
  CHECK(s.stats().ghostFaces == 0);
  CHECK(s.encoded().lri().ghost().faces.empty());
  CHECK(std::any_of(s.warnings().begin(), s.warnings().end(), [](const Warning& w) { return w.code == "ghost-off"; }));
  CHECK(plain.warnings().empty());
  CHECK(shapeAt(s, 0.3) == shapeAt(plain, 0.3));
  std::vector<float> xyz;
  const Status status = s.evaluateGhost(0.5, xyz);
  REQUIRE(!status.ok());
  CHECK(status.error().code == ErrorCode::InvalidOption);
}

TEST_CASE("ghost: progress never decreases, for the shape and for its space") {
  double last = 0;
  std::vector<std::string> stages;
  const auto sequence =
      Sequence::create(bentFineBar({0, 70}), ghostly(500), {}, [&](const char* stage, double fraction) {
        if (stages == std::vector<std::string>{"welding"} && stages.back() != stage) {
          CHECK(last == 1);
          last = 0;
        }
        CHECK(fraction >= last);
        last = fraction;
        if (stages.empty() || stages.back() != stage) stages.push_back(stage);
      });
  CHECK(last == 1);
  CHECK(stages ==
        std::vector<std::string>{"welding", "simplifying", "matching", "encoding", "ordering", "factorising"});
}

}  // namespace shapespline::test::transfer_test
