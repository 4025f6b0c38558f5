#include "core/mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

constexpr double shareOfDiagonal = 1e-6;
// Slightly more than the difference between two roundings of one number.
constexpr double float32Roundings = 4 * 0x1p-24;

// Points in a hash grid. Cells are much wider than the tolerance, so most look-ups visit one cell.
class Grid {
 public:
  Grid(const Positions& positions, double tolerance)
      : positions_(positions), tolerance_(tolerance), cell_(8 * tolerance), next_(positions.size(), -1) {
    std::size_t size = 16;
    while (size < 2 * positions.size()) size *= 2;
    head_.assign(size, -1);
  }

  void add(int vertex) {
    int& head = head_[slot(cube(positions_[vertex]))];
    next_[vertex] = head;
    head = vertex;
  }

  // The lowest vertex for which match holds, or -1. Tests all vertices that may be within the tolerance of p.
  template <class Match>
  int find(const Vec3& p, Match match) const {
    const Cube low = cube(p - Vec3::Constant(tolerance_)), high = cube(p + Vec3::Constant(tolerance_));
    int best = -1;
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          for (int v = head_[slot({x, y, z})]; v >= 0; v = next_[v])
            if (match(v) && (best < 0 || v < best)) best = v;
    return best;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;

  Cube cube(const Vec3& p) const {
    // Clamped, because large coordinates over a tiny tolerance could overflow the conversion.
    const auto index = [&](double x) {
      return static_cast<std::int64_t>(std::clamp(std::floor(x / cell_), -1e18, 1e18));
    };
    return {index(p.x()), index(p.y()), index(p.z())};
  }

  // Different cells may share a slot, because find() compares positions anyway.
  std::size_t slot(const Cube& c) const {
    std::uint64_t h = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(c[1]) * 0xBF58476D1CE4E5B9ull;
    h = (h ^ (h >> 31)) + static_cast<std::uint64_t>(c[2]) * 0x94D049BB133111EBull;
    h ^= h >> 30;
    return static_cast<std::size_t>(h & (head_.size() - 1));
  }

  const Positions& positions_;
  double tolerance_, cell_;
  std::vector<int> head_, next_;
};

// Combines each vertex's positions in all poses, in units of the tolerances. Copies are within 1 of each other. Parts
// that are one point in some pose are separated by the others. Different weights prevent poses from cancelling.
Positions placesInAllPoses(std::span<const Positions* const> poses, std::span<const double> tolerance) {
  Positions places(poses[0]->size(), Vec3::Zero());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (!(tolerance[k] > 0 && std::isfinite(tolerance[k]))) continue;
    const double share = std::fmod((static_cast<double>(k) + 1) * std::numbers::phi, 1.0);
    const double scale = (1 + share) / (2 * static_cast<double>(poses.size()) * tolerance[k]);
    inBlocks({}, places.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) places[v] += scale * ((*poses[k])[v] - (*poses[k])[0]);
    });
  }
  return places;
}

bool isFloat32(const Positions& pose) {
  return std::all_of(pose.begin(), pose.end(), [](const Vec3& p) { return p.cast<float>().cast<double>() == p; });
}

double toleranceOf(const Positions& pose) {
  const Positions* one = &pose;
  const double size = shareOfDiagonal * boundingDiagonal({&one, 1});
  double farthest = 0;
  for (const Vec3& p : pose) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  const double rounding = float32Roundings * farthest;
  return rounding > size && isFloat32(pose) ? rounding : size;
}

}  // namespace

std::vector<double> weldTolerances(std::span<const Positions* const> poses) {
  std::vector<double> tolerance;
  for (const Positions* pose : poses) tolerance.push_back(toleranceOf(*pose));
  return tolerance;
}

Welding weld(std::span<const Positions* const> poses, std::span<const double> tolerance,
             const FractionReport& onProgress) {
  Welding welding;
  const int n = static_cast<int>(poses[0]->size());
  welding.weldedOfRaw.resize(n);
  const Positions places = placesInAllPoses(poses, tolerance);
  Grid grid(places, 1);
  const auto coincide = [&](int a, int b) {
    for (std::size_t k = 0; k < poses.size(); ++k)
      if (!(((*poses[k])[a] - (*poses[k])[b]).squaredNorm() <= tolerance[k] * tolerance[k])) return false;
    return true;
  };
  inBlocks(onProgress, static_cast<std::size_t>(n), [&](std::size_t begin, std::size_t end) {
    for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v) {
      const int twin = grid.find(places[v], [&](int candidate) { return coincide(candidate, v); });
      if (twin >= 0) {
        welding.weldedOfRaw[v] = welding.weldedOfRaw[twin];
        continue;
      }
      grid.add(v);
      welding.weldedOfRaw[v] = welding.count++;
      welding.rawOfWelded.push_back(v);
    }
  });
  return welding;
}

std::vector<Triangle> weldFaces(const std::vector<Triangle>& faces, const Welding& welding) {
  std::vector<Triangle> welded(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int c = 0; c < 3; ++c) welded[f][c] = welding.weldedOfRaw[faces[f][c]];
  return welded;
}

Positions weldPositions(const Positions& raw, const Welding& welding) {
  Positions welded(welding.count), away(welding.count, Vec3::Zero());
  std::vector<int> copies(welding.count, 0);
  inBlocks({}, raw.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const int w = welding.weldedOfRaw[v];
      ++copies[w];
      away[w] += raw[v] - raw[welding.rawOfWelded[w]];
    }
  });
  // Bitwise equal copies keep their exact position.
  for (int w = 0; w < welding.count; ++w) welded[w] = raw[welding.rawOfWelded[w]] + away[w] / copies[w];
  return welded;
}

std::vector<int> shadingGroups(const Welding& welding, const Positions& rawNormals, int& groups) {
  const double agree = std::cos(std::numbers::pi / 180);
  const int n = static_cast<int>(welding.weldedOfRaw.size());
  std::vector<int> group(n);
  if (rawNormals.size() != static_cast<std::size_t>(n)) {
    groups = welding.count;
    return welding.weldedOfRaw;
  }
  groups = 0;
  std::vector<int> next(n, -1), last(welding.count, -1);  // chains of each group's first copies, by welded vertex
  std::vector<int> head(welding.count, -1);
  for (int v = 0; v < n; ++v) {
    const int w = welding.weldedOfRaw[v];
    const Vec3 normal = rawNormals[v].normalized();
    int twin = head[w];
    while (twin >= 0 && !(rawNormals[twin].normalized().dot(normal) >= agree)) twin = next[twin];
    if (twin >= 0) {
      group[v] = group[twin];
      continue;
    }
    group[v] = groups++;
    (head[w] < 0 ? head[w] : next[last[w]]) = v;
    last[w] = v;
  }
  return group;
}

}  // namespace shapespline
