// Four floats or two doubles in one register: the compilers' vector types, and intrinsics for operations without an
// operator. Each operation rounds once per lane and nothing is fused, so WebAssembly SIMD, SSE2 and all other targets
// give the same bits.
#pragma once

#include <cmath>
#include <cstdint>

#if defined(__wasm_simd128__)
#define SHAPESPLINE_SIMD_WASM 1
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#define SHAPESPLINE_SIMD_SSE 1
#include <emmintrin.h>
#endif

namespace shapespline {

namespace registers {

using Floats = float __attribute__((vector_size(16)));
using Doubles = double __attribute__((vector_size(16)));
// Vectors without alignment requirements. (Copying bytes instead makes WebAssembly's kernels twice as large.)
// The attributes must precede the equals sign, or clang ignores them.
using FloatsAnywhere [[gnu::aligned(4), gnu::may_alias]] = Floats;
using DoublesAnywhere [[gnu::aligned(8), gnu::may_alias]] = Doubles;
static_assert(alignof(FloatsAnywhere) == alignof(float) && alignof(DoublesAnywhere) == alignof(double));

// Operations without an operator on vector types. A mask is a comparison's result: all bits of a lane, or none.
#if SHAPESPLINE_SIMD_WASM
inline Floats squareRoot(Floats v) { return (Floats)wasm_f32x4_sqrt((v128_t)v); }
inline Doubles squareRoot(Doubles v) { return (Doubles)wasm_f64x2_sqrt((v128_t)v); }
template <class Mask>
int bitOfEachFloat(Mask m) {
  return static_cast<int>(wasm_i32x4_bitmask((v128_t)m));
}
template <class Mask>
int bitOfEachDouble(Mask m) {
  return static_cast<int>(wasm_i64x2_bitmask((v128_t)m));
}
inline void storeThree(float* p, Floats v) {
  wasm_v128_store64_lane(p, (v128_t)v, 0);
  wasm_v128_store32_lane(p + 2, (v128_t)v, 2);
}
#elif SHAPESPLINE_SIMD_SSE
inline Floats squareRoot(Floats v) { return _mm_sqrt_ps(v); }
inline Doubles squareRoot(Doubles v) { return _mm_sqrt_pd(v); }
template <class Mask>
int bitOfEachFloat(Mask m) {
  return _mm_movemask_ps((Floats)m);
}
template <class Mask>
int bitOfEachDouble(Mask m) {
  return _mm_movemask_pd((Doubles)m);
}
inline void storeThree(float* p, Floats v) {
  _mm_storel_pi(reinterpret_cast<__m64*>(p), v);
  _mm_store_ss(p + 2, _mm_movehl_ps(v, v));
}
#else
inline Floats squareRoot(Floats v) { return {std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])}; }
inline Doubles squareRoot(Doubles v) { return {std::sqrt(v[0]), std::sqrt(v[1])}; }
template <class Mask>
int bitOfEachFloat(Mask m) {
  return (m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8);
}
template <class Mask>
int bitOfEachDouble(Mask m) {
  return static_cast<int>((m[0] & 1) | (m[1] & 2));
}
inline void storeThree(float* p, Floats v) {
  p[0] = v[0];
  p[1] = v[1];
  p[2] = v[2];
}
#endif

}  // namespace registers

/// Four float lanes.
struct Float4 {
  using Real = float;
  registers::Floats v;
  static Float4 load(const float* p) { return {*reinterpret_cast<const registers::FloatsAnywhere*>(p)}; }
  static Float4 splat(float s) { return {registers::Floats{s, s, s, s}}; }
  static Float4 loadSplat(const float* p) { return splat(*p); }
  static Float4 zero() { return splat(0); }
  void store(float* p) const { *reinterpret_cast<registers::FloatsAnywhere*>(p) = v; }
  /// Stores three lanes.
  void storeXyz(float* p) const { registers::storeThree(p, v); }
  friend Float4 operator+(Float4 a, Float4 b) { return {a.v + b.v}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {a.v - b.v}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {a.v * b.v}; }
  friend Float4 operator/(Float4 a, Float4 b) { return {a.v / b.v}; }
  friend Float4 squareRoot(Float4 a) { return {registers::squareRoot(a.v)}; }
  /// The smaller value per lane. Returns a if the values are equal or one is not a number.
  friend Float4 smaller(Float4 a, Float4 b) { return {b.v < a.v ? b.v : a.v}; }
  friend Float4 larger(Float4 a, Float4 b) { return {a.v < b.v ? b.v : a.v}; }
  friend Float4 magnitude(Float4 a) {
    using Bits = std::int32_t __attribute__((vector_size(16)));
    return {(registers::Floats)((Bits)a.v & 0x7fffffff)};
  }
  /// One bit for each lane that is zero, negative or not a number.
  friend int notPositive(Float4 a) { return 15 ^ registers::bitOfEachFloat(a.v > zero().v); }
  /// (y, z, x, w).
  friend Float4 rotatedXyz(Float4 a) { return {__builtin_shufflevector(a.v, a.v, 1, 2, 0, 3)}; }
  friend Float4 lowHalves(Float4 a, Float4 b) { return {__builtin_shufflevector(a.v, b.v, 0, 1, 4, 5)}; }
  friend Float4 highHalves(Float4 a, Float4 b) { return {__builtin_shufflevector(a.v, b.v, 2, 3, 6, 7)}; }
  friend Float4 interleaveLow(Float4 a, Float4 b) { return {__builtin_shufflevector(a.v, b.v, 0, 4, 1, 5)}; }
  friend Float4 interleaveHigh(Float4 a, Float4 b) { return {__builtin_shufflevector(a.v, b.v, 2, 6, 3, 7)}; }
};

/// Two double lanes.
struct Double2 {
  registers::Doubles v;
  static Double2 load(const double* p) { return {*reinterpret_cast<const registers::DoublesAnywhere*>(p)}; }
  static Double2 splat(double s) { return {registers::Doubles{s, s}}; }
  static Double2 loadSplat(const double* p) { return splat(*p); }
  static Double2 zero() { return splat(0); }
  void store(double* p) const { *reinterpret_cast<registers::DoublesAnywhere*>(p) = v; }
  friend Double2 operator+(Double2 a, Double2 b) { return {a.v + b.v}; }
  friend Double2 operator-(Double2 a, Double2 b) { return {a.v - b.v}; }
  friend Double2 operator*(Double2 a, Double2 b) { return {a.v * b.v}; }
  friend Double2 operator/(Double2 a, Double2 b) { return {a.v / b.v}; }
  friend Double2 squareRoot(Double2 a) { return {registers::squareRoot(a.v)}; }
  friend Double2 smaller(Double2 a, Double2 b) { return {b.v < a.v ? b.v : a.v}; }
  friend Double2 larger(Double2 a, Double2 b) { return {a.v < b.v ? b.v : a.v}; }
  friend int notPositive(Double2 a) { return 3 ^ registers::bitOfEachDouble(a.v > zero().v); }
  friend Double2 lowHalves(Double2 a, Double2 b) { return {__builtin_shufflevector(a.v, b.v, 0, 2)}; }
  friend Double2 highHalves(Double2 a, Double2 b) { return {__builtin_shufflevector(a.v, b.v, 1, 3)}; }
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
  void store(double* p) const {
    low.store(p);
    high.store(p + 2);
  }
  friend Double4 operator+(Double4 a, Double4 b) { return {a.low + b.low, a.high + b.high}; }
  friend Double4 operator-(Double4 a, Double4 b) { return {a.low - b.low, a.high - b.high}; }
  friend Double4 operator*(Double4 a, Double4 b) { return {a.low * b.low, a.high * b.high}; }
  friend Double4 operator/(Double4 a, Double4 b) { return {a.low / b.low, a.high / b.high}; }
  friend Double4 squareRoot(Double4 a) { return {squareRoot(a.low), squareRoot(a.high)}; }
  friend Double4 smaller(Double4 a, Double4 b) { return {smaller(a.low, b.low), smaller(a.high, b.high)}; }
  friend Double4 larger(Double4 a, Double4 b) { return {larger(a.low, b.low), larger(a.high, b.high)}; }
  friend int notPositive(Double4 a) { return notPositive(a.low) | notPositive(a.high) << 2; }
};

template <class Real>
struct LanesOf;
template <>
struct LanesOf<float> {
  using Type = Float4;
};
template <>
struct LanesOf<double> {
  using Type = Double4;
};

/// Float4 or Double4, for kernels written once for both.
template <class Real>
using Lanes = typename LanesOf<Real>::Type;

/// Computes p - n in place. WebAssembly addresses have no negative offsets, and compilers that fold this step into the
/// following loads spend an instruction on each.
template <class T>
inline T* stepBack(T* p, int n) {
  p -= n;
#if SHAPESPLINE_SIMD_WASM
  __asm__("" : "+r"(p));
#endif
  return p;
}

/// Keeps i in a separate register. Loading and scaling four indices as one vector costs more to unpack than it saves.
inline int alone(int i) {
#if SHAPESPLINE_SIMD_WASM
  __asm__("" : "+r"(i));
#endif
  return i;
}

/// Transposes a 4 x 4 block.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  const Float4 ab = interleaveLow(a, b), cd = interleaveLow(c, d), AB = interleaveHigh(a, b), CD = interleaveHigh(c, d);
  a = lowHalves(ab, cd);
  b = highHalves(ab, cd);
  c = lowHalves(AB, CD);
  d = highHalves(AB, CD);
}
inline void transpose(Double4& a, Double4& b, Double4& c, Double4& d) {
  const Double4 p = {lowHalves(a.low, b.low), lowHalves(c.low, d.low)};
  const Double4 q = {highHalves(a.low, b.low), highHalves(c.low, d.low)};
  const Double4 r = {lowHalves(a.high, b.high), lowHalves(c.high, d.high)};
  const Double4 s = {highHalves(a.high, b.high), highHalves(c.high, d.high)};
  a = p;
  b = q;
  c = r;
  d = s;
}

}  // namespace shapespline
