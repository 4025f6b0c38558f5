#include "shells/shell_motion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/centroid.h"
#include "core/base/union_find.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh.h"
#include "core/mesh/weld.h"
#include "core/rotation/rigid_fit.h"
#include "shells/fit_shape.h"
#include "shells/shell_spline.h"

namespace shapespline {

namespace {

constexpr double flat = 1e-3;  // a triangle with a smaller share of its least area in the keys counts as collapsed

std::vector<std::vector<int>> componentsOf(const std::vector<Triangle>& faces, int vertices) {
  UnionFind sets(vertices);
  for (const Triangle& f : faces) {
    sets.join(f[0], f[1]);
    sets.join(f[0], f[2]);
  }
  std::vector<std::vector<int>> members(vertices);
  for (int v = 0; v < vertices; ++v) members[sets.find(v)].push_back(v);
  std::erase_if(members, [](const std::vector<int>& list) { return list.empty(); });
  return members;
}

// Lengths and angles do not determine the position of a component, so each is fitted rigidly to its position in
// `place`.
void moveOnto(Positions& shape, const Positions& place, const std::vector<std::vector<int>>& components) {
  for (const std::vector<int>& component : components) {
    Positions from, to;
    for (const int v : component) {
      from.push_back(shape[v]);
      to.push_back(place[v]);
    }
    const Mat3 rotation = fitRigid(from, to).rotation;
    const Vec3 a = centroidOf(from), b = centroidOf(to);
    for (const int v : component) shape[v] = rotation * (shape[v] - a) + b;
  }
}

ShellMeasures blendOf(const std::vector<ShellMeasures>& keys, const std::vector<double>& weights) {
  ShellMeasures blend(keys.front().size(), 0);
  for (std::size_t k = 0; k < keys.size(); ++k)
    for (std::size_t m = 0; m < blend.size(); ++m) blend[m] += weights[k] * keys[k][m];
  return blend;
}

/// Keys and samples on the welded mesh.
struct Welded {
  Welding welding;
  std::vector<Triangle> faces;
  std::vector<Positions> keys, starts;
  double size = 0;
};

Welded weldedOf(const std::vector<Triangle>& faces, const std::vector<Positions>& keys,
                const std::vector<ShellSample>& samples) {
  std::vector<const Positions*> poses;
  for (const Positions& key : keys) poses.push_back(&key);
  Welded welded;
  welded.welding = weld(poses, weldTolerances(poses));
  welded.faces = weldFaces(faces, welded.welding);
  welded.size = boundingDiagonal(poses);
  for (const Positions& key : keys) welded.keys.push_back(weldPositions(key, welded.welding));
  for (const ShellSample& s : samples)
    welded.starts.push_back(s.key >= 0 ? welded.keys[s.key] : weldPositions(s.start, welded.welding));
  return welded;
}

// The least area of each triangle that a fit may reach: none has less than a small share of its least area in the keys.
// The angles of a triangle without area jump, so such a fit is far from its neighbours in time.
std::vector<double> minAreas(const Welded& mesh) {
  std::vector<double> areas;
  for (const Triangle& face : mesh.faces) {
    double least = std::numeric_limits<double>::infinity();
    for (const Positions& key : mesh.keys) least = std::min(least, surfaceArea(key, {face}));
    areas.push_back(flat * least);
  }
  return areas;
}

bool collapses(const Positions& shape, const std::vector<Triangle>& faces, const std::vector<double>& minArea) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (surfaceArea(shape, {faces[f]}) < minArea[f]) return true;
  return false;
}

// Fits every sample. If one fit in an interval fails, all its samples keep their starts, because the motion would jump
// between a fitted shape and a start.
ShellShapes fitSamples(ShellSystem& system, const Welded& mesh, const std::vector<ShellSample>& samples,
                       const FractionReport& onProgress) {
  const std::vector<ShellMeasures> measures = system.metric().measuresOfKeys(mesh.keys);
  ShellShapes found{mesh.starts, {}, {}, true, 0};
  const std::vector<std::vector<int>> components = componentsOf(mesh.faces, system.metric().vertexCount());
  const std::vector<double> minArea = minAreas(mesh);
  std::size_t intervalStart = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    reportFraction(onProgress, static_cast<double>(s) / static_cast<double>(samples.size()));
    if (samples[s].key >= 0) {
      intervalStart = s + 1;
      continue;
    }
    const bool isFlat = collapses(mesh.starts[s], mesh.faces, minArea);
    const auto isAllowed = [&](const Positions& trial) { return isFlat || !collapses(trial, mesh.faces, minArea); };
    auto shape = fitShape(system, blendOf(measures, samples[s].weights), mesh.starts[s], mesh.size, isAllowed);
    if (shape && !collapses(*shape, mesh.faces, minArea)) {
      moveOnto(*shape, mesh.starts[s], components);
      found.shapes[s] = std::move(*shape);
      continue;
    }
    std::copy(mesh.starts.begin() + intervalStart, mesh.starts.begin() + s, found.shapes.begin() + intervalStart);
    while (samples[s + 1].key < 0) ++s;
    found.failed.push_back(samples[s + 1].key);
  }
  return found;
}

// The level of each sample, from coarse to fine in time: 0 at the keys, 1 halfway between them, 2 halfway between
// these, and so on.
std::vector<int> levelsOf(const std::vector<ShellSample>& samples) {
  std::vector<int> levels(samples.size(), 0);
  const auto halve = [&](const auto& self, std::size_t from, std::size_t to, int level) -> void {
    const std::size_t middle = (from + to) / 2;
    if (middle == from) return;
    levels[middle] = level;
    self(self, from, middle, level + 1);
    self(self, middle, to, level + 1);
  };
  for (std::size_t s = 1, from = 0; s < samples.size(); ++s) {
    if (samples[s].key < 0) continue;
    halve(halve, from, s, 1);
    from = s;
  }
  return levels;
}

// Minimises first with one shape between two keys, which are those of kept lengths, then with more and more. Between
// distant keys, the search would end far from the minimum if all shapes were free at once. Shapes of intervals without
// a fit stay LRI's.
void minimiseBending(ShellSystem& system, const Welded& mesh, const std::vector<ShellSample>& samples,
                     ShellShapes& found, const FractionReport& onProgress) {
  std::vector<int> interval(samples.size());  // by its last key
  std::vector<char> fixed(samples.size());
  for (std::size_t s = samples.size(); s-- > 0;) {
    interval[s] = samples[s].key >= 0 ? samples[s].key : interval[s + 1];
    fixed[s] = samples[s].key >= 0 || std::count(found.failed.begin(), found.failed.end(), interval[s]) > 0;
  }
  const std::vector<Positions> fits = found.shapes;
  const std::vector<int> levels = levelsOf(samples);
  const int finest = *std::ranges::max_element(levels);
  std::vector<char> unchanged(samples.size());
  for (int level = 1; level <= finest; ++level) {
    std::vector<std::size_t> members;
    std::vector<double> times;
    std::vector<Positions> shapes;
    std::vector<char> isFixed, isNew;
    for (std::size_t s = 0; s < samples.size(); ++s) {
      if (levels[s] > level) continue;
      members.push_back(s);
      times.push_back(samples[s].time);
      shapes.push_back(found.shapes[s]);
      isFixed.push_back(fixed[s]);
      isNew.push_back(level > 1 && levels[s] == level && !fixed[s]);
    }
    ShellSpline spline(system, times, mesh.size);
    spline.moveToMeans(shapes, isNew);
    const double share = 1.0 / finest;
    const std::vector<char> stayed =
        spline.minimise(shapes, isFixed, partOf(onProgress, (level - 1) * share, level * share));
    found.finished = spline.finished();
    for (std::size_t i = 0; i < members.size(); ++i) {
      found.shapes[members[i]] = std::move(shapes[i]);
      unchanged[members[i]] = stayed[i];
    }
  }
  for (std::size_t s = 0; s < samples.size(); ++s)
    if (unchanged[s] && (found.stiff.empty() || found.stiff.back() != interval[s])) found.stiff.push_back(interval[s]);
  const std::vector<std::vector<int>> components = componentsOf(mesh.faces, system.metric().vertexCount());
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (fixed[s]) continue;
    if (std::ranges::count(found.stiff, interval[s]) > 0) found.shapes[s] = fits[s];
    else moveOnto(found.shapes[s], mesh.starts[s], components);
  }
}

}  // namespace

Result<ShellShapes> shellShapes(const std::vector<Triangle>& faces, const std::vector<Positions>& keys,
                                const std::vector<ShellSample>& samples, ShellMethod method,
                                const FractionReport& onProgress) {
  const Welded mesh = weldedOf(faces, keys, samples);
  const ShellMetric metric(mesh.faces, mesh.keys);
  if (metric.edgeCount() == 0)
    return Error{ErrorCode::NoArea,
                 "No triangle has area in the first key, so the shape has no lengths to keep. Choose another method."};
  auto system = ShellSystem::create(metric);
  if (!system) return system.error();
  const double fitting = method == ShellMethod::Lengths ? 1 : 0.3;  // share of the progress
  ShellShapes found = fitSamples(*system, mesh, samples, partOf(onProgress, 0, fitting));
  if (method == ShellMethod::Spline) minimiseBending(*system, mesh, samples, found, partOf(onProgress, fitting, 1));
  found.factors = system->factorCount();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (samples[s].key >= 0) {
      found.shapes[s] = keys[samples[s].key];
      continue;
    }
    Positions raw;
    for (const int w : mesh.welding.weldedOfRaw) raw.push_back(found.shapes[s][w]);
    found.shapes[s] = std::move(raw);
  }
  reportFraction(onProgress, 1);
  return found;
}

}  // namespace shapespline
