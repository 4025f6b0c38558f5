// Equal triangles in another order, and polygons with other cuts.
#include <doctest/doctest.h>

#include "core/mesh/same_surface.h"

namespace shapespline::test::same_surface_test {

namespace {

// Two adjacent quads, 0 1 2 3 and 1 4 5 2, and a pentagon 2 5 6 7 8 on top.
const std::vector<Triangle> meshText = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {2, 5, 6}, {2, 6, 7}, {2, 7, 8}};

}  // namespace

TEST_CASE("triangles in any order, starting at any corner, are the same surface") {
  CHECK(sameSurface(meshText, meshText));
  CHECK(sameSurface(meshText, {{2, 7, 8}, {2, 0, 1}, {6, 2, 5}, {0, 2, 3}, {1, 5, 2}, {1, 4, 5}, {2, 6, 7}}));
}

TEST_CASE("polygons can be cut along other diagonals, next to each other and in another order") {
  CHECK(sameSurface(meshText, {{0, 1, 3}, {1, 2, 3}, {1, 4, 5}, {1, 5, 2}, {2, 5, 6}, {2, 6, 7}, {2, 7, 8}}));
  CHECK(sameSurface(meshText, {{0, 1, 3}, {1, 4, 2}, {2, 5, 8}, {5, 6, 8}, {6, 7, 8}, {1, 2, 3}, {4, 5, 2}}));
}

TEST_CASE("other surfaces are distinguished") {
  std::vector<Triangle> turned = meshText, other = meshText, twice = meshText;
  turned[1] = {0, 3, 2};
  CHECK(!sameSurface(meshText, turned));
  other[6] = {2, 7, 9};
  CHECK(!sameSurface(meshText, other));
  twice[1] = twice[0];
  CHECK(!sameSurface(meshText, twice));
  CHECK(!sameSurface(meshText, {meshText.begin(), meshText.end() - 1}));
  // A closed surface with other edges over the same vertices. It has no boundary to distinguish it.
  const std::vector<Triangle> tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  CHECK(!sameSurface(tetrahedron, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}));
}

}  // namespace shapespline::test::same_surface_test
