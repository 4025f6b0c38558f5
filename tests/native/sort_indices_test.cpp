// The shared sort for all orders of indices.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "core/base/sort_indices.h"

namespace shapespline::test::sort_indices_test {

TEST_CASE("indices are sorted by their values, equal values by index") {
  std::mt19937 random(5);
  for (const int count : {0, 1, 2, 3, 5, 6, 30, 31, 200, 5000}) {
    CAPTURE(count);
    std::vector<int> key(count);
    for (int& k : key) k = static_cast<int>(random() % 50);
    std::vector<int> sorted(count);
    std::iota(sorted.begin(), sorted.end(), 0);
    std::vector<int> expected = sorted;
    std::shuffle(sorted.begin(), sorted.end(), random);
    sortIndices(sorted, [&](int a, int b) { return std::pair(key[a], a) < std::pair(key[b], b); });
    std::stable_sort(expected.begin(), expected.end(), [&](int a, int b) { return key[a] < key[b]; });
    CHECK(sorted == expected);
  }
}

TEST_CASE("a part of a list is sorted in place") {
  std::vector<int> list = {9, 4, 3, 2, 1, 0};
  sortIndices(std::span(list).subspan(1, 4), [](int a, int b) { return a < b; });
  CHECK(list == std::vector{9, 1, 2, 3, 4, 0});
}

}  // namespace shapespline::test::sort_indices_test
