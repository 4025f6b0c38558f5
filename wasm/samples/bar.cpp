// A box 10 x 1 x 1 with rounded edges, twisted by 0, 180 and 350 degrees about its axis.
#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "samples/sample.h"
#include "samples/surface.h"

namespace shapespline {
namespace {

const Vec3 halfSize(5, 0.5, 0.5);
constexpr double rounding = 0.15;
constexpr double cell = 0.11;
constexpr int arcCells = 2;  // on each side of an edge, over an eighth of a turn

// Places of the grid lines along one side of the box, from -half to half: even in the flat part, and near the ends so
// that they turn by equal angles once the edge is rounded.
std::vector<double> gridLines(double half) {
  const double flat = half - rounding;
  std::vector<double> lines;
  for (int i = arcCells; i > 0; --i) lines.push_back(-flat - rounding * std::tan(M_PI / 4 * i / arcCells));
  const int cells = std::max(1, static_cast<int>(std::lround(2 * flat / cell)));
  for (int i = 0; i <= cells; ++i) lines.push_back(flat * (2.0 * i / cells - 1));
  for (int i = 1; i <= arcCells; ++i) lines.push_back(flat + rounding * std::tan(M_PI / 4 * i / arcCells));
  return lines;
}

Vec3 roundedBox(const Vec3& onBox) {
  const Vec3 inner = halfSize - Vec3::Constant(rounding);
  const Vec3 core = onBox.cwiseMin(inner).cwiseMax(-inner);
  return core + rounding * (onBox - core).normalized();
}

class BoxBuilder {
 public:
  Surface build() {
    for (int k = 0; k < 3; ++k) lines_[k] = gridLines(halfSize[k]);
    for (int axis = 0; axis < 3; ++axis) {
      addSide(axis, 0);
      addSide(axis, static_cast<int>(lines_[axis].size()) - 1);
    }
    return std::move(surface_);
  }

 private:
  using Node = std::array<int, 3>;

  void addSide(int axis, int level) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i + 1 < static_cast<int>(lines_[u].size()); ++i) {
      for (int j = 0; j + 1 < static_cast<int>(lines_[v].size()); ++j) {
        const auto node = [&](int a, int b) {
          Node n;
          n[axis] = level;
          n[u] = i + a;
          n[v] = j + b;
          return vertex(n);
        };
        addQuad({node(0, 0), node(1, 0), node(1, 1), node(0, 1)}, level == 0, (i + j) % 2 == 0);
      }
    }
  }

  // Diagonals alternate, so that no direction of twist is favoured.
  void addQuad(std::array<int, 4> q, bool turned, bool otherDiagonal) {
    if (turned) std::swap(q[1], q[3]);
    if (otherDiagonal) std::rotate(q.begin(), q.begin() + 1, q.end());
    surface_.faces.push_back({q[0], q[1], q[2]});
    surface_.faces.push_back({q[0], q[2], q[3]});
  }

  int vertex(const Node& n) {
    const auto [place, isNew] = index_.try_emplace(n, static_cast<int>(surface_.positions.size()));
    if (isNew) surface_.positions.push_back(roundedBox({lines_[0][n[0]], lines_[1][n[1]], lines_[2][n[2]]}));
    return place->second;
  }

  std::array<std::vector<double>, 3> lines_;
  std::map<Node, int> index_;
  Surface surface_;
};

// The left end stands still, the right one turns by the whole angle.
Positions twisted(const Positions& rest, double angle) {
  Positions result;
  for (const Vec3& p : rest) {
    const double share = (p.x() + halfSize.x()) / (2 * halfSize.x());
    result.push_back(Eigen::AngleAxisd(share * angle, Vec3::UnitX()) * p);
  }
  return result;
}

}  // namespace

Sample makeTwistedBar() {
  const Surface surface = BoxBuilder().build();
  Keyframes keyframes;
  keyframes.faces = surface.faces;
  const double degrees[] = {0, 180, 350};
  for (int j = 0; j < 3; ++j) {
    const std::string name = std::to_string(int(degrees[j])) + " degrees";
    keyframes.keys.push_back({name, 0.5 * j, twisted(surface.positions, degrees[j] * M_PI / 180)});
  }
  return {"twisted-bar",
          "Twisted bar",
          "A bar twisted by 0, 180 and 350 degrees: blending positions would squeeze it thin.",
          BoundaryKind::Natural,
          std::move(keyframes),
          0xd9b36a};
}

}  // namespace shapespline
