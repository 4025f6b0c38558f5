// The kernels' runs (kernel_runs.h) without vector instructions.
#pragma once

#include "kernel_runs.h"

namespace kernels {

std::vector<float> scalarRightHandSide(const Surface& surface, float, double largestTurn, bool logarithmic,
                                       const Blend& blend = {});
std::vector<double> scalarRightHandSide(const Surface& surface, double, double largestTurn, bool logarithmic,
                                        const Blend& blend = {});
std::vector<float> scalarSolution(int size, float);
std::vector<double> scalarSolution(int size, double);
std::vector<double> scalarUpdate(int pivotCount, int rows);
std::vector<float> scalarNormals(const Surface& surface);

}  // namespace kernels
