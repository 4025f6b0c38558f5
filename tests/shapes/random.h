// Random numbers that are the same on every machine, unlike the standard library's distributions.
#pragma once

#include <cstdint>

namespace shapespline {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }

  double uniform(double low, double high) { return low + (high - low) * double(next() >> 11) * 0x1p-53; }

  /// In [-1, 1).
  double signedUnit() { return uniform(-1, 1); }

  /// In [0, count); the bias is below count / 2^64.
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

 private:
  std::uint64_t state_;
};

}  // namespace shapespline
