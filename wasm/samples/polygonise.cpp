#include "samples/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace shapespline {
namespace {

// Kuhn's six tetrahedra of a cube, as corner numbers with x in bit 0, y in bit 1, z in bit 2: neighbouring cubes agree
// on the diagonals of their common face, so the surface closes.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

constexpr int block = 6;  // cells

class Marcher {
 public:
  Marcher(const Field& field, const Vec3& low, const Vec3& high, double cell) : low_(low), cell_(cell) {
    for (int k = 0; k < 3; ++k) size_[k] = static_cast<int>(std::ceil((high[k] - low[k]) / cell)) + 1;
    values_.resize(std::size_t(size_[0]) * size_[1] * size_[2]);
    for (int z = 0; z < size_[2]; z += block) {
      for (int y = 0; y < size_[1]; y += block) {
        for (int x = 0; x < size_[0]; x += block) sampleBlock(field, {x, y, z});
      }
    }
  }

  Surface run() {
    for (int z = 0; z + 1 < size_[2]; ++z) {
      for (int y = 0; y + 1 < size_[1]; ++y) {
        for (int x = 0; x + 1 < size_[0]; ++x) marchCube({x, y, z});
      }
    }
    return std::move(surface_);
  }

 private:
  using Cell = std::array<int, 3>;

  // Far from the surface one value stands for a whole block: the field changes about as fast as the distance.
  void sampleBlock(const Field& field, const Cell& first) {
    const double middle = field(corner(first) + Vec3::Constant(0.5 * block * cell_));
    const bool far = std::abs(middle) > 2 * 0.5 * std::sqrt(3.0) * block * cell_;
    for (int z = first[2]; z < std::min(first[2] + block, size_[2]); ++z) {
      for (int y = first[1]; y < std::min(first[1] + block, size_[1]); ++y) {
        for (int x = first[0]; x < std::min(first[0] + block, size_[0]); ++x) {
          values_[index({x, y, z})] = far ? middle : awayFromZero(field(corner({x, y, z})));
        }
      }
    }
  }

  // A corner exactly on the surface would put several vertices in one place.
  double awayFromZero(double value) const { return std::abs(value) < 1e-3 * cell_ ? 1e-3 * cell_ : value; }

  Vec3 corner(const Cell& c) const { return low_ + cell_ * Vec3(c[0], c[1], c[2]); }
  std::int64_t index(const Cell& c) const { return (std::int64_t(c[2]) * size_[1] + c[1]) * size_[0] + c[0]; }

  void marchCube(const Cell& c) {
    std::array<Cell, 8> corners;
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
      corners[i] = {c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2 & 1)};
      inside += values_[index(corners[i])] < 0;
    }
    if (inside == 0 || inside == 8) return;
    for (const auto& t : tetrahedra) marchTetrahedron({corners[t[0]], corners[t[1]], corners[t[2]], corners[t[3]]});
  }

  void marchTetrahedron(const std::array<Cell, 4>& c) {
    std::array<int, 4> in{}, out{};
    int ins = 0, outs = 0;
    for (int i = 0; i < 4; ++i) (values_[index(c[i])] < 0 ? in[ins++] : out[outs++]) = i;
    // The corners are positively oriented; an odd permutation (inside corners first) turns the triangle round.
    const auto cut = [&](int a, int b) { return vertexOnEdge(c[a], c[b]); };
    if (ins == 1) addFace(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]), in[0] % 2 == 1);
    if (ins == 3) addFace(cut(out[0], in[0]), cut(out[0], in[1]), cut(out[0], in[2]), out[0] % 2 == 0);
    if (ins == 2) {
      const bool odd = (in[0] + in[1]) % 2 == 0;
      const int a = cut(in[0], out[0]), b = cut(in[0], out[1]), d = cut(in[1], out[1]), e = cut(in[1], out[0]);
      addFace(a, b, d, odd);
      addFace(a, d, e, odd);
    }
  }

  void addFace(int a, int b, int c, bool turned) {
    surface_.faces.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
  }

  int vertexOnEdge(const Cell& a, const Cell& b) {
    const std::int64_t i = index(a), j = index(b);
    const std::int64_t key = std::min(i, j) * std::int64_t(values_.size()) + std::max(i, j);
    const auto [place, isNew] = vertices_.try_emplace(key, static_cast<int>(surface_.positions.size()));
    if (isNew) {
      const double t = values_[i] / (values_[i] - values_[j]);
      surface_.positions.push_back((1 - t) * corner(a) + t * corner(b));
    }
    return place->second;
  }

  Vec3 low_;
  double cell_;
  Cell size_{};
  std::vector<double> values_;
  std::unordered_map<std::int64_t, int> vertices_;
  Surface surface_;
};

}  // namespace

Surface polygonise(const Field& field, const Vec3& low, const Vec3& high, double cell) {
  return Marcher(field, low, high, cell).run();
}

}  // namespace shapespline
