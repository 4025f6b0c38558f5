#include "core/ghost/face_budget.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/base/coarse_cost.h"

namespace shapespline {

namespace {

constexpr int tetrahedron = 4;

}  // namespace

FaceShares shareFaces(const WeldedShape& shape, const ShapeParts& parts, int target) {
  const int pieces = parts.pieces.count;
  std::vector<int> count(pieces, 0);
  std::vector<double> area(pieces, 0);
  std::int64_t total = 0;
  for (int f = 0; f < shape.faceCount(); ++f) {
    if (!parts.hasArea[f]) continue;
    ++total;
    ++count[parts.pieces.ofFace[f]];
    area[parts.pieces.ofFace[f]] += referenceFrame(shape, f).area;
  }

  FaceShares shares;
  std::int64_t sum = 0;
  for (int c : count) {
    const auto half = static_cast<int>(static_cast<std::int64_t>(target) * c / (2 * total));
    shares.least.push_back(std::min(c, std::max(tetrahedron, half)));
    sum += shares.least.back();
  }
  std::vector<int> order(pieces);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return coarse(area[a]) < coarse(area[b]); });
  for (int piece : order) {
    if (sum <= target) break;
    if (piece == parts.tree.root()) continue;
    sum -= shares.least[piece];
    shares.least[piece] = 0;
    ++shares.joined;
  }
  return shares;
}

}  // namespace shapespline
