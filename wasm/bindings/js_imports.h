// Functions of JavaScript that the bindings call.
#pragma once

#include <vector>

namespace shapespline::bindings {

/// Calls Module.onProgress(stage, fraction), if it exists; stage is the address of NUL-terminated text.
void reportProgress(const char* stage, double fraction);

/// Calls Module.takeFrame(frame, positions, normals), which writes two arrays of 3n floats at the addresses; false if
/// it has no such frame.
bool takeFrame(int frame, float* positions, float* normals);

/// Calls Module.takeOrder(order, unknowns), which waits for the elimination order from another worker and writes it as
/// int32 to the address. Returns an empty list if there is none.
std::vector<int> takeOrder(int unknowns);

}  // namespace shapespline::bindings
