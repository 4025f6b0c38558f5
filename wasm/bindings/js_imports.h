// JavaScript functions called by the bindings.
#pragma once

#include <vector>

namespace shapespline::bindings {

/// Calls Module.onProgress(stage, fraction), if it exists. stage: address of NUL-terminated text.
void reportProgress(const char* stage, double fraction);

/// Calls Module.takeFrame(frame, positions, normals), which writes 3n floats to each of the two addresses. Returns
/// false if the frame does not exist.
bool takeFrame(int frame, float* positions, float* normals);

/// Calls Module.takeOrder(order, unknowns), which waits for the elimination order from another worker and writes it to
/// the address as int32. Returns an empty list if there is no order.
std::vector<int> takeOrder(int unknowns);

}  // namespace shapespline::bindings
