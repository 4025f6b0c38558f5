// Prevents inlining.
#pragma once

namespace shapespline {

/// Hides the function from the optimiser. A browser optimises a function after many calls, but never during a call. A
/// kernel inlined into the long loop around it would stay in the baseline compiler, at a third of the speed.
template <class Function>
Function* outOfLine(Function* function) {
  Function* volatile pointer = function;
  return pointer;
}

}  // namespace shapespline
