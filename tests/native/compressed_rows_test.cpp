#include "core/base/compressed_rows.h"

#include <utility>
#include <vector>

#include <doctest/doctest.h>

namespace shapespline::test::compressed_rows_test {

namespace {

template <class Item>
std::vector<Item> listed(std::span<Item> row) {
  return {row.begin(), row.end()};
}

}  // namespace

TEST_CASE("items are stored by row, and within a row in input order") {
  const std::vector<std::pair<int, char>> items = {{2, 'a'}, {0, 'b'}, {2, 'c'}, {4, 'd'}, {0, 'e'}, {2, 'f'}};
  auto rows = compressedRows<char>(6, [&](auto add) {
    for (const auto& [row, item] : items) add(row, item);
  });
  CHECK(rows.count() == 6);
  CHECK(rows.start == std::vector<int>{0, 2, 2, 5, 5, 6, 6});
  CHECK(listed(rows.of(0)) == std::vector<char>{'b', 'e'});
  CHECK(listed(rows.of(2)) == std::vector<char>{'a', 'c', 'f'});
  CHECK(listed(rows.of(4)) == std::vector<char>{'d'});
  for (int row : {1, 3, 5}) CHECK(rows.of(row).empty());
}

TEST_CASE("rows made in blocks are equal, and report progress") {
  constexpr std::size_t count = 100'000;
  const auto rowOf = [](std::size_t i) { return static_cast<int>(i * i % 977); };
  double reached = 0;
  int reports = 0;
  const auto listen = [&](double fraction) {
    CHECK((fraction >= reached && fraction <= 1));
    reached = fraction;
    ++reports;
  };
  const auto piecewise = compressedRows<std::size_t>(
      977, count, [&](std::size_t i, auto add) { add(rowOf(i), i), add(rowOf(i + 1), i); }, listen);
  const auto atOnce = compressedRows<std::size_t>(977, [&](auto add) {
    for (std::size_t i = 0; i < count; ++i) add(rowOf(i), i), add(rowOf(i + 1), i);
  });
  CHECK(piecewise.item.size() == 2 * count);
  CHECK(piecewise.start == atOnce.start);
  CHECK(piecewise.item == atOnce.item);
  CHECK(reports > 2);
}

TEST_CASE("no rows have no items") {
  const auto rows = compressedRows<int>(0, [](auto) {});
  CHECK(rows.count() == 0);
  CHECK(rows.item.empty());
}

}  // namespace shapespline::test::compressed_rows_test
