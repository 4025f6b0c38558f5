// A second thread for a ForkJoin. Where there are none (wasm is tested without threads here; the engine's tests have
// them) SHAPESPLINE_THREADS is not defined.
#pragma once

#if !defined(__wasm__)
#define SHAPESPLINE_THREADS 1

#include <exception>
#include <thread>

#include "core/base/fork_join.h"

namespace shapespline::test {

/// A helper for as long as it lives.
class HelperThread {
 public:
  explicit HelperThread(ForkJoin& forkJoin)
      : forkJoin_(forkJoin), thread_([&forkJoin] {
          try {
            forkJoin.serve();
          } catch (const std::exception&) {
            forkJoin.breakDown();
          }
        }) {}
  HelperThread(const HelperThread&) = delete;
  HelperThread& operator=(const HelperThread&) = delete;
  ~HelperThread() {
    forkJoin_.dismiss();
    thread_.join();
  }

 private:
  ForkJoin& forkJoin_;
  std::thread thread_;
};

}  // namespace shapespline::test

#endif
