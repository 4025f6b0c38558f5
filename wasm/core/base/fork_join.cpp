#include "core/base/fork_join.h"

#include <stdexcept>

#include "core/base/atomic_wait.h"

namespace shapespline {

namespace {

enum State : std::uint32_t { idle, offered, taken, done, dismissed, broken };

}  // namespace

void inTwo(ForkJoin* forkJoin, ForkJoin::Part part, const void* work) {
  if (forkJoin) return forkJoin->run(part, work);
  part(work, 0);
  part(work, 1);
}

void ForkJoin::run(Part part, const void* work) {
  part_ = part;
  work_ = work;
  std::uint32_t state = idle;
  const bool offers = state_.compare_exchange_strong(state, offered, std::memory_order_release);
  if (offers) wakeOne(state_);
  part(work, 0);
  state = offered;
  if (!offers || state_.compare_exchange_strong(state, idle, std::memory_order_acquire)) return part(work, 1);
  if (!isDone()) throw std::runtime_error("the second thread has ended");
  state_.store(idle, std::memory_order_relaxed);
  ++helped_;
}

bool ForkJoin::lost() const { return state_.load(std::memory_order_relaxed) == broken; }

// Counts waits instead of time, because the machine may sleep during a wait.
bool ForkJoin::isDone() {
  for (int left = patience_; left > 0 && state_.load(std::memory_order_acquire) == taken; --left)
    waitWhile(state_, taken);
  std::uint32_t state = taken;
  state_.compare_exchange_strong(state, broken, std::memory_order_acquire);
  return state == done;
}

void ForkJoin::serve() {
  for (std::uint32_t state = state_.load(std::memory_order_acquire); state != dismissed && state != broken;
       state = state_.load(std::memory_order_acquire)) {
    if (state != offered) {
      waitWhile(state_, state);
    } else if (state_.compare_exchange_strong(state, taken, std::memory_order_acquire)) {
      part_(work_, 1);
      state = taken;
      if (state_.compare_exchange_strong(state, done, std::memory_order_release)) wakeOne(state_);
    }
  }
}

void ForkJoin::dismiss() {
  state_.store(dismissed, std::memory_order_release);
  wakeOne(state_);
}

void ForkJoin::breakDown() {
  state_.store(broken, std::memory_order_release);
  wakeOne(state_);
}

}  // namespace shapespline
