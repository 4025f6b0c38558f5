#include "io/import_hints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/format.h"
#include "core/mesh/mesh.h"
#include "core/mesh/triangle.h"

namespace shapespline {

namespace {

constexpr double sameShare = 1e-6;  // share of the diagonal

bool isSamePose(const Positions& a, const Positions& b) {
  const Positions* one = &a;
  const double distance = sameShare * boundingDiagonal({&one, 1});
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Vec3& p, const Vec3& q) { return (p - q).squaredNorm() <= distance * distance; });
}

std::string whatToDo(const FileFacts& facts) {
  if (!facts.gltf) return " Export each pose as displayed.";
  std::string text =
      " By default, Blender exports a rig in its rest pose and leaves modifiers out. Apply the modifiers before each "
      "export, or export one GLB with the animation.";
  if (facts.animated == facts.files)
    text +=
        " Each file has its own animation. Take the keys from the animations (on the command line, with "
        "--sample).";
  else if (facts.skinned > 0) text += " The files have bones but no animation, so the bones are at rest.";
  return text;
}

// Area of the faces that are flat within a hundredth of the extent, at either end of an axis.
std::array<double, 2> flatAreas(const Positions& positions, const std::vector<Triangle>& faces, int axis) {
  double low = positions[0][axis], high = low;
  for (const Vec3& p : positions) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  const double slack = (high - low) / 100;
  std::array<double, 2> areas{};
  for (const Triangle& f : faces) {
    const Vec3 &a = positions[f[0]], &b = positions[f[1]], &c = positions[f[2]];
    const double min = std::min({a[axis], b[axis], c[axis]}), max = std::max({a[axis], b[axis], c[axis]});
    if (max <= low + slack) areas[0] += (b - a).cross(c - a).norm() / 2;
    if (min >= high - slack) areas[1] += (b - a).cross(c - a).norm() / 2;
  }
  return areas;
}

bool hasFlatBaseOnZ(const Positions& positions, const std::vector<Triangle>& faces) {
  if (positions.empty()) return false;
  double all = 0;
  for (const Triangle& f : faces)
    all += (positions[f[1]] - positions[f[0]]).cross(positions[f[2]] - positions[f[0]]).norm() / 2;
  const auto alongZ = flatAreas(positions, faces, 2), alongY = flatAreas(positions, faces, 1);
  // A flat base at the bottom, none at the top, and none along y.
  return alongZ[0] > 0.002 * all && alongZ[0] > 4 * alongZ[1] && alongZ[0] > 4 * std::max(alongY[0], alongY[1]);
}

Vec3 centreOfArea(const Positions& positions, const std::vector<Triangle>& faces) {
  Vec3 sum = Vec3::Zero();
  double all = 0;
  for (const Triangle& f : faces) {
    const Vec3 &a = positions[f[0]], &b = positions[f[1]], &c = positions[f[2]];
    const double area = (b - a).cross(c - a).norm();
    sum += area * centroidOf(positions, f);
    all += area;
  }
  return all > 0 ? Vec3(sum / all) : positions[0];
}

// With `axis` up: distance of the centre inside the outline of the floor contact, in widths. Negative if the shape
// would tip over.
double footing(const Positions& positions, const Vec3& centre, int axis) {
  constexpr int directions = 32;
  constexpr double feet = 0.05;  // share of the height
  Vec3 min = positions[0], max = positions[0];
  for (const Vec3& p : positions) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  const Vec3 extent = max - min;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<double, directions> reach;
  reach.fill(-std::numeric_limits<double>::infinity());
  for (const Vec3& p : positions) {
    if (p[axis] > min[axis] + feet * extent[axis]) continue;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * std::numbers::pi * k / directions;
      reach[k] = std::max(reach[k], std::cos(angle) * (p[u] - centre[u]) + std::sin(angle) * (p[v] - centre[v]));
    }
  }
  const double width = std::sqrt(extent[u] * extent[v]);
  return width > 0 ? *std::min_element(reach.begin(), reach.end()) / width : 0;
}

// 1: stands along Z and would tip over along Y; -1: the reverse; 0: undecided.
int standsRather(const Positions& positions, const std::vector<Triangle>& faces) {
  constexpr double stable = 0.04;  // share of the width
  const Vec3 centre = centreOfArea(positions, faces);
  const double y = footing(positions, centre, 1), z = footing(positions, centre, 2);
  return z > stable && y < 0 ? 1 : y > stable && z < 0 ? -1 : 0;
}

// Whether the pose stands on the floor where `axis` is 0, but not where `other` is 0.
bool isOnFloorOf(const Positions& positions, int axis, int other) {
  const Positions* one = &positions;
  const double near = 0.03 * boundingDiagonal({&one, 1});
  double min = positions[0][axis], minOther = positions[0][other];
  for (const Vec3& p : positions) {
    min = std::min(min, p[axis]);
    minOther = std::min(minOther, p[other]);
  }
  return std::abs(min) <= near && std::abs(minOther) > near;
}

}  // namespace

void warnOfSamePoses(const FileFacts& facts, Import& import) {
  const std::vector<Key>& keys = import.keyframes.keys;
  const int count = static_cast<int>(keys.size());
  for (int first = 0, last = 0; first < count; first = last + 1) {
    last = first;
    while (last + 1 < count && isSamePose(keys[first].positions, keys[last + 1].positions)) ++last;
    if (last == first) continue;
    const bool all = last - first + 1 == count;
    import.warnings.push_back(
        {"same-poses",
         "are the same pose, so nothing moves" + std::string(all ? "." : " between them.") + whatToDo(facts),
         last - first + 1,
         last,
         -1,
         {},
         "Keys"});
  }
}

void warnOfSizes(const std::vector<std::string>& files, Import& import) {
  constexpr double suspicious = 20;  // less than the ratio of millimetres to inches
  const std::vector<Key>& keys = import.keyframes.keys;
  std::vector<double> sizes;
  for (const Key& key : keys) {
    const Positions* one = &key.positions;
    const double size = boundingDiagonal({&one, 1});
    sizes.push_back(std::isfinite(size) ? size : 0);
  }
  // Compares with a key of middle size: the first key if it is one.
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[(sorted.size() - 1) / 2];
  const auto usual = [&](double size) { return size < suspicious * middle && middle < suspicious * size; };
  const std::size_t like = std::find_if(sizes.begin(), sizes.end(), usual) - sizes.begin();
  int count = 0, first = -1;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (sizes[k] > 0 && middle > 0 && !usual(sizes[k]) && ++count == 1) first = static_cast<int>(k);
  if (count == 0) return;
  const bool larger = sizes[first] > middle;
  const double ratio = larger ? sizes[first] / sizes[like] : sizes[like] / sizes[first];
  import.warnings.push_back({"sizes-differ",
                             "(" + files[first] + ") is " + grouped(std::llround(std::min(ratio, 1e15))) + " times " +
                                 (larger ? "larger" : "smaller") + " than " + files[like] +
                                 (count > 1 ? ", and other keys differ as much" : "") +
                                 ". If they are in different units, export all poses in the same unit.",
                             count,
                             first,
                             -1,
                             {},
                             "Key"});
}

bool allSame(const Keyframes& keyframes) {
  const std::vector<Key>& keys = keyframes.keys;
  return std::all_of(keys.begin(), keys.end(),
                     [&](const Key& key) { return isSamePose(keys[0].positions, key.positions); });
}

void warnOfDistantKeys(Import& import) {
  constexpr double maxTurning = 1.4;      // measured on captured animations; 1.73 for unrelated poses
  constexpr double maxUnevenness = 0.35;  // evenly spaced keys lie on frames
  const std::vector<Key>& keys = import.keyframes.keys;
  const std::size_t n = keys.size();
  if (import.animation < 0 || !import.project.empty() || n < 4) return;
  const double mean = (keys.back().time - keys.front().time) / static_cast<double>(n - 1);
  double first = 0, second = 0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (std::abs(keys[k + 1].time - keys[k].time - mean) > maxUnevenness * mean) return;
    // Differences as far as in an interval of mean length.
    const auto difference = [&](std::size_t from, std::size_t v) {
      const Vec3 step = keys[from + 1].positions[v] - keys[from].positions[v];
      return Vec3(mean / (keys[from + 1].time - keys[from].time) * step);
    };
    for (std::size_t v = 0; v < keys[k].positions.size(); ++v) {
      const Vec3 step = difference(k, v);
      first += step.squaredNorm() / static_cast<double>(n - 1);
      if (k > 0) second += (step - difference(k - 1, v)).squaredNorm() / static_cast<double>(n - 2);
    }
  }
  if (!(second > maxTurning * maxTurning * first)) return;
  import.warnings.push_back(
      {"keys-far-apart",
       "From key to key, the animation turns back more than it goes on, so a spline swings "
       "between the keys. Add keys: take more from the animation (on the command line, --sample).",
       1});
}

UpAxisGuess guessUpAxis(const Keyframes& keyframes, bool flat) {
  int alongZ = 0, alongY = 0;
  bool onZ = true, onY = true;
  for (const Key& key : keyframes.keys) {
    if (key.positions.empty()) continue;
    const int vote = standsRather(key.positions, keyframes.faces);
    alongZ += vote > 0;
    alongY += vote < 0;
    onZ = onZ && isOnFloorOf(key.positions, 2, 1);
    onY = onY && isOnFloorOf(key.positions, 1, 2);
  }
  flat = flat && !keyframes.keys.empty() && hasFlatBaseOnZ(keyframes.keys[0].positions, keyframes.faces);
  if (onZ && (alongZ > 0 || flat) && alongY == 0) return UpAxisGuess::AlongZ;
  if (onY && alongY > 0 && alongZ == 0) return UpAxisGuess::AlongY;
  return flat || alongZ > alongY ? UpAxisGuess::PerhapsAlongZ : UpAxisGuess::Unknown;
}

Warning zUpWarning(const std::string& where, bool clearly) {
  const std::string seem = clearly ? "seem to" : "may";
  return {clearly ? "z-up" : "z-up-unclear",
          where + " does not state its up axis, and its shapes " + seem +
              " stand along Z. If the shape lies on its back, choose Z as the up axis (on the command line, --up z).",
          1};
}

Warning blenderWarning(const std::string& where, bool clearly) {
  return {clearly ? "z-up" : "z-up-unclear",
          where +
              " was written by Blender, which uses Z up in this format. If the shape lies on its back, choose Z as "
              "the up axis (on the command line, --up z).",
          1};
}

}  // namespace shapespline
