#include "core/sparse/multifrontal.h"

#include <algorithm>
#include <utility>

#include "core/base/no_inline_call.h"
#include "core/base/simd.h"
#include "core/sparse/dense_front.h"

namespace shapespline {

namespace {

// Strips eliminated between two checks of the budget.
constexpr int stripsAtOnce = 32;

Pivots pivotsOf(const SymbolicFactor& symbolic, int s) { return Pivots(symbolic.columns(s)); }
int updateStrips(const SymbolicFactor& symbolic, int s) { return stripsFor(symbolic.rows(s)); }
std::size_t updateSize(const SymbolicFactor& symbolic, int s) { return stripOffset(updateStrips(symbolic, s)); }
std::size_t columnsSize(const SymbolicFactor& symbolic, int s) {
  const Pivots pivots = pivotsOf(symbolic, s);
  return pivots.stripAt(pivots.strips + updateStrips(symbolic, s));
}

// Peak size of both stacks and the columns of a front together, in doubles.
std::size_t stackPeak(const SymbolicFactor& symbolic) {
  std::vector<std::size_t> childUpdates(symbolic.supernodes(), 0);
  std::size_t held = 0, peak = 0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const std::size_t update = updateSize(symbolic, s);
    held += update;
    peak = std::max(peak, held + columnsSize(symbolic, s));
    held -= childUpdates[s];
    if (symbolic.parent[s] != -1) childUpdates[symbolic.parent[s]] += update;
  }
  return peak;
}

// A memset for whole strips: WebAssembly's C library clears one word at a time or calls JavaScript. stepBack() prevents
// compilers from replacing this loop with memset.
void clear(double* begin, std::size_t n) {
  for (double* p = begin + n; p != begin;) {
    p = stepBack(p, 4);
    Double4::zero().store(p);
  }
}

// Moves values to their slots, and the values of one supernode to their positions. Reading them at random costs five
// times as much.
void sortValues(std::span<const double> values, const int* slot, double* sorted) {
  for (std::size_t i = 0; i < values.size(); ++i) sorted[slot[i]] = values[i];
}
void scatterValues(const double* value, const std::size_t* target, int count, double* columns) {
  for (int i = 0; i < count; ++i) columns[target[i]] = value[i];
}

// Adds columns begin ... end - 1 of strip i of an update matrix to a part of its parent's front: entry (4 i + r, c) to
// part[target[r] + 4 * to[c]]. Padding rows of the strip are zero and may be added anywhere.
void addStrip(const double* strip, int i, int begin, int end, double* part, const std::ptrdiff_t* target,
              const int* to) {
  double *a = part + target[0], *b = part + target[1], *c = part + target[2], *d = part + target[3];
  strip += 4 * begin;
  int k = begin;
  const int square = std::min(4 * i, end);
  if (b == a + 1 && d == c + 1) {  // two pairs of adjacent rows
    for (; k < square; ++k, strip += 4) {
      const int column = 4 * to[k];
      (Double2::load(a + column) + Double2::load(strip)).store(a + column);
      (Double2::load(c + column) + Double2::load(strip + 2)).store(c + column);
    }
  } else {
    for (; k < square; ++k, strip += 4) {
      const int column = 4 * to[k];
      a[column] += strip[0];
      b[column] += strip[1];
      c[column] += strip[2];
      d[column] += strip[3];
    }
  }
  for (; k < end; ++k, strip += 4)
    for (int r = k - 4 * i; r < 4; ++r) part[target[r] + 4 * to[k]] += strip[r];
}

// Adds the columns of an update matrix that belong to one part of its parent's front: the parent's pivots, or the rest.
void addUpdate(const double* update, const int* to, int rows, Pivots pivots, bool isUpdate, double* part) {
  const int pivotRows = 4 * pivots.strips;
  const int split = static_cast<int>(std::lower_bound(to, to + rows, pivotRows) - to);
  for (int i = isUpdate ? split / 4 : 0; 4 * i < rows; ++i) {
    const int end = std::min(rows, 4 * i + 4);
    std::ptrdiff_t target[4];
    for (int r = 0; r < 4; ++r) {
      const int row = to[std::min(4 * i + r, rows - 1)], strip = row / 4;
      const std::size_t at = isUpdate ? stripOffset(std::max(0, strip - pivots.strips)) : pivots.stripAt(strip);
      target[r] = static_cast<std::ptrdiff_t>(at) + row % 4 - (isUpdate ? 4 * pivotRows : 0);
    }
    addStrip(update + stripOffset(i), i, isUpdate ? split : 0, isUpdate ? end : std::min(split, end), part, target, to);
  }
}

}  // namespace

Multifrontal::Multifrontal(const SymbolicFactor& symbolic, const Assembly& assembly, std::span<const double> values)
    : symbolic_(symbolic),
      assembly_(assembly),
      values_(std::make_unique_for_overwrite<double[]>(values.size())),
      stackSize_(stackPeak(symbolic)),
      stack_(std::make_unique_for_overwrite<double[]>(stackSize_)),
      high_(stackSize_) {
  outOfLine(sortValues)(values, assembly.slot.data(), values_.get());
  const int count = symbolic.supernodes();
  firstChild_.assign(count, -1);
  sibling_.assign(count, -1);
  isHigh_.assign(count, false);
  updateBase_.assign(count, 0);
  for (int s = 0; s < count; ++s) {
    if (symbolic.parent[s] == -1) continue;
    sibling_[s] = firstChild_[symbolic.parent[s]];
    firstChild_[symbolic.parent[s]] = s;
  }
  for (int s = count - 1; s >= 0; --s)
    if (symbolic.parent[s] != -1) isHigh_[s] = !isHigh_[symbolic.parent[s]];
}

void Multifrontal::assembleFront() {
  const int s = supernode_, first = assembly_.start[s];
  if (isHigh_[s]) updateBase_[s] = high_ -= updateSize(symbolic_, s);
  else updateBase_[s] = std::exchange(low_, low_ + updateSize(symbolic_, s));

  const Pivots pivots = pivotsOf(symbolic_, s);
  const int pivotRows = 4 * pivots.strips;
  double* columns = stack_.get() + low_;
  const auto diagonal = [&](int c) -> double& {
    return columns[stripOffset(c / 4) + 4 * static_cast<std::size_t>(c) + c % 4];
  };
  outOfLine(clear)(columns, columnsSize(symbolic_, s));
  for (int c = 0; c < pivots.padding; ++c) diagonal(c) = 1.0;
  outOfLine(scatterValues)(values_.get() + first, assembly_.target.data() + first, assembly_.start[s + 1] - first,
                           columns);
  reference_.resize(pivotRows);
  inverse_.resize(4 * static_cast<std::size_t>(pivotRows));
  for (int c = 0; c < pivotRows; ++c) reference_[c] = diagonal(c);
  addChildren(Part::Columns);
}

void Multifrontal::addChildren(Part part) {
  const int s = supernode_;
  const bool isUpdate = part == Part::Update;
  double* const target = stack_.get() + (isUpdate ? updateBase_[s] : low_);
  const auto add = outOfLine(addUpdate);
  for (int child = firstChild_[s]; child != -1; child = sibling_[child])
    add(stack_.get() + updateBase_[child], assembly_.parentRow.data() + symbolic_.rowStart[child],
        symbolic_.rows(child), pivotsOf(symbolic_, s), isUpdate, target);
}

bool Multifrontal::eliminate(double& flopBudget) {
  if (nextStrip_ == -1) {
    assembleFront();
    nextStrip_ = 0;
  }
  const Pivots pivots = pivotsOf(symbolic_, supernode_);
  const int strips = pivots.strips + updateStrips(symbolic_, supernode_);
  double *columns = stack_.get() + low_, *update = stack_.get() + updateBase_[supernode_];
  while (nextStrip_ < strips && flopBudget > 0.0) {
    const int end = std::min(strips, nextStrip_ + stripsAtOnce);
    PivotReport report;
    eliminateStrips(columns, update, pivots, nextStrip_, end, reference_.data(), inverse_.data(), report);
    regularised_ += report.regularised;
    if (report.failed != -1 && failed_ == -1) failed_ = symbolic_.first[supernode_] + report.failed - pivots.padding;
    const double flops = eliminationFlops(pivots, nextStrip_, end);
    flopBudget -= flops;
    flopsDone_ += flops;
    nextStrip_ = end;
  }
  return nextStrip_ == strips;
}

void Multifrontal::finishFront() {
  addChildren(Part::Update);
  // The children's update matrices are at the end of their stack.
  for (int child = firstChild_[supernode_]; child != -1; child = sibling_[child])
    if (isHigh_[child]) high_ += updateSize(symbolic_, child);
    else low_ -= updateSize(symbolic_, child);
  nextStrip_ = -1;
  ++supernode_;
}

double factorisationFlops(const SymbolicFactor& symbolic) {
  double flops = 0.0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const Pivots pivots = pivotsOf(symbolic, s);
    flops += eliminationFlops(pivots, 0, pivots.strips + updateStrips(symbolic, s));
  }
  return flops;
}

}  // namespace shapespline
