#include "shapes/bench_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

namespace shapespline {
namespace {

constexpr double radius = capsuleRadius, tube = capsuleTube;

// A box grid of across x across x (across + along) cells. Its ends become half spheres, like a cube inflated to a
// sphere. The cells between them become a tube.
struct Grid {
  int across = 2;  // even, so the half spheres meet the tube at a grid line
  int along = 0;

  int faces() const { return 12 * across * across + 8 * across * along; }
};

// The finest grid with at most this number of faces and roughly square cells.
Grid chooseGrid(int faces) {
  const double ratio = tube / (radius * M_PI / 2);  // along over across
  Grid grid;
  grid.across = std::max(2, 2 * static_cast<int>(std::sqrt(faces / (12 + 8 * ratio)) / 2));
  grid.along = std::max(0, (faces - 12 * grid.across * grid.across) / (8 * grid.across));
  return grid;
}

class GridSurface {
 public:
  GridSurface(const Grid& grid, Random& random) : grid_(grid), random_(random) {}

  Surface build() {
    const int size[3] = {grid_.across, grid_.across, grid_.across + grid_.along};
    surface_.positions.reserve(grid_.faces() / 2 + 2);
    surface_.faces.reserve(grid_.faces());
    for (int axis = 0; axis < 3; ++axis) {
      for (int level : {0, size[axis]}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < size[u]; ++i) {
          for (int j = 0; j < size[v]; ++j) addQuad(axis, level, i, j);
        }
      }
    }
    return std::move(surface_);
  }

 private:
  using Node = std::array<int, 3>;

  void addQuad(int axis, int level, int i, int j) {
    std::array<int, 4> q;
    constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int c = 0; c < 4; ++c) {
      Node n;
      n[axis] = level;
      n[(axis + 1) % 3] = i + corners[c][0];
      n[(axis + 2) % 3] = j + corners[c][1];
      q[c] = vertex(n);
    }
    if (level == 0) std::swap(q[1], q[3]);
    if (random_.below(2)) std::rotate(q.begin(), q.begin() + 1, q.end());
    surface_.faces.push_back({q[0], q[1], q[2]});
    surface_.faces.push_back({q[0], q[2], q[3]});
  }

  int vertex(const Node& n) {
    const std::uint64_t key = (std::uint64_t(n[0]) << 42) | (std::uint64_t(n[1]) << 21) | std::uint64_t(n[2]);
    const auto [place, isNew] = index_.try_emplace(key, static_cast<int>(surface_.positions.size()));
    if (isNew) surface_.positions.push_back(onCapsule(n));
    return place->second;
  }

  // Moved by up to a quarter of a cell within its side (but not off an edge of the box), then inflated.
  Vec3 onCapsule(const Node& n) {
    Vec3 p;
    const int half = grid_.across / 2;
    double lift = 0;
    for (int k = 0; k < 3; ++k) {
      const int last = k == 2 ? grid_.across + grid_.along : grid_.across;
      const double moved = n[k] + (n[k] == 0 || n[k] == last ? 0 : random_.uniform(-0.25, 0.25));
      if (k < 2) {
        p[k] = moved / half - 1;
      } else {
        const double low = std::min<double>(moved, half), high = std::max<double>(moved, half + grid_.along);
        p[k] = (low - half + high - half - grid_.along) / half;
        lift = grid_.along > 0 ? tube * (std::clamp<double>(moved, half, half + grid_.along) - half) / grid_.along : 0;
      }
    }
    const Vec3 blown = (M_PI / 4 * p).array().tan();  // equal angles instead of equal lengths
    return radius * blown.normalized() + (lift - tube / 2) * Vec3::UnitZ();
  }

  Grid grid_;
  Random& random_;
  Surface surface_;
  std::unordered_map<std::uint64_t, int> index_;
};

std::uint64_t edgeKey(int a, int b) { return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b)); }

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(static_cast<int>(i))]);
}

// Waves of several lengths that move the surface out and in, by at most a sixth of the radius.
void addBumps(Positions& positions, Random& random) {
  constexpr int waves = 6;
  std::array<Vec3, waves> direction;
  std::array<double, waves> phase;
  for (int i = 0; i < waves; ++i) {
    for (int k = 0; k < 3; ++k) direction[i][k] = random.uniform(-1, 1);
    direction[i] *= (2.0 + i) / std::max(direction[i].norm(), 0.1);
    phase[i] = random.uniform(0, 2 * M_PI);
  }
  for (Vec3& p : positions) {
    double height = 0;
    for (int i = 0; i < waves; ++i) height += std::sin(direction[i].dot(p) + phase[i]) / (2.0 + i);
    const Vec3 core(0, 0, std::clamp(p.z(), -tube / 2, tube / 2));
    p += 0.1 * height * (p - core);
  }
}

}  // namespace

Surface bumpyCapsule(int faces, Random& random) {
  Surface surface = GridSurface(chooseGrid(faces), random).build();
  splitEdges(surface, faces, random, [] { return 0.5; });
  addBumps(surface.positions, random);
  return surface;
}

Surface gridSphere(int faces, Random& random) {
  Surface surface = GridSurface({std::max(2, 2 * static_cast<int>(std::sqrt(faces / 12.0) / 2)), 0}, random).build();
  for (Vec3& p : surface.positions) p.z() += tube / 2;
  return surface;
}

std::vector<int> oppositeHalfEdges(const std::vector<Triangle>& faces) {
  std::vector<int> result(3 * faces.size(), -1);
  std::unordered_map<std::uint64_t, int> open;
  open.reserve(2 * faces.size());
  for (int h = 0; h < static_cast<int>(result.size()); ++h) {
    const Triangle& face = faces[h / 3];
    const std::uint64_t key = edgeKey(face[h % 3], face[(h + 1) % 3]);
    const auto other = open.find(key);
    if (other == open.end()) {
      open[key] = h;
    } else {
      result[h] = other->second;
      result[other->second] = h;
      open.erase(other);
    }
  }
  return result;
}

void splitEdges(Surface& surface, int faces, Random& random, const std::function<double()>& fraction) {
  const std::vector<int> opposite = oppositeHalfEdges(surface.faces);
  std::vector<bool> split(surface.faces.size(), false);
  while (static_cast<int>(surface.faces.size()) + 2 <= faces) {
    const int h = random.below(static_cast<int>(opposite.size())), g = opposite[h];
    if (g < 0 || split[h / 3] || split[g / 3]) continue;
    const int a = surface.faces[h / 3][h % 3], b = surface.faces[g / 3][g % 3];
    const int left = surface.faces[h / 3][(h + 2) % 3], right = surface.faces[g / 3][(g + 2) % 3];
    const int middle = static_cast<int>(surface.positions.size());
    const double share = fraction();
    surface.positions.push_back((1 - share) * surface.positions[a] + share * surface.positions[b]);
    surface.faces[h / 3] = {a, middle, left};
    surface.faces[g / 3] = {b, middle, right};
    surface.faces.push_back({middle, b, left});
    surface.faces.push_back({middle, a, right});
    split[h / 3] = split[g / 3] = true;
  }
}

std::vector<int> shuffle(Surface& surface, Random& random) {
  std::vector<int> place(surface.positions.size());
  std::iota(place.begin(), place.end(), 0);
  shuffle(place, random);
  Positions moved(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) moved[place[v]] = surface.positions[v];
  surface.positions = std::move(moved);
  for (Triangle& face : surface.faces) {
    for (int& v : face) v = place[v];
    std::rotate(face.begin(), face.begin() + random.below(3), face.end());
  }
  shuffle(surface.faces, random);
  return place;
}

Deformation randomDeformation(Random& random) {
  Deformation d;
  d.bend = random.uniform(60, 120) * M_PI / 180;
  d.twist = random.uniform(-180, 180) * M_PI / 180;
  d.direction = random.uniform(0, 2 * M_PI);
  return d;
}

Vec3 deformed(const Deformation& d, const Vec3& p) {
  constexpr double length = tube + 2 * radius;
  const double s = p.z() / length, angle = s * d.bend;
  const Eigen::AngleAxisd along(d.direction, Vec3::UnitZ());
  const Vec3 flat = along.inverse() * (Eigen::AngleAxisd(s * d.twist, Vec3::UnitZ()) * Vec3(p.x(), p.y(), 0));
  const double curvature = d.bend / length;
  const Vec3 centre =
      std::abs(curvature) < 1e-9 ? Vec3(0, 0, p.z()) : Vec3(Vec3(1 - std::cos(angle), 0, std::sin(angle)) / curvature);
  return along * (centre + Eigen::AngleAxisd(angle, Vec3::UnitY()) * flat);
}

}  // namespace shapespline
