#include "core/ghost/face_budget.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/base/coarse_cost.h"
#include "core/base/sort_indices.h"

namespace shapespline {

namespace {

constexpr int tetrahedron = 4;

}  // namespace

FaceBudget budgetFaces(const WeldedShape& shape, const ShapeTopology& topology, int target) {
  const int components = topology.components.count;
  std::vector<int> count(components, 0);
  std::vector<double> area(components, 0);
  std::int64_t total = 0;
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (!topology.turns[f]) continue;
    ++total;
    ++count[topology.components.ofFace[f]];
    area[topology.components.ofFace[f]] += referenceFrame(shape, f).area;
  }

  FaceBudget budget;
  std::int64_t sum = 0;
  for (int c : count) {
    const auto half = static_cast<int>(static_cast<std::int64_t>(target) * c / (2 * total));
    budget.least.push_back(std::min(c, std::max(tetrahedron, half)));
    sum += budget.least.back();
  }
  std::vector<int> order(components);
  std::iota(order.begin(), order.end(), 0);
  sortIndices(order, [&](int a, int b) { return std::pair(coarse(area[a]), a) < std::pair(coarse(area[b]), b); });
  for (int component : order) {
    if (sum <= target) break;
    if (component == topology.tree.root()) continue;
    sum -= budget.least[component];
    budget.least[component] = 0;
    ++budget.joined;
  }
  return budget;
}

}  // namespace shapespline
