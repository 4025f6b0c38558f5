// Four lanes of either precision behind one name, for kernels that are written once.
#pragma once

#include "core/base/simd.h"

namespace shapespline {

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

/// Float4 or Double4.
template <class Real>
using Lanes = typename LanesOf<Real>::Type;

}  // namespace shapespline
