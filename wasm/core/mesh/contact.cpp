#include "core/mesh/contact.h"

#include <algorithm>
#include <cstdint>

namespace shapespline {

namespace {

// Distances are measured in every pose, but searched from this many only.
constexpr int searchedPoses = 4;

std::vector<int> evenlyChosen(int count, int wanted) {
  std::vector<int> chosen;
  const int take = std::min(count, wanted);
  for (int i = 0; i < take; ++i) chosen.push_back(take == 1 ? 0 : i * (count - 1) / (take - 1));
  return chosen;
}

}  // namespace

ContactSearch::ContactSearch(std::span<const Positions* const> poses, const std::vector<int>& vertices)
    : poses_(poses) {
  for (int pose : evenlyChosen(static_cast<int>(poses.size()), searchedPoses)) {
    trees_.emplace_back(*poses[pose], vertices);
    searched_.push_back(poses[pose]);
  }
}

double ContactSearch::distance(int a, int b) const {
  double largest = 0;
  for (const Positions* p : poses_) largest = std::max(largest, ((*p)[a] - (*p)[b]).squaredNorm());
  return largest;
}

std::vector<int> spreadSample(const std::vector<int>& items, int limit) {
  const auto size = static_cast<std::int64_t>(items.size());
  if (size <= limit) return items;
  std::vector<int> kept(limit);
  for (int i = 0; i < limit; ++i) kept[i] = items[i * size / limit];
  return kept;
}

}  // namespace shapespline
