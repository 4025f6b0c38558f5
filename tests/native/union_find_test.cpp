#include "core/base/union_find.h"

#include <doctest/doctest.h>

namespace shapespline::test::union_find_test {

TEST_CASE("a set is identified by its least member, in any order of joining") {
  UnionFind sets(8);
  CHECK(sets.find(7) == 7);
  CHECK(sets.join(6, 4));
  CHECK(sets.join(2, 6));
  CHECK_FALSE(sets.join(4, 2));
  CHECK(sets.join(7, 5));
  CHECK(sets.join(5, 4));
  for (int x : {2, 4, 5, 6, 7}) CHECK(sets.find(x) == 2);
  for (int x : {0, 1, 3}) CHECK(sets.find(x) == x);
}

TEST_CASE("after a reset, all sets are separate") {
  UnionFind sets(3);
  sets.join(0, 2);
  sets.reset(4);
  for (int x = 0; x < 4; ++x) CHECK(sets.find(x) == x);
}

}  // namespace shapespline::test::union_find_test
