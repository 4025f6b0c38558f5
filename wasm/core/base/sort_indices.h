// Sorting of indices by what they stand for.
#pragma once

#include <span>

namespace shapespline {

/// Whether index a comes before index b, given what the order looks at.
using IndexOrder = bool (*)(const void* context, int a, int b);

void sortIndices(std::span<int> indices, IndexOrder before, const void* context);

/// As std::sort, in code that exists once for all orders: a sort of its own for each is three kilobytes of the wasm
/// module. `before(a, b)` should tell all indices apart, so the result does not depend on the library's algorithm.
template <class Order>
void sortIndices(std::span<int> indices, const Order& before) {
  const IndexOrder call = [](const void* order, int a, int b) { return (*static_cast<const Order*>(order))(a, b); };
  sortIndices(indices, call, &before);
}

}  // namespace shapespline
