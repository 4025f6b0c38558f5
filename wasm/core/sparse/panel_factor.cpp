#include "core/sparse/panel_factor.h"

#include <algorithm>

#include "core/base/no_inline_call.h"
#include "core/sparse/dense_front.h"
#include "core/sparse/panel_kernels.h"
#include "core/sparse/subtree_partition.h"

namespace shapespline {

namespace {

// Columns of a strip of a front, `stride` numbers apart.
template <class Scalar>
void copyStrip(const double* strip, int columns, int stride, Scalar* out) {
  for (const double* end = strip + 4 * columns; strip != end; strip += 4, out += stride)
    for (int k = 0; k < 4; ++k) out[k] = static_cast<Scalar>(strip[k]);
}

}  // namespace

template <class Scalar>
void PanelFactor<Scalar>::allocate(const SymbolicFactor& symbolic) {
  *this = {};
  values_.assign(lay(symbolic), Scalar(0));
}

template <class Scalar>
void PanelFactor<Scalar>::store(const SymbolicFactor& symbolic, int s, const double* columns, const double* inverse) {
  const int width = symbolic.columns(s), count = panelCount(width);
  const Pivots pivots(width);
  const auto copy = outOfLine(copyStrip<Scalar>);
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels_[firstPanel_[s] + i];
    const int begin = pivots.padding + panelStart(width, count, i), end = begin + panel.columns;
    const auto strip = [&](int k) { return columns + pivots.stripAt(k) + 4 * begin; };
    Scalar* out = values_.data() + panel.values;
    for (int k = begin / 4; k < end / 4; ++k) {
      const int before = std::max(0, 4 * k - begin), firstRow = std::max(0, begin - 4 * k);
      copy(strip(k), before, 4, out);
      out += 4 * before;
      for (int r = firstRow; r < 4; ++r)
        for (int c = firstRow; c <= r; ++c) *out++ = static_cast<Scalar>(inverse[16 * k + 4 * r + c]);
    }
    for (int k = end / 4, left = panel.rows / 4; left > 0; k += 2, left -= 2) {
      const int stride = left > 1 ? 8 : 4;
      copy(strip(k), panel.columns, stride, out);
      if (left > 1) copy(strip(k + 1), panel.columns, stride, out + 4);
      out += stride * panel.columns;
    }
  }
}

template <class Scalar>
void PanelFactor<Scalar>::forward(int part, Scalar* x) const {
  const PanelKernel<Scalar> kernel = panelKernels<Scalar>().forward;
  const Panel* const end = panels_.data() + partStart_[part + 1];
  for (const Panel* panel = panels_.data() + partStart_[part]; panel != end; ++panel)
    kernel(values_.data() + panel->values, panel->columns, row_.data() + panel->row, panel->rows, x, panel->first);
}

template <class Scalar>
void PanelFactor<Scalar>::backward(int part, Scalar* x) const {
  const PanelKernel<Scalar> kernel = panelKernels<Scalar>().backward;
  const Panel* const begin = panels_.data() + partStart_[part];
  for (const Panel* panel = panels_.data() + partStart_[part + 1]; panel != begin;) {
    --panel;
    kernel(values_.data() + panel->values, panel->columns, row_.data() + panel->row, panel->rows, x, panel->first);
  }
}

template <class Scalar>
void PanelFactor<Scalar>::solve(Scalar* x, ForkJoin* forkJoin) const {
  const auto at = [x](int i) { return x + 4 * static_cast<std::ptrdiff_t>(i); };
  std::fill(at(size_), at(paddedSize()),
            Scalar(0));  // scratch for padding rows, and for what the second part adds to the top
  inTwo(forkJoin, [&](int part) { forward(part, x); });
  const Scalar* copy = at(size_ + 2);
  for (int p : top_)
    for (int i = 0; i < 4; ++i) at(p)[i] += *copy++;
  forward(topPart, x);
  backward(topPart, x);
  Scalar* out = at(size_ + 2);
  for (int p : top_) out = std::copy_n(at(p), 4, out);
  inTwo(forkJoin, [&](int part) { backward(part, x); });
}

template class PanelFactor<float>;
template class PanelFactor<double>;

}  // namespace shapespline
