// Four floats or two doubles in one register: WebAssembly SIMD, SSE2, or plain C++ (SHAPESPLINE_SCALAR).
// Each operation rounds once per lane, nothing is fused: all three give the same bits. notPositive: a bit for each lane
// that is zero, negative or not a number; smaller, larger, largerMagnitude: per lane; turnedXyz: (y, z, x, w);
// storeXyz: three lanes.
#pragma once

#if defined(SHAPESPLINE_SCALAR)
#define SHAPESPLINE_SIMD_SCALAR 1
#elif defined(__wasm_simd128__)
#define SHAPESPLINE_SIMD_WASM 1
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#define SHAPESPLINE_SIMD_SSE 1
#include <emmintrin.h>
#else
#define SHAPESPLINE_SIMD_SCALAR 1
#endif
#if SHAPESPLINE_SIMD_SCALAR
#include <cmath>
#endif

namespace shapespline {

/// Four float lanes.
struct Float4 {
  using Real = float;
#if SHAPESPLINE_SIMD_WASM
  v128_t v;
  static Float4 load(const float* p) { return {wasm_v128_load(p)}; }
  static Float4 splat(float s) { return {wasm_f32x4_splat(s)}; }
  static Float4 loadSplat(const float* p) { return {wasm_v128_load32_splat(p)}; }
  static Float4 zero() { return {wasm_f32x4_const_splat(0.0f)}; }
  void store(float* p) const { wasm_v128_store(p, v); }
  void storeXyz(float* p) const { wasm_v128_store64_lane(p, v, 0), wasm_v128_store32_lane(p + 2, v, 2); }
  friend Float4 operator+(Float4 a, Float4 b) { return {wasm_f32x4_add(a.v, b.v)}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {wasm_f32x4_sub(a.v, b.v)}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {wasm_f32x4_mul(a.v, b.v)}; }
  friend Float4 operator/(Float4 a, Float4 b) { return {wasm_f32x4_div(a.v, b.v)}; }
  friend Float4 squareRoot(Float4 a) { return {wasm_f32x4_sqrt(a.v)}; }
  friend Float4 smaller(Float4 a, Float4 b) { return {wasm_f32x4_pmin(a.v, b.v)}; }
  friend Float4 larger(Float4 a, Float4 b) { return {wasm_f32x4_pmax(a.v, b.v)}; }
  friend Float4 largerMagnitude(Float4 a, Float4 b) {
    return {wasm_f32x4_pmax(wasm_f32x4_abs(a.v), wasm_f32x4_abs(b.v))};
  }
  friend Float4 turnedXyz(Float4 a) { return {wasm_i32x4_shuffle(a.v, a.v, 1, 2, 0, 3)}; }
  friend int notPositive(Float4 a) { return 15 ^ static_cast<int>(wasm_i32x4_bitmask(wasm_f32x4_gt(a.v, zero().v))); }
  friend Float4 lowHalves(Float4 a, Float4 b) { return {wasm_i64x2_shuffle(a.v, b.v, 0, 2)}; }
  friend Float4 highHalves(Float4 a, Float4 b) { return {wasm_i64x2_shuffle(a.v, b.v, 1, 3)}; }
  friend Float4 interleaveLow(Float4 a, Float4 b) { return {wasm_i32x4_shuffle(a.v, b.v, 0, 4, 1, 5)}; }
  friend Float4 interleaveHigh(Float4 a, Float4 b) { return {wasm_i32x4_shuffle(a.v, b.v, 2, 6, 3, 7)}; }
#elif SHAPESPLINE_SIMD_SSE
  __m128 v;
  static Float4 load(const float* p) { return {_mm_loadu_ps(p)}; }
  static Float4 splat(float s) { return {_mm_set1_ps(s)}; }
  static Float4 loadSplat(const float* p) { return {_mm_set1_ps(*p)}; }
  static Float4 zero() { return {_mm_setzero_ps()}; }
  void store(float* p) const { _mm_storeu_ps(p, v); }
  void storeXyz(float* p) const {
    _mm_storel_pi(reinterpret_cast<__m64*>(p), v);
    _mm_store_ss(p + 2, _mm_movehl_ps(v, v));
  }
  friend Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
  friend Float4 operator/(Float4 a, Float4 b) { return {_mm_div_ps(a.v, b.v)}; }
  friend Float4 squareRoot(Float4 a) { return {_mm_sqrt_ps(a.v)}; }
  friend Float4 smaller(Float4 a, Float4 b) { return {_mm_min_ps(b.v, a.v)}; }
  friend Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(b.v, a.v)}; }
  friend Float4 largerMagnitude(Float4 a, Float4 b) {
    const __m128 sign = _mm_set1_ps(-0.0f);
    return {_mm_max_ps(_mm_andnot_ps(sign, b.v), _mm_andnot_ps(sign, a.v))};
  }
  friend Float4 turnedXyz(Float4 a) { return {_mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE(3, 0, 2, 1))}; }
  friend int notPositive(Float4 a) { return 15 ^ _mm_movemask_ps(_mm_cmpgt_ps(a.v, zero().v)); }
  friend Float4 lowHalves(Float4 a, Float4 b) { return {_mm_movelh_ps(a.v, b.v)}; }
  friend Float4 highHalves(Float4 a, Float4 b) { return {_mm_movehl_ps(b.v, a.v)}; }
  friend Float4 interleaveLow(Float4 a, Float4 b) { return {_mm_unpacklo_ps(a.v, b.v)}; }
  friend Float4 interleaveHigh(Float4 a, Float4 b) { return {_mm_unpackhi_ps(a.v, b.v)}; }
#else
  float v[4];
  static Float4 load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
  static Float4 splat(float s) { return {{s, s, s, s}}; }
  static Float4 loadSplat(const float* p) { return splat(*p); }
  static Float4 zero() { return splat(0.0f); }
  void store(float* p) const {
    for (int i = 0; i < 4; ++i) p[i] = v[i];
  }
  void storeXyz(float* p) const { p[0] = v[0], p[1] = v[1], p[2] = v[2]; }
  friend Float4 operator+(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] += b.v[i];
    return a;
  }
  friend Float4 operator-(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] -= b.v[i];
    return a;
  }
  friend Float4 operator*(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] *= b.v[i];
    return a;
  }
  friend Float4 operator/(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] /= b.v[i];
    return a;
  }
  friend Float4 squareRoot(Float4 a) {
    for (int i = 0; i < 4; ++i) a.v[i] = std::sqrt(a.v[i]);
    return a;
  }
  friend Float4 smaller(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = b.v[i] < a.v[i] ? b.v[i] : a.v[i];
    return a;
  }
  friend Float4 larger(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = a.v[i] < b.v[i] ? b.v[i] : a.v[i];
    return a;
  }
  friend Float4 largerMagnitude(Float4 a, Float4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = std::fabs(a.v[i]) < std::fabs(b.v[i]) ? std::fabs(b.v[i]) : std::fabs(a.v[i]);
    return a;
  }
  friend Float4 turnedXyz(Float4 a) { return {{a.v[1], a.v[2], a.v[0], a.v[3]}}; }
  friend int notPositive(Float4 a) {
    int mask = 0;
    for (int i = 0; i < 4; ++i) mask |= (a.v[i] > 0 ? 0 : 1) << i;
    return mask;
  }
  friend Float4 lowHalves(Float4 a, Float4 b) { return {{a.v[0], a.v[1], b.v[0], b.v[1]}}; }
  friend Float4 highHalves(Float4 a, Float4 b) { return {{a.v[2], a.v[3], b.v[2], b.v[3]}}; }
  friend Float4 interleaveLow(Float4 a, Float4 b) { return {{a.v[0], b.v[0], a.v[1], b.v[1]}}; }
  friend Float4 interleaveHigh(Float4 a, Float4 b) { return {{a.v[2], b.v[2], a.v[3], b.v[3]}}; }
#endif
};

/// Two double lanes.
struct Double2 {
#if SHAPESPLINE_SIMD_WASM
  v128_t v;
  static Double2 load(const double* p) { return {wasm_v128_load(p)}; }
  static Double2 splat(double s) { return {wasm_f64x2_splat(s)}; }
  static Double2 loadSplat(const double* p) { return {wasm_v128_load64_splat(p)}; }
  static Double2 zero() { return {wasm_f64x2_const_splat(0.0)}; }
  void store(double* p) const { wasm_v128_store(p, v); }
  friend Double2 operator+(Double2 a, Double2 b) { return {wasm_f64x2_add(a.v, b.v)}; }
  friend Double2 operator-(Double2 a, Double2 b) { return {wasm_f64x2_sub(a.v, b.v)}; }
  friend Double2 operator*(Double2 a, Double2 b) { return {wasm_f64x2_mul(a.v, b.v)}; }
  friend Double2 operator/(Double2 a, Double2 b) { return {wasm_f64x2_div(a.v, b.v)}; }
  friend Double2 squareRoot(Double2 a) { return {wasm_f64x2_sqrt(a.v)}; }
  friend Double2 smaller(Double2 a, Double2 b) { return {wasm_f64x2_pmin(a.v, b.v)}; }
  friend Double2 larger(Double2 a, Double2 b) { return {wasm_f64x2_pmax(a.v, b.v)}; }
  friend int notPositive(Double2 a) { return 3 ^ static_cast<int>(wasm_i64x2_bitmask(wasm_f64x2_gt(a.v, zero().v))); }
  friend Double2 lowHalves(Double2 a, Double2 b) { return {wasm_i64x2_shuffle(a.v, b.v, 0, 2)}; }
  friend Double2 highHalves(Double2 a, Double2 b) { return {wasm_i64x2_shuffle(a.v, b.v, 1, 3)}; }
#elif SHAPESPLINE_SIMD_SSE
  __m128d v;
  static Double2 load(const double* p) { return {_mm_loadu_pd(p)}; }
  static Double2 splat(double s) { return {_mm_set1_pd(s)}; }
  static Double2 loadSplat(const double* p) { return {_mm_set1_pd(*p)}; }
  static Double2 zero() { return {_mm_setzero_pd()}; }
  void store(double* p) const { _mm_storeu_pd(p, v); }
  friend Double2 operator+(Double2 a, Double2 b) { return {_mm_add_pd(a.v, b.v)}; }
  friend Double2 operator-(Double2 a, Double2 b) { return {_mm_sub_pd(a.v, b.v)}; }
  friend Double2 operator*(Double2 a, Double2 b) { return {_mm_mul_pd(a.v, b.v)}; }
  friend Double2 operator/(Double2 a, Double2 b) { return {_mm_div_pd(a.v, b.v)}; }
  friend Double2 squareRoot(Double2 a) { return {_mm_sqrt_pd(a.v)}; }
  friend Double2 smaller(Double2 a, Double2 b) { return {_mm_min_pd(b.v, a.v)}; }
  friend Double2 larger(Double2 a, Double2 b) { return {_mm_max_pd(b.v, a.v)}; }
  friend int notPositive(Double2 a) { return 3 ^ _mm_movemask_pd(_mm_cmpgt_pd(a.v, zero().v)); }
  friend Double2 lowHalves(Double2 a, Double2 b) { return {_mm_unpacklo_pd(a.v, b.v)}; }
  friend Double2 highHalves(Double2 a, Double2 b) { return {_mm_unpackhi_pd(a.v, b.v)}; }
#else
  double v[2];
  static Double2 load(const double* p) { return {{p[0], p[1]}}; }
  static Double2 splat(double s) { return {{s, s}}; }
  static Double2 loadSplat(const double* p) { return splat(*p); }
  static Double2 zero() { return splat(0.0); }
  void store(double* p) const { p[0] = v[0], p[1] = v[1]; }
  friend Double2 operator+(Double2 a, Double2 b) { return {{a.v[0] + b.v[0], a.v[1] + b.v[1]}}; }
  friend Double2 operator-(Double2 a, Double2 b) { return {{a.v[0] - b.v[0], a.v[1] - b.v[1]}}; }
  friend Double2 operator*(Double2 a, Double2 b) { return {{a.v[0] * b.v[0], a.v[1] * b.v[1]}}; }
  friend Double2 operator/(Double2 a, Double2 b) { return {{a.v[0] / b.v[0], a.v[1] / b.v[1]}}; }
  friend Double2 squareRoot(Double2 a) { return {{std::sqrt(a.v[0]), std::sqrt(a.v[1])}}; }
  friend Double2 smaller(Double2 a, Double2 b) {
    return {{b.v[0] < a.v[0] ? b.v[0] : a.v[0], b.v[1] < a.v[1] ? b.v[1] : a.v[1]}};
  }
  friend Double2 larger(Double2 a, Double2 b) {
    return {{a.v[0] < b.v[0] ? b.v[0] : a.v[0], a.v[1] < b.v[1] ? b.v[1] : a.v[1]}};
  }
  friend int notPositive(Double2 a) { return (a.v[0] > 0 ? 0 : 1) | (a.v[1] > 0 ? 0 : 2); }
  friend Double2 lowHalves(Double2 a, Double2 b) { return {{a.v[0], b.v[0]}}; }
  friend Double2 highHalves(Double2 a, Double2 b) { return {{a.v[1], b.v[1]}}; }
#endif
};

/// Four double lanes in two registers: the (x, y, z, pad) of the double solve.
struct Double4 {
  using Real = double;
  Double2 low, high;
  static Double4 load(const double* p) { return {Double2::load(p), Double2::load(p + 2)}; }
  static Double4 loadSplat(const double* p) {
    const Double2 s = Double2::loadSplat(p);
    return {s, s};
  }
  static Double4 splat(double s) { return {Double2::splat(s), Double2::splat(s)}; }
  static Double4 zero() { return {Double2::zero(), Double2::zero()}; }
  void store(double* p) const { low.store(p), high.store(p + 2); }
  friend Double4 operator+(Double4 a, Double4 b) { return {a.low + b.low, a.high + b.high}; }
  friend Double4 operator-(Double4 a, Double4 b) { return {a.low - b.low, a.high - b.high}; }
  friend Double4 operator*(Double4 a, Double4 b) { return {a.low * b.low, a.high * b.high}; }
  friend Double4 operator/(Double4 a, Double4 b) { return {a.low / b.low, a.high / b.high}; }
  friend Double4 squareRoot(Double4 a) { return {squareRoot(a.low), squareRoot(a.high)}; }
  friend Double4 smaller(Double4 a, Double4 b) { return {smaller(a.low, b.low), smaller(a.high, b.high)}; }
  friend Double4 larger(Double4 a, Double4 b) { return {larger(a.low, b.low), larger(a.high, b.high)}; }
  friend int notPositive(Double4 a) { return notPositive(a.low) | notPositive(a.high) << 2; }
};

/// p - n, computed where it stands. WebAssembly addresses have no negative offsets, and compilers that fold this step
/// into the loads that follow spend an instruction on each.
template <class T>
inline T* stepBack(T* p, int n) {
  p -= n;
#if SHAPESPLINE_SIMD_WASM
  __asm__("" : "+r"(p));
#endif
  return p;
}

/// i, in a register of its own: four indices loaded and scaled as one vector cost more to take apart than that saves.
inline int alone(int i) {
#if SHAPESPLINE_SIMD_WASM
  __asm__("" : "+r"(i));
#endif
  return i;
}

/// Rows become columns.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  const Float4 ab = interleaveLow(a, b), cd = interleaveLow(c, d), AB = interleaveHigh(a, b), CD = interleaveHigh(c, d);
  a = lowHalves(ab, cd), b = highHalves(ab, cd), c = lowHalves(AB, CD), d = highHalves(AB, CD);
}
inline void transpose(Double4& a, Double4& b, Double4& c, Double4& d) {
  const Double4 p = {lowHalves(a.low, b.low), lowHalves(c.low, d.low)};
  const Double4 q = {highHalves(a.low, b.low), highHalves(c.low, d.low)};
  const Double4 r = {lowHalves(a.high, b.high), lowHalves(c.high, d.high)};
  const Double4 s = {highHalves(a.high, b.high), highHalves(c.high, d.high)};
  a = p, b = q, c = r, d = s;
}

}  // namespace shapespline
