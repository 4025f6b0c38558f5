// Progress of long work.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace shapespline {

/// Reports a fraction of some work in [0, 1] to a listener; may be empty. The listener, any callable with one number,
/// must outlive the report: owning it would add code everywhere.
class FractionReport {
 public:
  FractionReport() = default;

  template <class Listener>
    requires(std::is_invocable_v<const Listener&, double> && !std::is_same_v<Listener, FractionReport>)
  FractionReport(const Listener& listener)
      : listener_(&listener),
        tell_([](const void* l, double fraction) { (*static_cast<const Listener*>(l))(fraction); }) {}

  explicit operator bool() const { return tell_ != nullptr; }
  void operator()(double fraction) const { tell_(listener_, from_ + (to_ - from_) * fraction); }

  /// Maps a sub-task to the range from one fraction to another.
  FractionReport part(double from, double to) const {
    FractionReport out = *this;
    out.from_ = from_ + (to_ - from_) * from;
    out.to_ = from_ + (to_ - from_) * to;
    return out;
  }

 private:
  const void* listener_ = nullptr;
  void (*tell_)(const void* listener, double fraction) = nullptr;
  double from_ = 0, to_ = 1;
};

/// Receives the name of a stage and its completed fraction; may be empty.
using StageProgress = std::function<void(const char* stage, double fraction)>;

/// Reports one stage of work under its name.
struct Stage {
  const StageProgress& progress;
  const char* name;

  void operator()(double fraction) const {
    if (progress) progress(name, fraction);
  }
};

/// Reports item i of n at intervals short enough for a progress bar, with negligible cost.
inline void reportItem(const FractionReport& report, std::size_t i, std::size_t n) {
  if (report && i % 16384 == 0) report(static_cast<double>(i) / static_cast<double>(n));
}

inline void reportFraction(const FractionReport& report, double fraction) {
  if (report) report(fraction);
}

/// A function for a block [begin, end) of items, called with its work data.
using BlockWork = void (*)(void* work, std::size_t begin, std::size_t end);

void inBlocks(const FractionReport& report, std::size_t n, BlockWork call, void* work);

/// Calls work(begin, end) for consecutive blocks of n items, with a report before each. Every block is a separate call
/// (no_inline_call.h), so long work does not stay in the browser's baseline compiler.
template <class Work>
void inBlocks(const FractionReport& report, std::size_t n, Work work) {
  inBlocks(report, n, [](void* w, std::size_t begin, std::size_t end) { (*static_cast<Work*>(w))(begin, end); }, &work);
}

inline FractionReport partOf(const FractionReport& report, double from, double to) { return report.part(from, to); }

}  // namespace shapespline
