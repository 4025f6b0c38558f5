// A second thread for work that comes in two parts, where there is one.
#pragma once

#include <atomic>
#include <cstdint>

namespace shapespline {

/// Work in two parts: the caller does the first, a helper may do the second. No thread is started here: a thread that
/// can help calls serve(). Both wait on a futex and never spin. If the helper has not begun when the first part is
/// done, the caller does both, so a late or missing helper delays nothing.
class ForkJoin {
 public:
  using Part = void (*)(const void* work, int part);

  /// patience: how many tenths of a second a part may take the helper, once it has begun.
  explicit constexpr ForkJoin(int patience = 100) : patience_(patience) {}

  /// Calls part(work, 0) here and part(work, 1) here or there, and returns when both are done. They must write to
  /// different places, allocate nothing and throw nothing. Throws std::runtime_error if the helper broke down in the
  /// middle of its part or never came back from it: what the work writes to cannot be relied on then. Later calls do
  /// all of theirs here.
  void run(Part part, const void* work);

  /// Does second parts until it is dismissed, between two pieces of work, or given up.
  void serve();
  void dismiss();

  /// Says for a helper that it will never finish the part it had begun.
  void breakDown();

  /// The helper broke down or was given up.
  bool lost() const;

  /// Parts that the helper has done.
  long long helped() const { return helped_; }

 private:
  bool isDone();

  int patience_;
  std::atomic<std::uint32_t> state_ = 0;
  Part part_ = nullptr;
  const void* work_ = nullptr;
  long long helped_ = 0;
};

void inTwo(ForkJoin* forkJoin, ForkJoin::Part part, const void* work);

/// work(0) and work(1), one after the other where there is no second thread. Work is cut in the same way with and
/// without one, so every sum is taken in the same order.
template <class Work>
void inTwo(ForkJoin* forkJoin, const Work& work) {
  inTwo(forkJoin, [](const void* w, int part) { (*static_cast<const Work*>(w))(part); }, &work);
}

}  // namespace shapespline
