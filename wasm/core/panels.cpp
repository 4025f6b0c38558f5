#include "core/panels.h"

#include <algorithm>

#include "core/dense_front.h"
#include "core/out_of_line.h"
#include "core/panel_kernels.h"
#include "core/tree_cut.h"

namespace shapespline {

namespace {

// An eliminated front, its rows numbered without the padding between pivots and rows below.
struct FrontRows {
  const double* front;
  int pivots, padding;
  /// Entry (r, c) is at row(r)[4 * c].
  const double* row(int r) const {
    const int local = r < pivots ? r : r + padding;
    return front + stripOffset(static_cast<std::size_t>(local) / 4) + local % 4;
  }
};

// The panel's triangle, columns begin ... end - 1; returns the end of what was written.
template <class Scalar>
Scalar* copyTriangle(const FrontRows& rows, int begin, int end, Scalar* out) {
  for (int r = begin, height = firstBlock(end - begin); r < end; r += height, height = 4) {
    const double* row[4];
    for (int k = 0; k < height; ++k) row[k] = rows.row(r + k);
    for (int c = begin; c < r; ++c)
      for (int k = 0; k < 4; ++k) *out++ = static_cast<Scalar>(row[k][4 * c]);
    double inverse[4][4];
    for (int a = 0; a < height; ++a) {
      for (int b = 0; b <= a; ++b) {
        double sum = a == b ? 1.0 : 0.0;
        for (int p = b; p < a; ++p) sum -= row[a][4 * (r + p)] * inverse[p][b];
        inverse[a][b] = sum / row[a][4 * (r + a)];
        *out++ = static_cast<Scalar>(inverse[a][b]);
      }
    }
  }
  return out;
}

// The rows r ... last - 1 of the columns begin ... end - 1, filled up to `group` rows with zeros.
template <class Scalar>
Scalar* copyRows(const FrontRows& rows, int r, int last, int group, int begin, int end, Scalar* out) {
  for (int k = 0; k < group; ++k) {
    if (r + k < last) {
      const double* row = rows.row(r + k);
      for (int c = begin; c < end; ++c) out[group * (c - begin) + k] = static_cast<Scalar>(row[4 * c]);
    } else {
      for (int c = begin; c < end; ++c) out[group * (c - begin) + k] = Scalar(0);
    }
  }
  return out + group * (end - begin);
}

}  // namespace

template <class Scalar>
void PanelFactor<Scalar>::allocate(const SymbolicFactor& symbolic) {
  *this = {};
  values_.assign(lay(symbolic), Scalar(0));
}

template <class Scalar>
void PanelFactor<Scalar>::store(const SymbolicFactor& symbolic, int s, const double* front) {
  const int columns = symbolic.columns(s), size = columns + symbolic.rows(s), count = panelCount(columns);
  const FrontRows rows = {front, columns, 4 * stripsFor(columns) - columns};
  const auto storeTriangle = outOfLine(copyTriangle<Scalar>);
  const auto storeRows = outOfLine(copyRows<Scalar>);
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels_[firstPanel_[s] + i];
    const int begin = panelStart(columns, count, i), end = begin + panel.columns;
    Scalar* out = storeTriangle(rows, begin, end, values_.data() + panel.values);
    for (int r = end, left = panel.rows, group = 0; left > 0; r += group, left -= group) {
      group = std::min(left, 8);
      out = storeRows(rows, r, std::min(size, r + group), group, begin, end, out);
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
void PanelFactor<Scalar>::solve(Scalar* x, Crew* crew) const {
  const auto at = [x](int i) { return x + 4 * static_cast<std::ptrdiff_t>(i); };
  std::fill(at(size_), at(paddedSize()), Scalar(0));  // what the zero rows read and write, and what the second part adds to the top
  inTwo(crew, [&](int part) { forward(part, x); });
  const Scalar* copy = at(size_ + 2);
  for (int p : top_)
    for (int i = 0; i < 4; ++i) at(p)[i] += *copy++;
  forward(topPart, x);
  backward(topPart, x);
  Scalar* out = at(size_ + 2);
  for (int p : top_) out = std::copy_n(at(p), 4, out);
  inTwo(crew, [&](int part) { backward(part, x); });
}

template class PanelFactor<float>;
template class PanelFactor<double>;

}  // namespace shapespline
