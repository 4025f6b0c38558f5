// The same sources as the core's, in a namespace of their own, where simd.h takes plain C++.
#define SHAPESPLINE_SCALAR 1
#define shapespline shapespline_scalar

#include "core/base/atomic_wait.cpp"
#include "core/base/fork_join.cpp"
#include "core/base/progress.cpp"
#include "core/lri/face_frame.cpp"
#include "core/mesh/face_order.cpp"
#include "core/mesh/vertex_normals.cpp"
#include "core/reconstruct/face_kernel.cpp"
#include "core/sparse/dense_front.cpp"
#include "core/sparse/panel_factor.cpp"
#include "core/sparse/panel_kernels.cpp"
#include "core/sparse/panel_layout.cpp"
#include "core/sparse/subtree_partition.cpp"

#include "scalar_kernels.h"

#ifndef SHAPESPLINE_SIMD_SCALAR
#error "the reference must not use vector instructions"
#endif

namespace kernels {

std::vector<float> scalarRightHandSide(const Surface& surface, float, double largestTurn, bool logarithmic,
                                       const Blend& blend) {
  return shapespline::kernelRuns::rightHandSide<float>(surface, largestTurn, logarithmic, blend);
}
std::vector<double> scalarRightHandSide(const Surface& surface, double, double largestTurn, bool logarithmic,
                                        const Blend& blend) {
  return shapespline::kernelRuns::rightHandSide<double>(surface, largestTurn, logarithmic, blend);
}
std::vector<float> scalarSolution(int size, float) { return shapespline::kernelRuns::denseSolution<float>(size); }
std::vector<double> scalarSolution(int size, double) { return shapespline::kernelRuns::denseSolution<double>(size); }
std::vector<double> scalarUpdate(int pivotCount, int rows) {
  return shapespline::kernelRuns::denseUpdate(pivotCount, rows);
}
std::vector<float> scalarNormals(const Surface& surface) { return shapespline::kernelRuns::vertexNormals(surface); }

}  // namespace kernels
