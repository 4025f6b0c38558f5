#include "core/panels.h"

#include <algorithm>

#include "core/dense_front.h"
#include "core/out_of_line.h"
#include "core/panel_kernels.h"

namespace shapespline {

namespace {

// Panels of a supernode, all of about the same width.
int panelCount(int columns, int width) { return (columns + width - 1) / width; }
int panelStart(int columns, int count, int i) { return static_cast<int>(static_cast<long long>(columns) * i / count); }

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
  size_ = symbolic.size();
  std::size_t values = 0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    firstPanel_.push_back(static_cast<int>(panels_.size()));
    const int columns = symbolic.columns(s), count = panelCount(columns, kWidth);
    for (int i = 0; i < count; ++i) {
      const int begin = panelStart(columns, count, i), end = panelStart(columns, count, i + 1);
      Panel panel = {symbolic.first[s] + begin, end - begin, 0, row_.size(), values};
      for (int c = end; c < columns; ++c) row_.push_back(symbolic.first[s] + c);
      row_.insert(row_.end(), symbolic.rowsOf(s), symbolic.rowsOf(s) + symbolic.rows(s));
      while ((row_.size() - panel.row) % 4 != 0) row_.push_back(size_);
      panel.rows = static_cast<int>(row_.size() - panel.row);
      values += panelEntries(panel.columns, panel.rows);
      panels_.push_back(panel);
    }
  }
  values_.assign(values, Scalar(0));
}

template <class Scalar>
void PanelFactor<Scalar>::store(const SymbolicFactor& symbolic, int s, const double* front) {
  const int columns = symbolic.columns(s), size = columns + symbolic.rows(s), count = panelCount(columns, kWidth);
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
void PanelFactor<Scalar>::solve(Scalar* x) const {
  std::fill_n(x + 4 * static_cast<std::size_t>(size_), 4, Scalar(0));  // what the zero rows read and write
  const PanelKernels<Scalar> kernels = panelKernels<Scalar>();
  for (const Panel& panel : panels_)
    kernels.forward(values_.data() + panel.values, panel.columns, row_.data() + panel.row, panel.rows, x, panel.first);
  for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel)
    kernels.backward(values_.data() + panel->values, panel->columns, row_.data() + panel->row, panel->rows, x, panel->first);
}

template class PanelFactor<float>;
template class PanelFactor<double>;

}  // namespace shapespline
