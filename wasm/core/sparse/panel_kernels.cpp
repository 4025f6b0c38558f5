#include "core/sparse/panel_kernels.h"

#include <algorithm>

#include "core/base/no_inline_call.h"
#include "core/base/simd.h"

// Loop bodies here are as small as possible. Browsers' optimising compilers move the loads of a loop body to its front,
// so an unrolled body runs out of registers: bodies of five loads ran twice as fast as bodies of fourteen.

namespace shapespline {

namespace {

constexpr int maxColumns = 64;

constexpr int triangle(int n) { return n * (n + 1) / 2; }

// x, y and z of four unknowns.
template <class V>
struct Group {
  V x = V::zero(), y = V::zero(), z = V::zero();
};

template <class Scalar>
Scalar* at(Scalar* x, int i) {
  return x + 4 * static_cast<std::ptrdiff_t>(i);
}

template <class V, class Scalar>
Group<V> gather(const Scalar* a, const Scalar* b, const Scalar* c, const Scalar* d) {
  Group<V> g = {V::load(a), V::load(b), V::load(c)};
  V pad = V::load(d);
  transpose(g.x, g.y, g.z, pad);
  return g;
}

// Loads the four unknowns in `row`.
template <class V, class Scalar>
Group<V> gather(const Scalar* x, const int* row) {
  return gather<V>(at(x, alone(row[0])), at(x, alone(row[1])), at(x, alone(row[2])), at(x, alone(row[3])));
}

template <class V, class Scalar>
void addTo(Group<V> g, Scalar* a, Scalar* b, Scalar* c, Scalar* d) {
  V pad = V::zero();
  transpose(g.x, g.y, g.z, pad);
  (V::load(a) + g.x).store(a);
  (V::load(b) + g.y).store(b);
  (V::load(c) + g.z).store(c);
  (V::load(d) + pad).store(d);
}

template <class V, class Scalar>
void addTo(const Group<V>& g, Scalar* x, const int* row) {
  addTo(g, at(x, alone(row[0])), at(x, alone(row[1])), at(x, alone(row[2])), at(x, alone(row[3])));
}

// Subtracts four rows times the unknowns from y to end.
template <class V, class Scalar>
Group<V> negativeProduct(const Scalar* values, const Scalar* y, const Scalar* end) {
  Group<V> g;
  for (; y != end; y += 4, values += 4) {
    const V l = V::load(values);
    g.x = g.x - l * V::loadSplat(y);
    g.y = g.y - l * V::loadSplat(y + 1);
    g.z = g.z - l * V::loadSplat(y + 2);
  }
  return g;
}

// x := inverse * x for W unknowns.
template <class V, int W, class Scalar>
void solveDiagonal(const Scalar* inverse, Scalar* x) {
  V b[W];
  for (int j = 0; j < W; ++j) b[j] = V::load(x + 4 * j);
  for (int i = 0; i < W; ++i, inverse += i) {
    V sum = V::loadSplat(inverse) * b[0];
    for (int j = 1; j <= i; ++j) sum = sum + V::loadSplat(inverse + j) * b[j];
    sum.store(x + 4 * i);
  }
}

// Adds up the lanes of four vectors.
template <class V>
V addedUp(V a, V b, V c, V d) {
  transpose(a, b, c, d);
  return (a + b) + (c + d);
}

// x := inverseᵀ * (x - sum) for W unknowns. The lanes of W columns' x, y and z in sum still have to be added up.
template <class V, int W, class Scalar>
void solveDiagonalTransposed(const Scalar* inverse, const Scalar* sum, Scalar* x) {
  const auto number = [sum](int i) {
    const auto of = [&](int column) { return column < W ? V::load(sum + 12 * column + i) : V::zero(); };
    return addedUp(of(0), of(1), of(2), of(3));
  };
  V b[4] = {number(0), number(4), number(8), V::zero()};
  transpose(b[0], b[1], b[2], b[3]);
  for (int j = 0; j < W; ++j) b[j] = V::load(x + 4 * j) - b[j];
  for (int j = 0; j < W; ++j) {
    V result = V::loadSplat(inverse + triangle(j) + j) * b[j];
    for (int i = j + 1; i < W; ++i) result = result + V::loadSplat(inverse + triangle(i) + j) * b[i];
    result.store(x + 4 * j);
  }
}

template <class V, class Scalar>
void forwardPanel(const Scalar* values, int columns, const int* row, int rows, Scalar* x, int first) {
  Scalar* const own = at(x, first);
  Scalar* const end = at(own, columns);
  Scalar* y = own;
  switch (firstBlock(columns)) {
    case 1: solveDiagonal<V, 1>(values, y); break;
    case 2: solveDiagonal<V, 2>(values, y); break;
    case 3: solveDiagonal<V, 3>(values, y); break;
    default: solveDiagonal<V, 4>(values, y); break;
  }
  values += triangle(firstBlock(columns));
  for (y = at(own, firstBlock(columns)); y != end; y += 16) {
    addTo(negativeProduct<V>(values, own, y), y, y + 4, y + 8, y + 12);
    values += y - own;
    solveDiagonal<V, 4>(values, y);
    values += 10;
  }
  for (; rows >= 8; rows -= 8, row += 8) {
    Group<V> g, h;
    for (y = own; y != end; y += 4, values += 8) {
      const V k = V::load(values), l = V::load(values + 4);
      const V vx = V::loadSplat(y), vy = V::loadSplat(y + 1), vz = V::loadSplat(y + 2);
      g.x = g.x - k * vx;
      h.x = h.x - l * vx;
      g.y = g.y - k * vy;
      h.y = h.y - l * vy;
      g.z = g.z - k * vz;
      h.z = h.z - l * vz;
    }
    addTo(g, x, row);
    addTo(h, x, row + 4);
  }
  if (rows > 0) addTo(negativeProduct<V>(values, own, end), x, row);
}

// Adds the products with four rows to the columns' sums, from the last column to the first, or starts the sums. Returns
// the start of the values.
template <class V, bool start = false, class Scalar>
const Scalar* addProducts(const Scalar* values, const Group<V>& g, const Scalar* begin, Scalar* sum) {
  const auto add = [](Scalar* to, V p) { (start ? p : V::load(to) + p).store(to); };
  while (sum != begin) {
    values = stepBack(values, 4);
    sum = stepBack(sum, 12);
    const V l = V::load(values);
    add(sum, l * g.x);
    add(sum + 4, l * g.y);
    add(sum + 8, l * g.z);
  }
  return values;
}

// As above, with eight rows.
template <class V, bool start = false, class Scalar>
const Scalar* addProducts(const Scalar* values, const Group<V>& g, const Group<V>& h, const Scalar* begin,
                          Scalar* sum) {
  const auto add = [](Scalar* to, V p, V q) { ((start ? p : V::load(to) + p) + q).store(to); };
  while (sum != begin) {
    values = stepBack(values, 8);
    sum = stepBack(sum, 12);
    const V k = V::load(values), l = V::load(values + 4);
    add(sum, k * g.x, l * h.x);
    add(sum + 4, k * g.y, l * h.y);
    add(sum + 8, k * g.z, l * h.z);
  }
  return values;
}

template <class V, class Scalar>
void backwardPanel(const Scalar* values, int columns, const int* row, int rows, Scalar* x, int first) {
  alignas(16) Scalar sums[12 * maxColumns];
  Scalar* const end = sums + 12 * columns;
  values += panelEntries(columns, rows);
  row += rows;
  if (rows == 0) {
    std::fill(sums, end, Scalar(0));
  } else if (rows % 8 != 0) {
    row -= 4;
    rows -= 4;
    values = addProducts<V, true>(values, gather<V>(x, row), sums, end);
  } else {
    row -= 8;
    rows -= 8;
    values = addProducts<V, true>(values, gather<V>(x, row), gather<V>(x, row + 4), sums, end);
  }
  for (; rows > 0; rows -= 8) {
    row -= 8;
    values = addProducts<V>(values, gather<V>(x, row), gather<V>(x, row + 4), sums, end);
  }
  const int firstRows = firstBlock(columns);
  for (int c = columns - 4; c >= firstRows; c -= 4) {
    values -= 10;
    Scalar* y = at(x, first + c);
    solveDiagonalTransposed<V, 4>(values, sums + 12 * c, y);
    values = addProducts(values, gather<V>(y, y + 4, y + 8, y + 12), sums, sums + 12 * c);
  }
  values -= triangle(firstRows);
  switch (firstRows) {
    case 1: return solveDiagonalTransposed<V, 1>(values, sums, at(x, first));
    case 2: return solveDiagonalTransposed<V, 2>(values, sums, at(x, first));
    case 3: return solveDiagonalTransposed<V, 3>(values, sums, at(x, first));
    default: return solveDiagonalTransposed<V, 4>(values, sums, at(x, first));
  }
}

}  // namespace

template <class Scalar>
PanelKernels<Scalar> panelKernels() {
  using V = Lanes<Scalar>;
  return {outOfLine(forwardPanel<V, Scalar>), outOfLine(backwardPanel<V, Scalar>)};
}

template PanelKernels<float> panelKernels<float>();
template PanelKernels<double> panelKernels<double>();

}  // namespace shapespline
