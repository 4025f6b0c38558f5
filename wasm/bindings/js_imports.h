// What the bindings ask of the JavaScript around them.
#pragma once

#include <vector>

namespace shapespline::bindings {

/// Calls Module.onProgress(stage, fraction), if there is one; stage is the address of text ended by a NUL.
void reportProgress(const char* stage, double fraction);

/// Calls Module.takeFrame(frame, positions, normals), which writes two arrays of 3n floats at the addresses; false if
/// it has no such frame.
bool takeFrame(int frame, float* positions, float* normals);

/// Calls Module.takeOrder(order, unknowns), which waits for the order of elimination that another worker finds, and
/// writes it, int32 numbers, at the address; false if there is none. Empty then.
std::vector<int> takeOrder(int unknowns);

}  // namespace shapespline::bindings
