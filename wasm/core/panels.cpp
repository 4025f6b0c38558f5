#include "core/panels.h"

#include <algorithm>
#include <array>

#include "core/dense_front.h"
#include "core/simd.h"

namespace shapespline {

namespace {

template <class Scalar>
struct LanesOf;
template <>
struct LanesOf<float> {
  using type = Float4;
};
template <>
struct LanesOf<double> {
  using type = Double4;
};

constexpr int triangle(int n) { return n * (n + 1) / 2; }

// Calls visit(column, width) for each panel of a supernode.
template <int Width, class Visit>
void forEachPanel(int columns, Visit visit) {
  for (int c = 0; c < columns; c += Width) visit(c, std::min(Width, columns - c));
}

// x := inverse * x for the W unknowns of a panel; the result stays in y, too.
template <class V, int W, class Scalar>
void solveDiagonal(const Scalar* inverse, Scalar* x, V* y) {
  V b[W];
  for (int j = 0; j < W; ++j) b[j] = V::load(x + 4 * j);
  for (int i = 0; i < W; ++i) {
    V sum = V::loadSplat(inverse) * b[0];
    for (int j = 1; j <= i; ++j) sum = sum + V::loadSplat(inverse + j) * b[j];
    inverse += i + 1;
    y[i] = sum;
    sum.store(x + 4 * i);
  }
}

// x := inverseᵀ * (x - sum) for the W unknowns of a panel.
template <class V, int W, class Scalar>
void solveDiagonalTransposed(const Scalar* inverse, Scalar* x, const V* sum) {
  V b[W];
  for (int j = 0; j < W; ++j) b[j] = V::load(x + 4 * j) - sum[j];
  for (int j = 0; j < W; ++j) {
    V result = V::zero();
    for (int i = j; i < W; ++i) result = result + V::loadSplat(inverse + triangle(i) + j) * b[i];
    result.store(x + 4 * j);
  }
}

// The panel's rows times y, taken off t row by row.
template <class V, int W, class Scalar>
void forwardRows(const Scalar* panel, int rows, const V* y, Scalar* t) {
  for (int r = 0; r < rows; ++r, panel += W, t += 4) {
    V sum = V::load(t);
    for (int j = 0; j < W; ++j) sum = sum - V::loadSplat(panel + j) * y[j];
    sum.store(t);
  }
}

// The same with t's rows scattered in x.
template <class V, int W, class Scalar>
void forwardRows(const Scalar* panel, int rows, const V* y, Scalar* x, const int* row) {
  for (int r = 0; r < rows; ++r, panel += W) {
    Scalar* t = x + 4 * static_cast<std::ptrdiff_t>(row[r]);
    V sum = V::load(t);
    for (int j = 0; j < W; ++j) sum = sum - V::loadSplat(panel + j) * y[j];
    sum.store(t);
  }
}

// sum += panelᵀ * t, from the last row to the first: the backward solve reads the factor strictly downwards, which is
// what the processor can prefetch.
template <class V, int W, class Scalar>
void backwardRows(const Scalar* panel, int rows, const Scalar* t, V* sum) {
  panel += static_cast<std::ptrdiff_t>(W) * rows;
  t += 4 * static_cast<std::ptrdiff_t>(rows);
  for (int r = 0; r < rows; ++r) {
    panel -= W;
    t -= 4;
    const V value = V::load(t);
    for (int j = W - 1; j >= 0; --j) sum[j] = sum[j] + V::loadSplat(panel + j) * value;
  }
}

template <class V, int W, class Scalar>
void backwardRows(const Scalar* panel, int rows, const Scalar* x, const int* row, V* sum) {
  panel += static_cast<std::ptrdiff_t>(W) * rows;
  for (int r = rows - 1; r >= 0; --r) {
    panel -= W;
    const V value = V::load(x + 4 * static_cast<std::ptrdiff_t>(row[r]));
    for (int j = W - 1; j >= 0; --j) sum[j] = sum[j] + V::loadSplat(panel + j) * value;
  }
}

// One panel of width W: `inside` rows of the same supernode follow its columns in x, then the supernode's rows: in
// `gathered` if the supernode has several panels, else directly in x.
template <class Scalar>
struct PanelTask {
  const Scalar* values;
  Scalar* x;          // the panel's first unknown
  int inside;
  Scalar* gathered;   // or null
  Scalar* vector;     // all unknowns
  const int* row;
  int rows;
};

template <class Scalar, int W>
void forwardPanel(const PanelTask<Scalar>& task) {
  using V = typename LanesOf<Scalar>::type;
  V y[W];
  solveDiagonal<V, W>(task.values, task.x, y);
  const Scalar* panel = task.values + triangle(W);
  forwardRows<V, W>(panel, task.inside, y, task.x + 4 * W);
  panel += static_cast<std::ptrdiff_t>(W) * task.inside;
  if (task.gathered) forwardRows<V, W>(panel, task.rows, y, task.gathered);
  else forwardRows<V, W>(panel, task.rows, y, task.vector, task.row);
}

template <class Scalar, int W>
void backwardPanel(const PanelTask<Scalar>& task) {
  using V = typename LanesOf<Scalar>::type;
  V sum[W];
  for (int j = 0; j < W; ++j) sum[j] = V::zero();
  const Scalar* inside = task.values + triangle(W);
  const Scalar* below = inside + static_cast<std::ptrdiff_t>(W) * task.inside;
  if (task.gathered) backwardRows<V, W>(below, task.rows, task.gathered, sum);
  else backwardRows<V, W>(below, task.rows, task.vector, task.row, sum);
  backwardRows<V, W>(inside, task.inside, task.x + 4 * W, sum);
  solveDiagonalTransposed<V, W>(task.values, task.x, sum);
}

template <class Scalar>
using PanelKernel = void (*)(const PanelTask<Scalar>&);

// Called through pointers: a kernel inlined into the loop over all supernodes would stay in the baseline compiler of
// the browser, because that loop is one long call.
template <class Scalar>
constexpr std::array<PanelKernel<Scalar>, 9> kForward = {
    nullptr, forwardPanel<Scalar, 1>, forwardPanel<Scalar, 2>, forwardPanel<Scalar, 3>, forwardPanel<Scalar, 4>,
    forwardPanel<Scalar, 5>, forwardPanel<Scalar, 6>, forwardPanel<Scalar, 7>, forwardPanel<Scalar, 8>};
template <class Scalar>
constexpr std::array<PanelKernel<Scalar>, 9> kBackward = {
    nullptr, backwardPanel<Scalar, 1>, backwardPanel<Scalar, 2>, backwardPanel<Scalar, 3>, backwardPanel<Scalar, 4>,
    backwardPanel<Scalar, 5>, backwardPanel<Scalar, 6>, backwardPanel<Scalar, 7>, backwardPanel<Scalar, 8>};

std::size_t panelSize(int width, int rowsBelow) {
  return static_cast<std::size_t>(triangle(width)) + static_cast<std::size_t>(width) * static_cast<std::size_t>(rowsBelow);
}

}  // namespace

template <class Scalar>
void PanelFactor<Scalar>::allocate(const SymbolicFactor& symbolic) {
  symbolic_ = &symbolic;
  start_.assign(1, 0);
  int scratch = 0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const int columns = symbolic.columns(s), rows = symbolic.rows(s);
    std::size_t size = 0;
    forEachPanel<kWidth>(columns, [&](int c, int width) { size += panelSize(width, columns - c - width + rows); });
    start_.push_back(start_.back() + size);
    scratch = std::max(scratch, rows);
  }
  values_.assign(start_.back(), Scalar(0));
  paddedSize_ = symbolic.size() + scratch;
}

template <class Scalar>
void PanelFactor<Scalar>::store(int s, const double* front) {
  const int columns = symbolic_->columns(s), rows = symbolic_->rows(s);
  const int pivots = 4 * stripsFor(columns);
  const auto entry = [&](int r, int c) {
    const int local = r < columns ? r : r - columns + pivots;
    return front[stripOffset(local / 4) + 4 * static_cast<std::size_t>(c) + local % 4];
  };
  Scalar* out = values_.data() + start_[s];
  forEachPanel<kWidth>(columns, [&](int c0, int width) {
    double inverse[kWidth][kWidth];
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j <= i; ++j) {
        double sum = i == j ? 1.0 : 0.0;
        for (int p = j; p < i; ++p) sum -= entry(c0 + i, c0 + p) * inverse[p][j];
        inverse[i][j] = sum / entry(c0 + i, c0 + i);
        *out++ = static_cast<Scalar>(inverse[i][j]);
      }
    }
    for (int r = c0 + width; r < columns + rows; ++r)
      for (int j = 0; j < width; ++j) *out++ = static_cast<Scalar>(entry(r, c0 + j));
  });
}

template <class Scalar>
void PanelFactor<Scalar>::solve(Scalar* x) const {
  forward(x);
  backward(x);
}

template <class Scalar>
void PanelFactor<Scalar>::forward(Scalar* x) const {
  Scalar* scratch = x + 4 * static_cast<std::ptrdiff_t>(symbolic_->size());
  for (int s = 0; s < symbolic_->supernodes(); ++s) {
    const int columns = symbolic_->columns(s), rows = symbolic_->rows(s);
    const int* row = symbolic_->rowsOf(s);
    const Scalar* values = values_.data() + start_[s];
    Scalar* gathered = columns > kWidth ? scratch : nullptr;
    if (gathered) std::fill_n(gathered, 4 * static_cast<std::ptrdiff_t>(rows), Scalar(0));
    forEachPanel<kWidth>(columns, [&](int c, int width) {
      const int inside = columns - c - width;
      kForward<Scalar>[width]({values, x + 4 * static_cast<std::ptrdiff_t>(symbolic_->first[s] + c), inside, gathered, x, row, rows});
      values += panelSize(width, inside + rows);
    });
    if (gathered) {
      using V = typename LanesOf<Scalar>::type;
      for (int r = 0; r < rows; ++r) {
        Scalar* target = x + 4 * static_cast<std::ptrdiff_t>(row[r]);
        (V::load(target) + V::load(gathered + 4 * r)).store(target);
      }
    }
  }
}

template <class Scalar>
void PanelFactor<Scalar>::backward(Scalar* x) const {
  Scalar* scratch = x + 4 * static_cast<std::ptrdiff_t>(symbolic_->size());
  for (int s = symbolic_->supernodes() - 1; s >= 0; --s) {
    const int columns = symbolic_->columns(s), rows = symbolic_->rows(s);
    const int* row = symbolic_->rowsOf(s);
    const Scalar* values = values_.data() + start_[s + 1];
    Scalar* gathered = columns > kWidth ? scratch : nullptr;
    if (gathered) {
      using V = typename LanesOf<Scalar>::type;
      for (int r = 0; r < rows; ++r) V::load(x + 4 * static_cast<std::ptrdiff_t>(row[r])).store(gathered + 4 * r);
    }
    for (int c = (columns - 1) / kWidth * kWidth; c >= 0; c -= kWidth) {
      const int width = std::min(kWidth, columns - c), inside = columns - c - width;
      values -= panelSize(width, inside + rows);
      kBackward<Scalar>[width]({values, x + 4 * static_cast<std::ptrdiff_t>(symbolic_->first[s] + c), inside, gathered, x, row, rows});
    }
  }
}

template class PanelFactor<float>;
template class PanelFactor<double>;

}  // namespace shapespline
