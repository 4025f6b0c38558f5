// Calls that stay calls.
#pragma once

namespace shapespline {

/// The function, where no optimiser sees through. A browser compiles a function well once it has been called often, but
/// never in the middle of a call: a kernel that the compiler or the linker puts into the long loop around it would stay
/// in the baseline compiler, at a third of its speed.
template <class Function>
Function* outOfLine(Function* function) {
  Function* volatile pointer = function;
  return pointer;
}

}  // namespace shapespline
