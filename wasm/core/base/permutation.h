// Checks that a list contains every index once, a frequent precondition.
#pragma once

#include <span>
#include <vector>

namespace shapespline {

inline bool isPermutation(std::span<const int> list) {
  std::vector<char> named(list.size(), 0);
  for (const int i : list) {
    if (i < 0 || i >= static_cast<int>(list.size()) || named[i]) return false;
    named[i] = 1;
  }
  return true;
}

}  // namespace shapespline
