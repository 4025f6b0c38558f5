#include "core/face_halves.h"

#include <algorithm>
#include <cstddef>

namespace shapespline {

FaceHalves halveFaces(const std::vector<int>& order, const std::vector<Triangle>& corners, int count, int shared) {
  const std::size_t half = order.size() / 2;
  std::vector<char> users(count, 0);  // of each corner: a bit for each half
  if (shared >= 0) users[shared] = 3;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int c : corners[order[i]]) users[c] |= i < half ? 1 : 2;

  FaceHalves halves;
  std::vector<int> second, rest;
  const auto cutToFours = [&rest](std::vector<int>& list) {
    const auto end = list.end() - static_cast<std::ptrdiff_t>(list.size() % 4);
    rest.insert(rest.end(), end, list.end());
    list.erase(end, list.end());
    return static_cast<int>(list.size());
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Triangle& t = corners[order[i]];
    const bool between = std::any_of(t.begin(), t.end(), [&](int c) { return users[c] == 3; });
    (between ? rest : i < half ? halves.order : second).push_back(order[i]);
  }
  halves.first = cutToFours(halves.order);
  halves.second = cutToFours(second);
  halves.order.insert(halves.order.end(), second.begin(), second.end());
  halves.order.insert(halves.order.end(), rest.begin(), rest.end());
  return halves;
}

}  // namespace shapespline
