// Waits for another thread to change a number, without spinning.
#pragma once

#include <atomic>
#include <cstdint>

namespace shapespline {

/// Returns when the number differs from `value`, after a tenth of a second, or earlier.
void waitWhile(std::atomic<std::uint32_t>& number, std::uint32_t value);

/// Wakes one waiting thread.
void wakeOne(std::atomic<std::uint32_t>& number);

}  // namespace shapespline
