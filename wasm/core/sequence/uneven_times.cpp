#include "core/sequence/uneven_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/base/format.h"

namespace shapespline {

namespace {

// An interval is suspicious if it is this many times longer than a neighbour, and the weights in it are large.
constexpr double unevenFactor = 4;
// Weights are large if their absolute values sum to more than these limits. Evenly spaced keys reach 1.6 between them,
// and 3.6 one interval beyond the last.
constexpr double betweenFactor = 3, beyondFactor = 8;
constexpr int samples = 8;  // per interval
// Larger rotations past the keys are reported. Beyond the ends, fast rotations continue far.
constexpr double betweenAngle = std::numbers::pi / 2, beyondAngle = 4 * std::numbers::pi;
constexpr double maxOutside = 0.25;  // as rotations, for edge lengths

struct Suspect {
  double time, weight, ratio;
  std::size_t span;
  int beyond;  // -1 before the first key, 1 after the last, 0 between keys
};

double lengthOf(const KeySpan& span) { return span.end - span.start; }

double weightAt(const Motion& motion, double t) { return motion.curve().weights(t).cwiseAbs().sum(); }

double shortestNeighbour(const std::vector<KeySpan>& spans, std::size_t i, bool closed) {
  const std::size_t n = spans.size();
  double shortest = std::numeric_limits<double>::infinity();
  if (i > 0 || closed) shortest = lengthOf(spans[(i + n - 1) % n]);
  if (i + 1 < n || closed) shortest = std::min(shortest, lengthOf(spans[(i + 1) % n]));
  return shortest;
}

// The suspicious interval with the largest weights between keys, and suspicious times beyond the ends.
std::vector<Suspect> suspectsOf(const Motion& motion) {
  const std::vector<KeySpan> spans = motion.curve().spans();
  const bool closed = motion.curve().periodic();
  const auto [start, end] = motion.range();
  std::vector<Suspect> suspects;
  Suspect worst{0, betweenFactor, 0, 0, 0};
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const double ratio = lengthOf(spans[i]) / shortestNeighbour(spans, i, closed);
    for (int k = 1; k < samples && ratio > unevenFactor; ++k) {
      const double t = spans[i].start + k * lengthOf(spans[i]) / samples, weight = weightAt(motion, t);
      if (weight > worst.weight) worst = {t, weight, ratio, i, 0};
    }
  }
  if (worst.ratio > 0) suspects.push_back(worst);
  if (closed || spans.empty()) return suspects;
  const double mean = (end - start) / static_cast<double>(spans.size());
  for (int side : {-1, 1}) {
    const std::size_t last = side < 0 ? 0 : spans.size() - 1;
    const double t = side < 0 ? start - mean : end + mean, ratio = mean / lengthOf(spans[last]);
    if (const double weight = weightAt(motion, t); ratio > unevenFactor && weight > beyondFactor)
      suspects.push_back({t, weight, ratio, last, side});
  }
  return suspects;
}

/// How far the motion leaves its keys, in words, and a face where.
struct Overshoot {
  std::string text;
  int face = -1;
};

Overshoot ofRotations(const EncodedShape& encoded, const Motion& motion, const Suspect& suspect) {
  const std::vector<double> angles = encoded.lri().patches().overshoot(motion.at(suspect.time));
  const std::vector<int>& patches = encoded.lri().patchOfInputFace();
  double furthest = suspect.beyond ? beyondAngle : betweenAngle;
  int face = -1;
  // A ghost mesh may have patches without a face of the input.
  for (std::size_t f = 0; f < patches.size(); ++f)
    if (patches[f] >= 0 && angles[patches[f]] > furthest) {
      furthest = angles[patches[f]];
      face = static_cast<int>(f);
    }
  return {angleText(furthest), face};
}

// Edge lengths outside those of the keys, as a share of their sum.
Overshoot ofLengths(const EncodedShape& encoded, const Positions& shape) {
  const InputMesh& input = encoded.input();
  double outside = 0, whole = 0, most = 0;
  int face = -1;
  for (std::size_t f = 0; f < input.faces.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int a = input.faces[f][c], b = input.faces[f][(c + 1) % 3];
      double shortest = std::numeric_limits<double>::infinity(), longest = 0;
      for (int j = 0; j < encoded.shape().keys; ++j) {
        const Positions& key = encoded.shape().poses[j];
        const double length = (key[input.welding.weldedOfRaw[b]] - key[input.welding.weldedOfRaw[a]]).norm();
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
      const double length = (shape[b] - shape[a]).norm();
      const double past = std::max({length - longest, shortest - length, 0.0});
      outside += past;
      whole += longest;
      if (!(past <= most)) {
        most = past;
        face = static_cast<int>(f);
      }
    }
  if (outside <= maxOutside * whole) return {};
  const double share = 100 * outside / whole;
  return {std::isfinite(share) ? grouped(std::llround(share)) + " % of their edge lengths" : "an unlimited distance",
          face};
}

std::string times(double factor) {
  return (factor < 10     ? shortNumber(std::round(10 * factor) / 10)
          : factor < 1e15 ? grouped(std::llround(factor))
                          : shortNumber(factor)) +
         " times";
}

Warning warningOf(const Suspect& suspect, const KeySpan& span, const Overshoot& overshoot) {
  const std::string away = "the motion overshoots the keys by " + overshoot.text + ", ";
  const bool isBetween = suspect.beyond == 0;
  const std::string where =
      isBetween ? away + "because this interval is " + times(suspect.ratio) + " as long as the neighbouring interval."
                : std::string(suspect.beyond < 0 ? "Before the first key " : "After the last key ") + away +
                      "because the mean interval is " + times(suspect.ratio) + " as long as the " +
                      (suspect.beyond < 0 ? "first." : "last.");
  return {"uneven-times",
          where + " Space the keys more evenly (Space keys in the Motion panel; on the command line, --key-times).",
          1,
          suspect.beyond < 0 ? span.from : span.to,
          overshoot.face,
          {},
          isBetween ? "Between" : ""};
}

}  // namespace

std::vector<Warning> unevenTimesWarnings(const EncodedShape& encoded, const Motion& motion,
                                         const std::function<void(double, Positions&)>& shapeAt) {
  std::vector<Warning> warnings;
  const std::vector<Suspect> suspects = suspectsOf(motion);
  if (suspects.empty()) return warnings;
  const std::vector<KeySpan> spans = motion.curve().spans();
  for (const Suspect& suspect : suspects) {
    Overshoot found;
    if (motion.inLri()) found = ofRotations(encoded, motion, suspect);
    if (found.face < 0) {
      Positions shape;
      shapeAt(suspect.time, shape);
      found = ofLengths(encoded, shape);
    }
    if (found.face >= 0) warnings.push_back(warningOf(suspect, spans[suspect.span], found));
  }
  return warnings;
}

}  // namespace shapespline
