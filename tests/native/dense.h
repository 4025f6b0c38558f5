// Cases that take long and rarely find anything: TEST_CASE("..." * dense) runs in `npm test -- all` alone.
#pragma once

#include <doctest/doctest.h>

namespace shapespline::test {

inline const doctest::test_suite dense("dense");

}  // namespace shapespline::test
