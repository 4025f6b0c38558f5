#include "core/base/atomic_wait.h"

#if !defined(__wasm__)
#include <chrono>
#include <thread>
#endif

namespace shapespline {

#if defined(__wasm_atomics__)
// On this platform, the library's wait polls a clock.
void waitWhile(std::atomic<std::uint32_t>& number, std::uint32_t value) {
  constexpr std::int64_t nanoseconds = 100'000'000;
  __builtin_wasm_memory_atomic_wait32(reinterpret_cast<int*>(&number), static_cast<int>(value), nanoseconds);
}
void wakeOne(std::atomic<std::uint32_t>& number) {
  __builtin_wasm_memory_atomic_notify(reinterpret_cast<int*>(&number), 1);
}
#elif defined(__wasm__)
// Without shared memory, no other thread exists.
void waitWhile(std::atomic<std::uint32_t>&, std::uint32_t) {}
void wakeOne(std::atomic<std::uint32_t>&) {}
#else
// For tests only: the standard library cannot wait for a limited time.
void waitWhile(std::atomic<std::uint32_t>& number, std::uint32_t value) {
  for (int left = 2000; left > 0 && number.load(std::memory_order_acquire) == value; --left)
    std::this_thread::sleep_for(std::chrono::microseconds(50));
}
void wakeOne(std::atomic<std::uint32_t>&) {}
#endif

}  // namespace shapespline
