// Marks slow cases that rarely find defects: TEST_CASE("..." * dense) runs in `npm test -- all` only, as wasm;
// `npm test -- native` runs it with sanitizers.
#pragma once

#include <doctest/doctest.h>

namespace shapespline::test {

inline const doctest::test_suite dense("dense");

}  // namespace shapespline::test
