// The cheap shape for while a slider moves, and the same motion at two resolutions.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/sequence/mesh_report.h"
#include "core/sequence/sequence.h"
#include "io/import.h"
#include "samples/bench_mesh.h"
#include "samples/sample_file.h"
#include "shapes.h"

using namespace shapespline;
using namespace shapespline::test;

namespace {

struct Distances {
  double mean = 0, largest = 0;
};

// Over the diagonal of the keys' box; the first `count` vertices.
Distances distances(const Frame& a, const Frame& b, std::size_t count, double diagonal) {
  Distances d;
  for (std::size_t v = 0; v < count; ++v) {
    double squared = 0;
    for (int k = 0; k < 3; ++k) squared += std::pow(double(a.positions[3 * v + k]) - b.positions[3 * v + k], 2);
    const double distance = std::sqrt(squared) / diagonal;
    d.mean += distance / static_cast<double>(count);
    d.largest = std::max(d.largest, distance);
  }
  return d;
}

Sequence made(const Keyframes& keyframes, const EncodingOptions& encoding = {}, const MotionOptions& motion = {}) {
  auto sequence = Sequence::create(keyframes, encoding, motion);
  REQUIRE(sequence.ok());
  return std::move(*sequence);
}

EncodingOptions ghostOf(int faces) {
  EncodingOptions options;
  options.ghostFaces = faces;
  return options;
}

EncodingOptions logStretch() {
  EncodingOptions options;
  options.stretch = Stretch::Log;
  return options;
}

EncodingOptions exactPrecision() {
  EncodingOptions options;
  options.precision = Precision::Exact;
  return options;
}

MotionOptions ease() {
  MotionOptions options;
  options.boundary = BoundaryKind::Hermite;
  options.startSpeed = options.endSpeed = 0;
  return options;
}

// Between the keys and as far beyond them as the slider reaches. There stretch is limited face by face in the one shape
// and cell by cell in the other.
void checkPreview(Sequence& sequence, double diagonal, const char* name) {
  Distances inside, beyond;
  Frame exact, cheap;
  for (int i = -4; i <= 14; ++i) {
    const double t = i / 10.0 + 0.03;
    REQUIRE(sequence.evaluate(t, exact).ok());
    REQUIRE(sequence.preview(t, cheap).ok());
    REQUIRE(cheap.normals.size() == exact.normals.size());
    const Distances d = distances(exact, cheap, exact.positions.size() / 3, diagonal);
    Distances& worst = t < 0 || t > 1 ? beyond : inside;
    worst.mean = std::max(worst.mean, d.mean);
    worst.largest = std::max(worst.largest, d.largest);
  }
  const auto said = [](const Distances& d) {
    return std::to_string(100 * d.mean) + " % of the diagonal in the mean, " + std::to_string(100 * d.largest) +
           " % at worst";
  };
  MESSAGE(std::string(name) << ": preview differs by " << said(inside) << "; beyond the keys by " << said(beyond));
  CHECK(inside.mean < 0.001);
  CHECK(inside.largest < 0.005);
  CHECK(beyond.mean < 0.01);
  CHECK(beyond.largest < 0.05);
}

}  // namespace

TEST_CASE("preview: stays close to the exact shape, with and without a ghost and with other options") {
  const Keyframes capsule = makeBenchKeyframes(20000, 3, 1);
  const double diagonal = diagonalOf(capsule);
  Sequence plain = made(capsule);
  checkPreview(plain, diagonal, "capsule");
  Sequence withGhost = made(capsule, ghostOf(2000));
  checkPreview(withGhost, diagonal, "capsule with a ghost");
  Sequence log = made(capsule, logStretch(), ease());
  checkPreview(log, diagonal, "log stretch, ease");
}

TEST_CASE("preview: what it is off is measured, as a share of the reference pose's diagonal") {
  Keyframes bars = keyframes(bar(), {twist(0), twist(radians(150)), twist(radians(270))});
  for (Vec3& p : bars.keys[2].positions) p += Vec3(500, 0, 0);  // far off, which makes no pose larger
  EncodingOptions encoding;
  encoding.reference = 1;
  Sequence sequence = made(bars, encoding);
  const Positions* reference = &bars.keys[1].positions;
  const double diagonal = boundingDiagonal({&reference, 1});
  Frame exact, cheap;
  for (const double t : {-0.3, 0.2, 0.3, 0.8, 1.3}) {
    REQUIRE(sequence.evaluate(t, exact).ok());
    REQUIRE(sequence.preview(t, cheap).ok());
    const Distances seen = distances(exact, cheap, exact.positions.size() / 3, diagonal);
    const auto measured = sequence.previewError(t);
    REQUIRE(measured.ok());
    CHECK(seen.largest > 1e-5);
    CHECK(measured->mean == doctest::Approx(seen.mean).epsilon(0.01));
    CHECK(measured->largest == doctest::Approx(seen.largest).epsilon(0.01));
  }
  const auto atKey = sequence.previewError(0.5);
  REQUIRE(atKey.ok());
  CHECK(atKey->largest < 1e-5);  // float32
  CHECK_FALSE(sequence.previewError(std::nan("")).ok());

  MotionOptions linear;
  linear.method = Method::Linear;
  REQUIRE(sequence.update(linear, {0, 0.5, 1}).ok());
  const auto baseline = sequence.previewError(0.3);
  REQUIRE(baseline.ok());
  CHECK(baseline->largest == 0);
}

TEST_CASE("preview: meets every key, and is a pure function") {
  const Keyframes capsule = makeBenchKeyframes(4000, 3, 2);
  const double diagonal = diagonalOf(capsule);
  Sequence sequence = made(capsule);
  Frame first, again, key;
  REQUIRE(sequence.preview(0.37, first).ok());
  for (const Key& pose : capsule.keys) {
    REQUIRE(sequence.preview(pose.time, key).ok());
    double largest = 0;
    for (std::size_t i = 0; i < key.positions.size(); ++i)
      largest = std::max(largest, std::abs(key.positions[i] - pose.positions[i / 3][i % 3]));
    CHECK(largest < 1e-5 * diagonal);  // float32
  }
  REQUIRE(sequence.preview(0.37, again).ok());
  CHECK(first.positions == again.positions);
  CHECK(first.normals == again.normals);
  CHECK_FALSE(sequence.preview(std::nan(""), key).ok());
}

TEST_CASE("preview: parts, seams and loose vertices come along") {
  Keyframes k = makeBenchKeyframes(2000, 2, 3);
  const int n = k.vertexCount();
  // A second capsule far off that turns with the first about the common origin, one vertex without faces, and a copy of
  // vertex 0.
  const std::size_t faces = k.faces.size();
  for (std::size_t f = 0; f < faces; ++f) k.faces.push_back({k.faces[f][0] + n, k.faces[f][1] + n, k.faces[f][2] + n});
  const Mat3 turn = Eigen::AngleAxisd(1.0, Vec3::UnitZ()).toRotationMatrix();
  for (std::size_t j = 0; j < k.keys.size(); ++j) {
    Positions& p = k.keys[j].positions;
    for (int v = 0; v < n; ++v) p.push_back(p[v] + Vec3(3, 0, 0));
    p.push_back(Vec3(0, 0, 6));
    p.push_back(p[0]);
    if (j > 0)
      for (Vec3& x : p) x = turn * x;
  }
  for (Triangle& f : k.faces)
    if (f[0] == 0) {
      f[0] = 2 * n + 1;  // one face holds the copy: a seam
      break;
    }
  Sequence sequence = made(k);
  checkPreview(sequence, diagonalOf(k), "two capsules");
}

TEST_CASE("the same motion at two resolutions agrees to half a percent of the diagonal") {
  const Keyframes coarse = makeBenchKeyframes(8000, 3, 1), fine = subdivided(coarse);
  const double diagonal = diagonalOf(coarse);
  Sequence a = made(coarse), b = made(fine);
  double largest = 0;
  for (const double t : {-0.2, 0.25, 0.6, 0.85, 1.2}) {
    Frame coarseFrame, fineFrame;
    REQUIRE(a.evaluate(t, coarseFrame).ok());
    REQUIRE(b.evaluate(t, fineFrame).ok());
    largest = std::max(largest, distances(coarseFrame, fineFrame, coarse.keys[0].positions.size(), diagonal).largest);
  }
  MESSAGE("two resolutions differ by " << 100 * largest << " % of the diagonal");
  CHECK(largest < 0.005);
}

TEST_CASE("exact: a factor in single precision gives the double solution") {
  for (const Keyframes& k :
       {makeBenchKeyframes(6000, 3, 4), keyframes(bar(), {twist(0), twist(pi), twist(radians(350))})}) {
    const double diagonal = diagonalOf(k);
    Sequence full = made(k, doublePrecision()), exact = made(k, exactPrecision());
    CHECK(exact.stats().factorBytes < 0.6 * full.stats().factorBytes);
    double largest = 0;
    Positions a, b;
    for (const double t : {-0.4, 0.0, 0.3, 0.5, 0.77, 1.4}) {
      REQUIRE(full.evaluate(t, a).ok());
      REQUIRE(exact.evaluate(t, b).ok());
      for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm() / diagonal);
    }
    MESSAGE("exact differs from double by " << largest << " of the diagonal");
    CHECK(largest < 1e-9);
    Positions again;
    REQUIRE(exact.evaluate(1.4, again).ok());
    CHECK(again == b);
  }
}

TEST_CASE("progress of reading a large file: every loop over its vertices and faces is heard") {
  const auto glb = sampleGlb({"bench", "bench", "", BoundaryKind::Natural, makeBenchKeyframes(90000, 2, 1)});
  REQUIRE(glb.ok());
  const NamedBytes file{"bench.glb", *glb}, other{"other.glb", *glb};
  const auto heardWhile = [](std::span<const NamedBytes> files, std::string_view reading) {
    std::vector<double> fractions;
    REQUIRE(importKeyframes(files, {}, [&](const char* stage, double fraction) {
              if (stage == reading) fractions.push_back(fraction);
            }).ok());
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    return fractions.size();
  };
  // Blocks of 16,384 (progress.h): of 45,002 vertices, 90,000 faces and their corners.
  const std::size_t vertices = 3, faces = 6, corners = 17,
                    mesh = vertices + vertices + corners + faces;  // numbers, then positions
  CHECK(heardWhile({&file, 1}, "reading the mesh") == 1 + mesh);
  CHECK(heardWhile({&file, 1}, "taking the keys") ==
        1 + vertices + 1 + 3 * vertices);  // the second one's target is read and added first
  const NamedBytes both[] = {file, other};
  CHECK(heardWhile(both, "reading the poses") == 2 * (1 + mesh + vertices));
}

TEST_CASE("progress of a large mesh: monotone, to the end, and in small steps") {
  const auto largestStep = [](const std::vector<double>& fractions) {
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    double largest = fractions.front();
    for (std::size_t i = 1; i < fractions.size(); ++i) largest = std::max(largest, fractions[i] - fractions[i - 1]);
    return largest;
  };
  const Keyframes keyframes = makeBenchKeyframes(90000, 2, 1);
  std::vector<double> checked;
  const MeshReport report = reportOf(keyframes, [&](double fraction) { checked.push_back(fraction); });
  CHECK(report.components == 1);
  CHECK(report.counts.edges == 3 * report.faces / 2);
  CHECK(report.counts.duplicateFaces == 0);
  CHECK(largestStep(checked) < 0.1);
  CHECK(checked.back() > 0.9);
  CHECK(checked.back() <= 1);

  std::vector<double> fractions;
  std::vector<std::string> stages;
  const auto progress = [&](const char* stage, double fraction) {
    fractions.push_back(fraction);
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  };
  REQUIRE(Sequence::create(keyframes, {}, {}, progress).ok());
  CHECK(fractions.back() == 1.0);
  CHECK(stages == std::vector<std::string>{"welding", "encoding", "ordering", "factorising"});
  CHECK(largestStep(fractions) < 0.15);
}
