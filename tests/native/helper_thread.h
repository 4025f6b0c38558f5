// A second thread for a ForkJoin. SHAPESPLINE_THREADS is undefined on platforms without threads. (The wasm build of
// these tests has none; the engine's tests do.)
#pragma once

#if !defined(__wasm__)
#define SHAPESPLINE_THREADS 1

#include <exception>
#include <thread>

#include "core/base/fork_join.h"

namespace shapespline::test {

/// Runs a helper during its lifetime.
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
