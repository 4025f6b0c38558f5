#include "core/sequence/uneven_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

struct Box {
  Vec3 low, high;

  explicit Box(const WeldedShape& shape) : low(shape.poses[0][0]), high(low) {
    for (int j = 0; j < shape.keys; ++j)
      for (const Vec3& p : shape.poses[j]) low = low.cwiseMin(p), high = high.cwiseMax(p);
  }

  // Distance from the box in multiples of its diagonal; infinite for NaN.
  double distanceOf(const Vec3& p) const {
    const double out = (p - p.cwiseMax(low).cwiseMin(high)).norm() / (high - low).norm();
    return std::isfinite(out) ? out : std::numeric_limits<double>::infinity();
  }
};

std::string times(double factor) {
  return (factor < 10     ? shortNumber(std::round(10 * factor) / 10)
          : factor < 1e15 ? grouped(std::llround(factor))
                          : shortNumber(factor)) +
         " times";
}

Warning warningOf(const Suspect& suspect, const KeySpan& span, double distance, int face) {
  const std::string far = std::isfinite(distance) ? times(distance) + " their size" : "an unlimited distance";
  const std::string away = "the motion overshoots the keys by " + far + ", ";
  const std::string where = suspect.beyond == 0
                                ? "Between key " + std::to_string(span.from + 1) + " and key " +
                                      std::to_string(span.to + 1) + " " + away + "because this interval is " +
                                      times(suspect.ratio) + " as long as the neighbouring interval."
                                : std::string(suspect.beyond < 0 ? "Before the first key " : "After the last key ") +
                                      away + "because the mean interval is " + times(suspect.ratio) +
                                      " as long as the " + (suspect.beyond < 0 ? "first." : "last.");
  return {"uneven-times",
          where + " Space the keys more evenly (Space keys in the Motion panel; on the command line, --key-times).", 1,
          suspect.beyond < 0 ? span.from : span.to, face};
}

}  // namespace

std::vector<Warning> unevenTimesWarnings(const EncodedShape& encoded, const Motion& motion,
                                         const std::function<void(double, Positions&)>& shapeAt) {
  std::vector<Warning> warnings;
  const std::vector<Suspect> suspects = suspectsOf(motion);
  if (suspects.empty()) return warnings;
  const Box box(encoded.shape());
  const std::vector<KeySpan> spans = motion.curve().spans();
  const std::vector<Triangle>& faces = encoded.input().faces;
  for (const Suspect& suspect : suspects) {
    Positions shape;
    shapeAt(suspect.time, shape);
    double farthest = 1;
    int face = -1;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (const double distance = box.distanceOf(shape[faces[f][0]]); distance > farthest)
        farthest = distance, face = static_cast<int>(f);
    if (face >= 0) warnings.push_back(warningOf(suspect, spans[suspect.span], farthest, face));
  }
  return warnings;
}

}  // namespace shapespline
