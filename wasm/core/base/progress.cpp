#include "core/base/progress.h"

#include <algorithm>

#include "core/base/no_inline_call.h"

namespace shapespline {

void inBlocks(const FractionReport& report, std::size_t n, BlockWork call, void* work) {
  constexpr std::size_t size = 16384;
  call = outOfLine(call);
  for (std::size_t begin = 0; begin < n; begin += size) {
    reportItem(report, begin, n);
    call(work, begin, std::min(n, begin + size));
  }
}

}  // namespace shapespline
