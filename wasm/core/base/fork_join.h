// Runs two-part work on two threads if a second thread exists.
#pragma once

#include <atomic>
#include <cstdint>

namespace shapespline {

/// Runs work in two parts: the caller does the first, a helper may do the second. This class starts no thread; a helper
/// thread calls serve(). Both wait on a futex and never spin. If the helper has not begun when the first part is done,
/// the caller does both, so a late or missing helper delays nothing.
class ForkJoin {
 public:
  using Part = void (*)(const void* work, int part);

  /// patience: maximum duration of the helper's part, in tenths of a second.
  explicit constexpr ForkJoin(int patience = 100) : patience_(patience) {}

  /// Calls part(work, 0) on this thread and part(work, 1) on either thread, and returns when both are done. The parts
  /// must write to different memory, allocate nothing and throw nothing. Throws std::runtime_error if the helper broke
  /// down or did not return: the results are then invalid. Later calls run both parts on this thread.
  void run(Part part, const void* work);

  /// Runs second parts until the helper is dismissed (between two parts) or given up.
  void serve();
  void dismiss();

  /// Reports that the helper will never finish its current part.
  void breakDown();

  /// Whether the helper broke down or was given up.
  bool lost() const;

  /// Number of parts done by the helper.
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

/// Runs work(0) and work(1), one after the other without a second thread. The split never depends on the threads, so
/// every sum has the same order.
template <class Work>
void inTwo(ForkJoin* forkJoin, const Work& work) {
  inTwo(forkJoin, [](const void* w, int part) { (*static_cast<const Work*>(w))(part); }, &work);
}

}  // namespace shapespline
