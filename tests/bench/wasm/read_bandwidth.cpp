// One streaming read over a buffer far larger than any cache, as WebAssembly: the reference for the solve.
#include <wasm_simd128.h>

namespace {
constexpr int numbers = 64 << 20;  // floats: 256 MB
alignas(64) float buffer[numbers];
}  // namespace

extern "C" {

/// Bytes that readAll() reads.
__attribute__((export_name("size"))) unsigned size() { return sizeof buffer; }

/// Touches every page once, so each gets its own memory.
__attribute__((export_name("fill"))) void fill() {
  for (int i = 0; i < numbers; ++i) buffer[i] = 1.0f;
}

/// The sum of all numbers in the buffer.
__attribute__((export_name("readAll"))) float readAll() {
  v128_t a = wasm_f32x4_const_splat(0.0f), b = a, c = a, d = a;
  for (const float *p = buffer, *end = buffer + numbers; p != end; p += 16) {
    a = wasm_f32x4_add(a, wasm_v128_load(p));
    b = wasm_f32x4_add(b, wasm_v128_load(p + 4));
    c = wasm_f32x4_add(c, wasm_v128_load(p + 8));
    d = wasm_f32x4_add(d, wasm_v128_load(p + 12));
  }
  const v128_t sum = wasm_f32x4_add(wasm_f32x4_add(a, b), wasm_f32x4_add(c, d));
  return wasm_f32x4_extract_lane(sum, 0) + wasm_f32x4_extract_lane(sum, 1) + wasm_f32x4_extract_lane(sum, 2) +
         wasm_f32x4_extract_lane(sum, 3);
}
}
