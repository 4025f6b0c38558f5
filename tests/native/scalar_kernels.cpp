// The same sources as the core's, in a namespace of their own, where simd.h takes plain C++.
#define SHAPESPLINE_SCALAR 1
#define shapespline shapespline_scalar

#include "core/crew.cpp"
#include "core/dense_front.cpp"
#include "core/face_frame.cpp"
#include "core/face_halves.cpp"
#include "core/face_kernel.cpp"
#include "core/futex.cpp"
#include "core/panel_kernels.cpp"
#include "core/panel_layout.cpp"
#include "core/panels.cpp"
#include "core/progress.cpp"
#include "core/shading.cpp"
#include "core/tree_cut.cpp"

#include "scalar_kernels.h"

#ifndef SHAPESPLINE_SIMD_SCALAR
#error "the reference must not use vector instructions"
#endif

namespace kernels {

std::vector<float> scalarRightHandSide(const Surface& surface, float, double largestTurn, bool logarithmic, const Blend& blend) {
  return shapespline::kernelRuns::rightHandSide<float>(surface, largestTurn, logarithmic, blend);
}
std::vector<double> scalarRightHandSide(const Surface& surface, double, double largestTurn, bool logarithmic, const Blend& blend) {
  return shapespline::kernelRuns::rightHandSide<double>(surface, largestTurn, logarithmic, blend);
}
std::vector<float> scalarSolution(int size, float) { return shapespline::kernelRuns::denseSolution<float>(size); }
std::vector<double> scalarSolution(int size, double) { return shapespline::kernelRuns::denseSolution<double>(size); }
std::vector<double> scalarUpdate(int pivotCount, int rows) { return shapespline::kernelRuns::denseUpdate(pivotCount, rows); }
std::vector<float> scalarNormals(const Surface& surface) { return shapespline::kernelRuns::vertexNormals(surface); }

}  // namespace kernels
