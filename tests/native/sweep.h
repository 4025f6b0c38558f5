// Sweeps a sequence over its whole time range: step sizes, whether steps shrink with time, evenness of patch rotations.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/rotation/rigid_fit.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test {

/// Resolution of a sweep. Both kinds of zoom end at about 1e-10 of the range.
struct Density {
  int samples = 10;  ///< between two keys; a multiple of five, to sample the ends of the range
  int fold = 4;      ///< number of parts per step in each zoom
  int zooms = 14;
};

/// SHAPESPLINE_SWEEP=full selects the density used to determine the limits, at all settings, and takes many minutes.
/// Any other value only prints the results.
inline bool sweepsArePrinted() { return std::getenv("SHAPESPLINE_SWEEP") != nullptr; }
inline bool sweepsAreFull() { return sweepsArePrinted() && std::getenv("SHAPESPLINE_SWEEP") == std::string("full"); }
inline Density sweepDensity() { return sweepsAreFull() ? Density{60, 40, 5} : Density{}; }

/// The vertices of each patch, and rotations of patches between two shapes.
class PatchTurning {
 public:
  explicit PatchTurning(const Sequence& sequence) {
    const std::vector<Triangle>& faces = sequence.faces();
    const std::vector<int>& patchOf = sequence.encoded().lri().patchOfInputFace();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (patchOf[f] < 0) continue;
      const auto patch = static_cast<std::size_t>(patchOf[f]);
      if (vertices_.size() <= patch) vertices_.resize(patch + 1);
      vertices_[patch].insert(vertices_[patch].end(), faces[f].begin(), faces[f].end());
    }
    for (std::vector<int>& list : vertices_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  int count() const { return static_cast<int>(vertices_.size()); }

  /// Rotation, as axis times angle in degrees, of the rigid fit of a patch's vertices in `from` to those in `to`. None
  /// if the patch has shrunk to a line, because the rotation about the line is undetermined.
  Vec3 of(int patch, const Positions& from, const Positions& to) const {
    Positions a, b;
    for (int v : vertices_[patch]) a.push_back(from[v]), b.push_back(to[v]);
    if (isLine(a) || isLine(b)) return Vec3::Zero();
    return logRotation(fitRigid(a, b).rotation) * (180 / pi);
  }

  /// Largest rotation of any patch, in degrees.
  double largest(const Positions& from, const Positions& to) const {
    double most = 0;
    for (int patch = 0; patch < count(); ++patch) most = std::max(most, of(patch, from, to).norm());
    return most;
  }

 private:
  // Whether the width is below a fiftieth of the length, from invariants of the second moment (trace^2 is length^4, the
  // other length^2 width^2).
  static bool isLine(const Positions& p) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& x : p) centre += x / static_cast<double>(p.size());
    Mat3 moment = Mat3::Zero();
    for (const Vec3& x : p) moment += (x - centre) * (x - centre).transpose();
    const double trace = moment.trace();
    return (trace * trace - moment.squaredNorm()) / 2 < trace * trace / (50 * 50);
  }

  std::vector<std::vector<int>> vertices_;
};

/// A step of a motion: two times and their states, shapes or rotations of patches.
template <class State>
struct Step {
  double from, to;
  State before, after;
};

/// Cuts a step into `fold` parts and continues with the part of largest measure, `zooms` times.
template <class State, class At, class Measure>
Step<State> zoomed(Step<State> step, const Density& density, const At& at, const Measure& measure) {
  for (int zoom = 0; zoom < density.zooms; ++zoom) {
    Step<State> largest, part{step.from, step.from, step.before, step.before};
    double most = -1;
    for (int i = 1; i <= density.fold; ++i) {
      part.from = part.to, part.before = std::move(part.after);
      part.to = i == density.fold ? step.to : step.from + (step.to - step.from) * i / density.fold;
      part.after = i == density.fold ? step.after : at(part.to);
      if (const double size = measure(part.before, part.after); size > most) most = size, largest = part;
    }
    step = std::move(largest);
  }
  return step;
}

/// Largest velocity change of a vertex over two neighbouring steps, as a length.
inline double secondDifference(const Positions& a, const Positions& b, const Positions& c) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - 2 * b[v] + c[v]).norm());
  return largest;
}

/// Growth of a vertex's largest acceleration when the spacing around `middle` is halved five times, each time
/// continuing at the largest of three points. 1 if the motion is C2 and well sampled (a halving never loses
/// acceleration, by the identity D(h) = D_left(h/2) + 2 D(h/2) + D_right(h/2)), 32 at a corner, 1024 at a jump, 0
/// without acceleration.
inline double accelerationGrowth(Sequence& sequence, double middle, double spacing, double rounding) {
  std::vector<Positions> p = {shapeAt(sequence, middle - spacing), shapeAt(sequence, middle),
                              shapeAt(sequence, middle + spacing)};
  const double first = secondDifference(p[0], p[1], p[2]);
  if (first < rounding) return 0;
  double last = first;
  const double shortest = spacing / 32;
  while (spacing > 1.5 * shortest) {
    spacing /= 2;
    p.insert(p.begin() + 1, shapeAt(sequence, middle - spacing));
    p.insert(p.begin() + 3, shapeAt(sequence, middle + spacing));
    int best = 1;
    last = 0;
    for (int i = 1; i <= 3; ++i)
      if (const double d = secondDifference(p[i - 1], p[i], p[i + 1]); d > last) last = d, best = i;
    middle += (best - 2) * spacing;
    p = {p[best - 1], p[best], p[best + 1]};
  }
  return last / first * 32 * 32;
}

/// Ratio of largest to median value; 0 if all values are negligible relative to `scale`.
inline double unevenness(std::vector<double> values, double scale) {
  if (values.empty()) return 0;
  const double largest = *std::max_element(values.begin(), values.end());
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  const double median = values[values.size() / 2];
  return largest <= 1e-6 * scale ? 0 : largest / std::max(median, 1e-6 * scale);
}

/// Results of a sweep from 0.4 of the range before the first key to 0.4 after the last. Lengths in percent of the first
/// key's diagonal, rotations in degrees.
struct Sweep {
  /// largest displacement of a vertex between two samples; its time as a share of the range
  double step = 0, stepAt = 0;
  double spacing = 0;     ///< sample spacing as a share of the range
  double zoomedStep = 0;  ///< largest remaining steps (of a vertex, of a patch's rotation) after zooming in
  double zoomedSpacing = 0;
  double turn = 0, turnAt = 0;    ///< largest rotation of a patch between two samples
  double inside = 0, margin = 0;  ///< largest over median of the largest rotation per step; margin: the worse side
  double growth = 0;              ///< at the largest acceleration (accelerationGrowth)
};

inline Sweep sweep(Sequence& sequence, const Density& density = sweepDensity()) {
  const auto [start, end] = sequence.range();
  const bool periodic = sequence.motion().options().boundary == BoundaryKind::Periodic;
  const std::vector<double>& times = sequence.motion().keyTimes();
  const double range = end - start, keyRange = times.back() - times.front();
  const int intervals = static_cast<int>(std::ceil(static_cast<double>(times.size() - 1) * range / keyRange - 1e-9));
  const int perRange = density.samples * intervals;
  const int margin = perRange * 2 / 5;
  const Positions firstKey = shapeAt(sequence, times.front());
  const double diagonal = boundingDiagonal(std::vector<const Positions*>{&firstKey});
  const auto vertexStep = [&](const Positions& a, const Positions& b) {
    return 100 * largestDistance(a, b) / diagonal;
  };
  const auto patchTurn = [](const std::vector<Quaternion>& a, const std::vector<Quaternion>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, a[k].angularDistance(b[k]) * (180 / pi));
    return most;
  };
  const auto timeOf = [&](int sample) { return start + range * sample / perRange; };

  Sweep found;
  found.spacing = 1.0 / perRange;
  Step<Positions> farthest;
  Step<std::vector<Quaternion>> largestTurn;
  std::vector<double> turns;
  Positions before = shapeAt(sequence, timeOf(-margin)), beforeThat;
  std::vector<Quaternion> patchesBefore = patchesAt(sequence, timeOf(-margin));
  double largestBend = 0, bendAt = start;
  for (int i = 1 - margin; i <= perRange + margin; ++i) {
    Positions now = shapeAt(sequence, timeOf(i));
    std::vector<Quaternion> patchesNow = patchesAt(sequence, timeOf(i));
    const double step = vertexStep(before, now), turn = patchTurn(patchesBefore, patchesNow);
    if (step > found.step)
      found.step = step, found.stepAt = (i - 0.5) / perRange, farthest = {timeOf(i - 1), timeOf(i), before, now};
    if (turn > found.turn)
      found.turn = turn, found.turnAt = (i - 0.5) / perRange,
      largestTurn = {timeOf(i - 1), timeOf(i), patchesBefore, patchesNow};
    if (!beforeThat.empty())
      if (const double d = secondDifference(beforeThat, before, now); d > largestBend)
        largestBend = d, bendAt = timeOf(i - 1);
    turns.push_back(turn);
    beforeThat = std::move(before), before = std::move(now), patchesBefore = std::move(patchesNow);
  }
  if (found.step > 0) {
    const auto far = zoomed(std::move(farthest), density, [&](double t) { return shapeAt(sequence, t); }, vertexStep);
    found.zoomedStep = vertexStep(far.before, far.after);
    found.zoomedSpacing = (far.to - far.from) / range;
  }
  if (found.turn > 0) {
    const auto turned =
        zoomed(std::move(largestTurn), density, [&](double t) { return patchesAt(sequence, t); }, patchTurn);
    found.zoomedStep =
        std::max(found.zoomedStep, vertexStep(shapeAt(sequence, turned.from), shapeAt(sequence, turned.to)));
    found.zoomedSpacing = (turned.to - turned.from) / range;
  }
  found.growth = accelerationGrowth(sequence, bendAt, range / perRange, 1e-9 * diagonal);
  const auto part = [&](int from, int to) {
    return unevenness({turns.begin() + from, turns.begin() + to}, found.turn);
  };
  if (periodic) {
    found.inside = part(0, static_cast<int>(turns.size()));  // a loop has no margins
  } else {
    found.inside = part(margin, margin + perRange);
    found.margin = std::max(part(0, margin), part(margin + perRange, static_cast<int>(turns.size())));
  }
  return found;
}

}  // namespace shapespline::test
