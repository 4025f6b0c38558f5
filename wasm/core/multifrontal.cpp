#include "core/multifrontal.h"

#include <algorithm>

#include "core/dense_front.h"
#include "core/out_of_line.h"
#include "core/simd.h"

namespace shapespline {

namespace {

// Strips eliminated between two looks at the budget.
constexpr int kStripsAtOnce = 32;

Pivots pivotsOf(const SymbolicFactor& symbolic, int s) { return Pivots(symbolic.columns(s)); }
int updateStrips(const SymbolicFactor& symbolic, int s) { return stripsFor(symbolic.rows(s)); }

// The largest size that the stack will have, in doubles.
std::size_t stackPeak(const SymbolicFactor& symbolic) {
  std::vector<std::size_t> childUpdates(symbolic.supernodes(), 0);
  std::size_t top = 0, peak = 0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const int update = updateStrips(symbolic, s);
    peak = std::max(peak, top + stripOffset(pivotsOf(symbolic, s).strips + update));
    top = top - childUpdates[s] + stripOffset(update);
    if (symbolic.parent[s] != -1) childUpdates[symbolic.parent[s]] += stripOffset(update);
  }
  return peak;
}

// What memset and memcpy do for whole strips: WebAssembly's C library has them a word at a time or asks JavaScript to do it.
// stepBack() keeps compilers from calling them all the same.
void clear(double* begin, std::size_t n) {
  for (double* p = begin + n; p != begin;) {
    p = stepBack(p, 4);
    Double4::zero().store(p);
  }
}
void copy(const double* from, std::size_t n, double* to) {
  to += n;
  for (const double* p = from + n; p != from;) {
    p = stepBack(p, 4), to = stepBack(to, 4);
    Double4::load(p).store(to);
  }
}

// Values move to their slots, and those of one supernode to their places. To read them at random costs five times as much.
void sortValues(std::span<const double> values, const int* slot, double* sorted) {
  for (std::size_t i = 0; i < values.size(); ++i) sorted[slot[i]] = values[i];
}
void placeValues(const double* value, const std::size_t* place, int count, double* front) {
  for (int i = 0; i < count; ++i) front[place[i]] = value[i];
}

// Adds a strip of an update matrix, `rows` rows from row `first` on, to its parent's front, where row and column k are to[k].
void addStrip(const double* strip, int first, int rows, const int* to, double* front) {
  double* target[4];
  for (int r = 0; r < rows; ++r) target[r] = front + placeInFront(to[first + r], 0);
  if (rows == 4 && target[1] == target[0] + 1 && target[3] == target[2] + 1) {  // two and two side by side
    double *a = target[0], *c = target[2];
    for (int k = 0; k < first; ++k, strip += 4) {
      const int column = 4 * to[k];
      (Double2::load(a + column) + Double2::load(strip)).store(a + column);
      (Double2::load(c + column) + Double2::load(strip + 2)).store(c + column);
    }
  } else if (rows == 4) {
    double *a = target[0], *b = target[1], *c = target[2], *d = target[3];
    for (int k = 0; k < first; ++k, strip += 4) {
      const int column = 4 * to[k];
      a[column] += strip[0], b[column] += strip[1], c[column] += strip[2], d[column] += strip[3];
    }
  } else {
    for (int k = 0; k < first; ++k, strip += 4)
      for (int r = 0; r < rows; ++r) target[r][4 * to[k]] += strip[r];
  }
  for (int k = 0; k < rows; ++k, strip += 4)
    for (int r = k; r < rows; ++r) target[r][4 * to[first + k]] += strip[r];
}

}  // namespace

Multifrontal::Multifrontal(const SymbolicFactor& symbolic, const Assembly& assembly, std::span<const double> values)
    : symbolic_(symbolic), assembly_(assembly), values_(std::make_unique_for_overwrite<double[]>(values.size())),
      stackSize_(stackPeak(symbolic)), stack_(std::make_unique_for_overwrite<double[]>(stackSize_)) {
  outOfLine(sortValues)(values, assembly.slot.data(), values_.get());
  const int count = symbolic.supernodes();
  firstChild_.assign(count, -1);
  sibling_.assign(count, -1);
  updateBase_.assign(count, 0);
  for (int s = 0; s < count; ++s) {
    if (symbolic.parent[s] == -1) continue;
    sibling_[s] = firstChild_[symbolic.parent[s]];
    firstChild_[symbolic.parent[s]] = s;
  }
}

void Multifrontal::assembleFront() {
  const int s = supernode_, first = assembly_.start[s];
  const Pivots pivots = pivotsOf(symbolic_, s);
  const int pivotRows = 4 * pivots.strips;
  frontBase_ = stackTop_;
  double* front = stack_.get() + frontBase_;
  outOfLine(clear)(front, stripOffset(pivots.strips + updateStrips(symbolic_, s)));
  for (int c = 0; c < pivots.padding; ++c) front[placeInFront(c, c)] = 1.0;
  outOfLine(placeValues)(values_.get() + first, assembly_.place.data() + first, assembly_.start[s + 1] - first, front);
  reference_.resize(pivotRows);
  inverse_.resize(4 * static_cast<std::size_t>(pivotRows));
  for (int c = 0; c < pivotRows; ++c) reference_[c] = front[placeInFront(c, c)];
  for (int child = firstChild_[s]; child != -1; child = sibling_[child]) addChild(child, front);
}

void Multifrontal::addChild(int child, double* front) {
  const int rows = symbolic_.rows(child);
  const int* to = assembly_.parentRow.data() + symbolic_.rowStart[child];
  const auto add = outOfLine(addStrip);
  const double* update = stack_.get() + updateBase_[child];
  for (int r = 0; r < rows; r += 4) add(update + stripOffset(r / 4), r, std::min(4, rows - r), to, front);
}

bool Multifrontal::eliminate(double& flopBudget) {
  if (nextStrip_ == -1) {
    assembleFront();
    nextStrip_ = 0;
  }
  const Pivots pivots = pivotsOf(symbolic_, supernode_);
  const int strips = pivots.strips + updateStrips(symbolic_, supernode_);
  double* front = stack_.get() + frontBase_;
  while (nextStrip_ < strips && flopBudget > 0.0) {
    const int end = std::min(strips, nextStrip_ + kStripsAtOnce);
    PivotReport report;
    eliminateStrips(front, pivots, nextStrip_, end, reference_.data(), inverse_.data(), report);
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
  const int s = supernode_, pivots = pivotsOf(symbolic_, s).strips, update = updateStrips(symbolic_, s);
  // The children's update matrices lie directly below the front, the first pushed one lowest.
  std::size_t base = frontBase_;
  for (int child = firstChild_[s]; child != -1; child = sibling_[child]) base = updateBase_[child];
  double* target = stack_.get() + base;
  const double* front = stack_.get() + frontBase_;
  const auto move = outOfLine(copy);
  for (int i = 0; i < update; ++i) {
    const double* strip = front + stripOffset(pivots + i) + 16 * static_cast<std::size_t>(pivots);
    move(strip, 16 * static_cast<std::size_t>(i + 1), target + stripOffset(i));
  }
  updateBase_[s] = base;
  stackTop_ = base + stripOffset(update);
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
