#include "core/base/sort_indices.h"

#include <algorithm>

namespace shapespline {

void sortIndices(std::span<int> indices, IndexOrder before, const void* context) {
  std::sort(indices.begin(), indices.end(), [&](int a, int b) { return before(context, a, b); });
}

}  // namespace shapespline
