// A sequence looked at through all of its time: how far it steps, whether a step shrinks when time does, how evenly its
// patches turn.
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

/// How closely a sweep looks. Both ways of zooming end at about 1e-10 of the range.
struct Density {
  int samples = 10;  ///< between two keys; a multiple of five, so the ends of the range are samples
  int fold = 4;      ///< parts that each zoom cuts a step into
  int zooms = 14;
};

/// SHAPESPLINE_SWEEP=full asks for the density of the measurements that the limits come from, at all settings; it takes
/// many minutes. Any other value only prints what is found.
inline bool sweepsArePrinted() { return std::getenv("SHAPESPLINE_SWEEP") != nullptr; }
inline bool sweepsAreFull() { return sweepsArePrinted() && std::getenv("SHAPESPLINE_SWEEP") == std::string("full"); }
inline Density sweepDensity() { return sweepsAreFull() ? Density{60, 40, 5} : Density{}; }

/// The vertices of each patch, and how far patches turn between two shapes.
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

  /// The rotation, as axis times angle in degrees, of the rigid fit of one patch's vertices in `from` to those in `to`;
  /// none where the patch has shrunk to a line, about which nothing says how it turned.
  Vec3 of(int patch, const Positions& from, const Positions& to) const {
    Positions a, b;
    for (int v : vertices_[patch]) a.push_back(from[v]), b.push_back(to[v]);
    if (isLine(a) || isLine(b)) return Vec3::Zero();
    return logRotation(fitRigid(a, b).rotation) * (180 / pi);
  }

  /// Degrees by which the patch that turns most does.
  double largest(const Positions& from, const Positions& to) const {
    double most = 0;
    for (int patch = 0; patch < count(); ++patch) most = std::max(most, of(patch, from, to).norm());
    return most;
  }

 private:
  // Narrower than a fiftieth of its length: the second moment's invariants tell (trace^2 is length^4, the other
  // length^2 width^2).
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

/// A step of a motion: two times and what there is at them, shapes or rotations of patches.
template <class State>
struct Step {
  double from, to;
  State before, after;
};

/// Cuts a step into `fold` parts and goes on with the one of largest measure, `zooms` times.
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

/// Largest change of velocity of a vertex over two neighbouring steps, as a length.
inline double secondDifference(const Positions& a, const Positions& b, const Positions& c) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - 2 * b[v] + c[v]).norm());
  return largest;
}

/// How the largest acceleration of a vertex grows when the spacing around `middle` is halved five times, each time
/// going on at the largest of the three places at hand: 1 where the motion is C2 and well sampled (a halving never
/// loses any, by the identity D(h) = D_left(h/2) + 2 D(h/2) + D_right(h/2)), 32 at a corner, 1024 at a jump. 0 where
/// nothing accelerates.
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

/// Largest over median of the values; 0 where they are nothing beside `scale`.
inline double unevenness(std::vector<double> values, double scale) {
  if (values.empty()) return 0;
  const double largest = *std::max_element(values.begin(), values.end());
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  const double median = values[values.size() / 2];
  return largest <= 1e-6 * scale ? 0 : largest / std::max(median, 1e-6 * scale);
}

/// What a sweep from 0.4 of the range before it to 0.4 beyond found. Lengths in percent of the first key's diagonal,
/// turns in degrees.
struct Sweep {
  double step = 0, stepAt = 0;  ///< largest way of a vertex between two samples; where, as a share of the range
  double spacing = 0;           ///< of the samples, as a share of the range
  double zoomedStep = 0;        ///< what is left of the largest steps (of a vertex, of a patch's turn) after zooming in
  double zoomedSpacing = 0;
  double turn = 0, turnAt = 0;    ///< largest turn of a patch between two samples
  double inside = 0, margin = 0;  ///< largest over median of the largest turn at each moment; the worse of the margins
  double growth = 0;              ///< of the acceleration, where it is largest (accelerationGrowth)
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
  Step<std::vector<Quaternion>> mostTurned;
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
      mostTurned = {timeOf(i - 1), timeOf(i), patchesBefore, patchesNow};
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
        zoomed(std::move(mostTurned), density, [&](double t) { return patchesAt(sequence, t); }, patchTurn);
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
