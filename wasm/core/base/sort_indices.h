// Sorts indices by a custom order.
#pragma once

#include <span>

namespace shapespline {

/// Whether index a comes before index b, given the context of the order.
using IndexOrder = bool (*)(const void* context, int a, int b);

void sortIndices(std::span<int> indices, IndexOrder before, const void* context);

/// Works like std::sort, with shared code for all orders: a separate sort for each adds three kilobytes to the wasm
/// module. `before(a, b)` should distinguish all indices, so the result does not depend on the library's algorithm.
template <class Order>
void sortIndices(std::span<int> indices, const Order& before) {
  const IndexOrder call = [](const void* order, int a, int b) { return (*static_cast<const Order*>(order))(a, b); };
  sortIndices(indices, call, &before);
}

}  // namespace shapespline
