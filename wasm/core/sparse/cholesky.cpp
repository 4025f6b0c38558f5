#include "core/sparse/cholesky.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/permutation.h"
#include "core/sparse/graph.h"
#include "core/sparse/multifrontal.h"
#include "core/sparse/ordering.h"
#include "core/sparse/panel_factor.h"
#include "core/sparse/symbolic.h"

namespace shapespline {

namespace {

// FNV-1a hash of the structure, to detect a matrix that was not analysed.
std::uint64_t patternHash(const SymmetricMatrix& matrix) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&](int value) { hash = (hash ^ static_cast<std::uint32_t>(value)) * 1099511628211ull; };
  for (int start : matrix.columnStart) add(start);
  for (int row : matrix.row) add(row);
  return hash;
}

}  // namespace

struct Cholesky::State {
  Precision precision = Precision::Double;
  SymbolicFactor symbolic;
  Assembly assembly;
  std::uint64_t hash = 0;
  double flops = 0.0;
  PanelFactor<float> single;
  PanelFactor<double> full;
  std::optional<Multifrontal> running;
  // count of the last factorisation
  int regularised = 0;
  int failedPosition = -1;
  std::size_t workBytes = 0;
  bool factorised = false;

  void store(const Multifrontal& eliminated) {
    const int s = eliminated.supernode();
    if (precision == Precision::Single) single.store(symbolic, s, eliminated.columns(), eliminated.inverse());
    else full.store(symbolic, s, eliminated.columns(), eliminated.inverse());
  }
};

Cholesky::Cholesky() : state_(std::make_unique<State>()) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

Status Cholesky::analyse(const SymmetricMatrix& matrix, std::span<const Vec3> coordinates, Precision precision,
                         const FractionReport& onProgress, std::span<const int> order) {
  if (Status status = checkSymmetric(matrix); !status) return status;
  if (!coordinates.empty() && coordinates.size() != static_cast<std::size_t>(matrix.size))
    return Error{ErrorCode::Internal, "Give one position per unknown, or none."};
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i].allFinite()) continue;
    Error error{ErrorCode::NotFinite, "The coordinates of unknown " + std::to_string(i) + " are not finite."};
    error.row = static_cast<int>(i);
    return error;
  }
  state_ = std::make_unique<State>();
  state_->precision = precision;
  state_->hash = patternHash(matrix);
  reportFraction(onProgress, 0.02);
  const Graph graph = graphOf(matrix);
  reportFraction(onProgress, 0.05);
  const bool given = static_cast<int>(order.size()) == graph.size() && isPermutation(order);
  const std::vector<int> used = given ? std::vector<int>(order.begin(), order.end())
                                      : fillReducingOrder(graph, coordinates, partOf(onProgress, 0.05, 0.75));
  state_->symbolic = analyseFactor(graph, used, partOf(onProgress, 0.75, 0.95));
  reportFraction(onProgress, 0.95);
  state_->assembly = planAssembly(matrix, state_->symbolic);
  reportFraction(onProgress, 0.97);
  state_->flops = factorisationFlops(state_->symbolic);
  reportFraction(onProgress, 0.98);
  if (precision == Precision::Single) state_->single.allocate(state_->symbolic);
  else state_->full.allocate(state_->symbolic);
  return {};
}

Status Cholesky::beginFactorise(const SymmetricMatrix& matrix) {
  const bool sameStructure = matrix.size == state_->symbolic.size() &&
                             matrix.value.size() == state_->assembly.slot.size() && patternHash(matrix) == state_->hash;
  if (!sameStructure ||
      !std::all_of(matrix.value.begin(), matrix.value.end(), [](double v) { return std::isfinite(v); })) {
    if (Status status = checkSymmetric(matrix); !status) return status;
    return Error{ErrorCode::Internal, "The matrix to factor does not have the structure that was analysed."};
  }
  state_->running.emplace(state_->symbolic, state_->assembly, matrix.value);
  state_->factorised = false;
  state_->failedPosition = -1;
  state_->regularised = 0;
  return {};
}

bool Cholesky::factoriseSome(std::int64_t flopBudget) {
  if (!state_->running) return false;
  Multifrontal& running = *state_->running;
  double budget = static_cast<double>(flopBudget);
  while (!running.done() && running.eliminate(budget)) {
    state_->store(running);
    running.finishFront();
    if (running.failedPosition() != -1) break;
  }
  if (!running.done() && running.failedPosition() == -1) return true;
  state_->regularised = running.regularisedPivots();
  state_->failedPosition = running.failedPosition();
  state_->workBytes = running.stackDoubles() * sizeof(double);
  state_->factorised = running.done() && state_->failedPosition == -1;
  state_->running.reset();
  return false;
}

double Cholesky::factoriseProgress() const {
  if (!state_->running || state_->flops <= 0.0) return 1.0;
  return std::fmin(1.0, state_->running->flopsDone() / state_->flops);
}

Status Cholesky::factoriseStatus() const {
  if (state_->failedPosition != -1) {
    const int unknown = state_->symbolic.order[state_->failedPosition];
    Error error{
        ErrorCode::NotPositiveDefinite,
        "The matrix is not positive definite: its factorisation fails at unknown " + std::to_string(unknown) + "."};
    error.row = unknown;
    return error;
  }
  if (!state_->factorised) return Error{ErrorCode::Internal, "The factorisation is not finished."};
  return {};
}

Status Cholesky::factorise(const SymmetricMatrix& matrix) {
  if (Status status = beginFactorise(matrix); !status) return status;
  while (factoriseSome(std::int64_t{1} << 40)) {
  }
  return factoriseStatus();
}

std::span<const int> Cholesky::eliminationPosition() const { return state_->symbolic.position; }

int Cholesky::paddedSize() const {
  return state_->precision == Precision::Single ? state_->single.paddedSize() : state_->full.paddedSize();
}

void Cholesky::solve(float* xyzp, ForkJoin* forkJoin) const { state_->single.solve(xyzp, forkJoin); }
void Cholesky::solve(double* xyzp, ForkJoin* forkJoin) const { state_->full.solve(xyzp, forkJoin); }

CholeskyStats Cholesky::stats() const {
  const bool isSingle = state_->precision == Precision::Single;
  CholeskyStats stats;
  stats.factorEntries = static_cast<std::int64_t>(isSingle ? state_->single.entries() : state_->full.entries());
  stats.factorBytes = stats.factorEntries * static_cast<std::int64_t>(isSingle ? sizeof(float) : sizeof(double));
  stats.indexBytes = static_cast<std::int64_t>(isSingle ? state_->single.indexBytes() : state_->full.indexBytes());
  stats.workBytes = static_cast<std::int64_t>(state_->workBytes);
  stats.flops = state_->flops;
  stats.supernodes = state_->symbolic.supernodes();
  stats.regularisedPivots = state_->regularised;
  return stats;
}

}  // namespace shapespline
