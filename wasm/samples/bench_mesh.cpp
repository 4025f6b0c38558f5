#include "samples/bench_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "samples/random.h"
#include "samples/surface.h"

namespace shapespline {
namespace {

constexpr double radius = 1, tube = 6;  // the capsule is `tube` long between its half spheres

// A box grid of across x across x (across + along) cells. The ends become half spheres, as a cube is blown up to a
// sphere, and the cells between them a tube.
struct Grid {
  int across = 2;  // even: the half spheres meet the tube at a grid line
  int along = 0;

  int faces() const { return 12 * across * across + 8 * across * along; }
};

// The finest grid that has at most so many faces, with cells about as long as wide.
Grid chooseGrid(int faces) {
  const double ratio = tube / (radius * M_PI / 2);  // of along to across
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

  // Moved by up to a quarter of a cell within its side (and not off an edge of the box), then blown up.
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

// For face f and corner c the half-edge 3 f + c runs from that corner to the next; gives the opposite half-edges.
std::vector<int> opposites(const std::vector<Triangle>& faces) {
  std::vector<int> result(3 * faces.size());
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

// Splits random edges, each with two faces that have not been split yet, until the surface has so many faces.
void addFaces(Surface& surface, int faces, Random& random) {
  const std::vector<int> opposite = opposites(surface.faces);
  std::vector<bool> split(surface.faces.size(), false);
  while (static_cast<int>(surface.faces.size()) + 2 <= faces) {
    const int h = static_cast<int>(random.below(opposite.size())), g = opposite[h];
    if (split[h / 3] || split[g / 3]) continue;
    const int a = surface.faces[h / 3][h % 3], b = surface.faces[g / 3][g % 3];
    const int left = surface.faces[h / 3][(h + 2) % 3], right = surface.faces[g / 3][(g + 2) % 3];
    const int middle = static_cast<int>(surface.positions.size());
    surface.positions.push_back(0.5 * (surface.positions[a] + surface.positions[b]));
    surface.faces[h / 3] = {a, middle, left};
    surface.faces[g / 3] = {b, middle, right};
    surface.faces.push_back({middle, b, left});
    surface.faces.push_back({middle, a, right});
    split[h / 3] = split[g / 3] = true;
  }
}

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

void shuffle(Surface& surface, Random& random) {
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
}

// Waves of several lengths that push the surface out and in, by at most a sixth of the radius.
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

struct Deformation {
  double bend = 0, twist = 0, direction = 0;  // radians over the whole length; direction of the bend about the axis
};

// The axis becomes an arc of the same length; cross-sections stay flat, are twisted about it and turned with it.
Vec3 deformed(const Deformation& d, const Vec3& p) {
  constexpr double length = tube + 2 * radius;
  const double s = p.z() / length, angle = s * d.bend;
  const Eigen::AngleAxisd along(d.direction, Vec3::UnitZ());
  const Vec3 flat = along.inverse() * (Eigen::AngleAxisd(s * d.twist, Vec3::UnitZ()) * Vec3(p.x(), p.y(), 0));
  const double curvature = d.bend / length;
  const Vec3 centre = std::abs(curvature) < 1e-9 ? Vec3(0, 0, p.z())
                                                 : Vec3(Vec3(1 - std::cos(angle), 0, std::sin(angle)) / curvature);
  return along * (centre + Eigen::AngleAxisd(angle, Vec3::UnitY()) * flat);
}

}  // namespace

Keyframes makeBenchKeyframes(int faces, int keys, std::uint32_t seed) {
  Random random(seed);
  faces = std::max(64, faces + faces % 2);
  keys = std::max(2, keys);
  Surface surface = GridSurface(chooseGrid(faces), random).build();
  addFaces(surface, faces, random);
  addBumps(surface.positions, random);
  shuffle(surface, random);

  Keyframes result;
  for (int j = 0; j < keys; ++j) {
    Deformation d;
    if (j > 0) {
      d.bend = random.uniform(60, 120) * M_PI / 180;
      d.twist = random.uniform(-180, 180) * M_PI / 180;
      d.direction = random.uniform(0, 2 * M_PI);
    }
    Key key{"key " + std::to_string(j + 1), double(j) / (keys - 1), {}};
    key.positions.reserve(surface.positions.size());
    for (const Vec3& p : surface.positions) key.positions.push_back(deformed(d, p));
    result.keys.push_back(std::move(key));
  }
  result.faces = std::move(surface.faces);
  return result;
}

Keyframes subdivided(const Keyframes& keyframes) {
  Keyframes result;
  result.keys = keyframes.keys;
  const std::vector<int> opposite = opposites(keyframes.faces);
  std::vector<int> middle(opposite.size());
  int count = keyframes.vertexCount();
  for (int h = 0; h < static_cast<int>(opposite.size()); ++h) {
    if (opposite[h] < h) {
      middle[h] = middle[opposite[h]];
      continue;
    }
    const int a = keyframes.faces[h / 3][h % 3], b = keyframes.faces[h / 3][(h + 1) % 3];
    for (Key& key : result.keys) key.positions.push_back(0.5 * (key.positions[a] + key.positions[b]));
    middle[h] = count++;
  }
  result.faces.reserve(4 * keyframes.faces.size());
  for (int f = 0; f < keyframes.faceCount(); ++f) {
    const auto [a, b, c] = keyframes.faces[f];
    const int ab = middle[3 * f], bc = middle[3 * f + 1], ca = middle[3 * f + 2];
    result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

}  // namespace shapespline
