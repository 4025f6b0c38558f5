#include "bindings/js_imports.h"

#include <emscripten.h>

// clang-format off
EM_JS(void, jsReportProgress, (const char* stage, double fraction), {
  if (Module['onProgress']) Module['onProgress'](stage, fraction);
});
EM_JS(int, jsTakeFrame, (int frame, float* positions, float* normals), {
  return Module['takeFrame'] && Module['takeFrame'](frame, positions, normals) ? 1 : 0;
});
EM_JS(int, jsTakeOrder, (int* order, int unknowns), {
  return Module['takeOrder'] && Module['takeOrder'](order, unknowns) ? 1 : 0;
});
// clang-format on

namespace shapespline::bindings {

void reportProgress(const char* stage, double fraction) { jsReportProgress(stage, fraction); }

bool takeFrame(int frame, float* positions, float* normals) { return jsTakeFrame(frame, positions, normals) != 0; }

std::vector<int> takeOrder(int unknowns) {
  std::vector<int> order(unknowns);
  if (!jsTakeOrder(order.data(), unknowns)) order.clear();
  return order;
}

}  // namespace shapespline::bindings
