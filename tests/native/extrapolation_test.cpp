// Beyond the keys, stretch eases towards limits taken from the keys.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "core/mesh/measures.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::extrapolation_test {

namespace {

Sequence make(const Keyframes& k, Stretch stretch, int ghostFaces = 0, Precision precision = Precision::Double) {
  EncodingOptions options;
  options.stretch = stretch;
  options.precision = precision;
  options.ghostFaces = ghostFaces;
  return sequenceOf(k, options);
}

Frame frameAt(Sequence& s, double t) {
  Frame frame;
  REQUIRE(s.evaluate(t, frame).ok());
  return frame;
}

Frame blendOf(Sequence& s, const std::vector<double>& weights) {
  Frame frame;
  REQUIRE(s.evaluateBlend(weights, frame).ok());
  return frame;
}

double diagonalOf(const Positions& p) {
  const Positions* poses[] = {&p};
  return boundingDiagonal(poses);
}

Map scale(double x, double y, double z) {
  return [=](const Vec3& p) -> Vec3 { return {x * p.x(), y * p.y(), z * p.z()}; };
}

double lengthOf(const Positions& bar) {
  double low = bar[0].z(), high = low;
  for (const Vec3& p : bar) low = std::min(low, p.z()), high = std::max(high, p.z());
  return high - low;
}

// Scale of a change that would reach its limit at 1/u of itself.
double eased(double u) { return std::pow(1 + std::pow(u, 4), -0.25); }

// A box with six keys. Each is stretched along the three axes by random factors from 1/2 to 2, and bent.
Keyframes randomStretches(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Map> maps;
  for (int j = 0; j < 6; ++j) {
    const auto factor = [&] { return std::pow(2, uniform(random)); };
    const Map stretched = scale(factor(), factor(), factor()), bent = bend(0.3 * uniform(random));
    maps.push_back([=](const Vec3& p) { return bent(stretched(p)); });
  }
  return keyframes(box(1, 1, 4, 3, 3, 12), maps);
}

// Upper bound for every shape: the first key, which is the reference of stretch, times the limit of the most stretched
// face.
double boundOf(const Keyframes& k) {
  double largest = 0;
  const Positions& first = k.keys[0].positions;
  for (const Key& key : k.keys)
    for (const Triangle& f : k.faces)
      for (int c = 0; c < 3; ++c) {
        const int a = f[c], b = f[(c + 1) % 3];
        largest = std::max(largest, (key.positions[a] - key.positions[b]).norm() / (first[a] - first[b]).norm());
      }
  return 1.5 * largest * diagonalOf(first);
}

}  // namespace

TEST_CASE("beyond the keys, linear stretch stays above its lower limit at any time, without lost faces") {
  const Keyframes k = keyframes(bar(), {scale(1, 1, 1), scale(1, 1, 0.4)});
  for (const Precision precision : {Precision::Single, Precision::Double}) {
    Sequence s = make(k, Stretch::Linear, 0, precision);
    for (const double t : {1.1, 1.4, 2.0, 11.0, 1e6}) {
      CAPTURE(t);
      const Frame frame = frameAt(s, t);
      CHECK(frame.indefiniteFaces == 0);
      CHECK(enclosedVolume(toPositions(frame.positions), k.faces) > 2.6);  // the limit is 8/3
      // 0.4 - 0.6 (t - 1) eases towards 0.4 / 1.5.
      const double change = 0.6 * (t - 1), room = 0.4 - 0.4 / 1.5;
      CHECK(lengthOf(shapeAt(s, t)) == doctest::Approx(10 * (0.4 - eased(change / room) * change))
                                           .epsilon(precision == Precision::Single ? 1e-4 : 1e-9));
    }
    CHECK(lengthOf(shapeAt(s, -1)) == doctest::Approx(16).epsilon(1e-5));  // no upper limit applies
    // Weights outside the keys give the requested blend and report indefinite faces.
    CHECK(blendOf(s, {-1, 2}).indefiniteFaces > 100);
  }
}

TEST_CASE("beyond the keys, logarithmic stretch stays between both limits") {
  const Keyframes k = keyframes(bar(), {scale(1, 1, 1), scale(1, 1, 0.4)});
  Sequence s = make(k, Stretch::Log);
  const double change = std::log(0.4), room = std::log(1.5);
  for (const double far : {0.1, 0.4, 1.0, 2.0, 10.0}) {
    CAPTURE(far);
    const double f = eased(-change * far / room);
    CHECK(lengthOf(shapeAt(s, 1 + far)) == doctest::Approx(10 * std::exp(change * (1 + f * far))).epsilon(1e-9));
    CHECK(lengthOf(shapeAt(s, -far)) == doctest::Approx(10 * std::exp(-change * f * far)).epsilon(1e-9));
    CHECK(frameAt(s, 1 + far).indefiniteFaces == 0);
  }
}

TEST_CASE("beyond the keys logarithmic stretch grows boundedly, with a ghost and without") {
  double largest = 0;
  for (const unsigned seed : {1, 2, 3, 4, 5, 6})
    for (const int ghostFaces : {0, 60}) {
      const Keyframes k = randomStretches(seed);
      Sequence s = make(k, Stretch::Log, ghostFaces);
      for (const double t : {-0.4, -0.2, 1.2, 1.4}) {  // up to two intervals beyond the keys
        const Frame frame = frameAt(s, t);
        CHECK(frame.indefiniteFaces == 0);
        largest = std::max(largest, diagonalOf(toPositions(frame.positions)) / boundOf(k));
      }
    }
  MESSAGE("largest box over the bound: " << largest);
  CHECK(largest < 1);
}

TEST_CASE("the motion is C2 where it continues beyond the keys") {
  const Keyframes k = randomStretches(1);
  for (const Stretch stretch : {Stretch::Linear, Stretch::Log})
    for (const int ghostFaces : {0, 60}) {
      CAPTURE(ghostFaces);
      Sequence s = make(k, stretch, ghostFaces);
      for (const double end : {0.0, 1.0}) {
        // Difference of the second derivatives on both sides, by second-order differences, which fall as h^2.
        const auto jump = [&](double h) {
          const auto second = [&](double side) {
            const Positions a = shapeAt(s, end), b = shapeAt(s, end + side * h), c = shapeAt(s, end + 2 * side * h),
                            d = shapeAt(s, end + 3 * side * h);
            Positions result;
            for (std::size_t v = 0; v < a.size(); ++v)
              result.push_back((2 * a[v] - 5 * b[v] + 4 * c[v] - d[v]) / (h * h));
            return result;
          };
          return largestDistance(second(1), second(-1));
        };
        const double coarse = jump(2e-3), fine = jump(1e-3);
        CAPTURE(coarse);
        CHECK(fine < 0.3 * coarse);
      }
    }
}

TEST_CASE("within the keys nothing is limited, to the bit") {
  const Keyframes k = keyframes(bar(), {scale(1, 1, 1), scale(1.2, 0.9, 0.4)});
  for (const Stretch stretch : {Stretch::Linear, Stretch::Log})
    for (const int ghostFaces : {0, 300}) {
      Sequence s = make(k, stretch, ghostFaces, Precision::Single);
      for (const double t : {0.0, 0.125, 0.5, 0.875, 1.0})
        CHECK(frameAt(s, t).positions == blendOf(s, {1 - t, t}).positions);
      CHECK(frameAt(s, 1.5).positions != blendOf(s, {-0.5, 1.5}).positions);
    }
}

TEST_CASE("real animals keep their size beyond the keys, with logarithmic stretch") {
  for (const auto& paths : {wolfPoses, lionPoses}) {
    if (!hasData(paths)) return;
    const Keyframes k = realKeyframes(paths);
    double largest = 0;
    for (const Key& key : k.keys) largest = std::max(largest, diagonalOf(key.positions));
    Sequence s = make(k, Stretch::Log, 0, Precision::Single);
    double worst = 0;
    for (const double intervals : {0.5, 1.0, 2.0})
      for (const double t : {-intervals / (k.keyCount() - 1), 1 + intervals / (k.keyCount() - 1)})
        worst = std::max(worst, diagonalOf(toPositions(frameAt(s, t).positions)));
    MESSAGE(paths.front() << ": the largest shape has " << worst / largest << " times the diagonal of the largest key");
    CHECK(worst < 2 * largest);
  }
}

}  // namespace shapespline::test::extrapolation_test
