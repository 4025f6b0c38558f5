#include "bindings/js_imports.h"

#include <emscripten.h>

// clang-format off
EM_JS(void, hostProgress, (const char* stage, double fraction), {
  if (Module['onProgress']) Module['onProgress'](stage, fraction);
});
EM_JS(int, hostTakeFrame, (int frame, float* positions, float* normals), {
  return Module['takeFrame'] && Module['takeFrame'](frame, positions, normals) ? 1 : 0;
});
// clang-format on

namespace shapespline::bindings {

void reportProgress(const char* stage, double fraction) { hostProgress(stage, fraction); }

bool takeFrame(int frame, float* positions, float* normals) { return hostTakeFrame(frame, positions, normals) != 0; }

}  // namespace shapespline::bindings
