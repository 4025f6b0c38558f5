#include "core/hold/hold_system.h"

#include <algorithm>

#include "core/base/centroid.h"
#include "core/hold/hold_passes.h"
#include "core/hold/rigid_groups.h"
#include "core/mesh/triangle.h"
#include "core/sparse/spring_matrix.h"

namespace shapespline {

namespace {

// Relative to the stiffness of the connected vertices. A joint is stiffer; a loose vertex is so soft that it pulls
// nothing.
constexpr double jointStiffness = 10, looseStiffness = 1e-3;

void addFaces(const HoldMesh& mesh, SpringMatrix& k) {
  for (std::size_t f = 0; f < mesh.localFrameOf.size(); ++f) {
    if (mesh.localFrameOf[f] < 0) continue;
    const Triangle& t = mesh.shape.faces[f];
    for (int c = 0; c < 3; ++c) k.add(t[(c + 1) % 3], t[(c + 2) % 3], sideStiffness(mesh, f, c));
  }
}

void addJoints(const HoldMesh& mesh, SpringMatrix& k) {
  const std::vector<double> own = k.diagonal;
  for (const ComponentJoint& joint : mesh.joints) {
    if (!staysJoined(mesh, joint)) continue;
    for (int c = 0; c < 3; ++c) {
      const int i = mesh.shape.faces[joint.anchorFace][c], j = mesh.shape.faces[joint.contactFace][c];
      k.add(i, j, jointStiffness * (own[i] + own[j]));
    }
  }
  for (const LooseVertex& loose : mesh.loose)
    for (const int v : mesh.shape.faces[loose.anchorFace]) k.add(v, loose.vertex, looseStiffness * own[v]);
}

SpringMatrix stiffnessOf(const HoldMesh& mesh) {
  SpringMatrix k(mesh.shape.vertexCount());
  addFaces(mesh, k);
  addJoints(mesh, k);
  return k;
}

}  // namespace

double sizeOf(const Positions& positions) {
  const Vec3 centre = centroidOf(positions);
  double farthest = 0;
  for (const Vec3& p : positions) farthest = std::max(farthest, (p - centre).norm());
  return 2 * farthest;
}

double sideStiffness(const HoldMesh& mesh, std::size_t face, int c) {
  return cotangentWeight(mesh.shape.poses[mesh.shape.reference], mesh.shape.faces[face], c);
}

std::vector<double> stiffnessDiagonal(const HoldMesh& mesh) { return stiffnessOf(mesh).diagonal; }

std::vector<double> faceAreas(const HoldMesh& mesh) {
  const Positions& p = mesh.shape.poses[mesh.shape.reference];
  std::vector<double> area;
  double whole = 0;
  for (std::size_t f = 0; f < mesh.localFrameOf.size(); ++f) {
    const Triangle& t = mesh.shape.faces[f];
    area.push_back(mesh.localFrameOf[f] < 0 ? 0 : (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm());
    whole += area.back();
  }
  for (double& a : area) a /= whole;
  return area;
}

std::vector<double> vertexAreas(const HoldMesh& mesh) {
  const std::vector<double> face = faceAreas(mesh);
  std::vector<double> area(mesh.shape.poses[0].size(), 0.0);
  for (std::size_t f = 0; f < face.size(); ++f)
    for (const int v : mesh.shape.faces[f]) area[v] += face[f] / 3;
  return area;
}

Result<HoldSystem> HoldSystem::create(const HoldMesh& mesh, std::span<const double> weight, Precision precision) {
  const SymmetricMatrix matrix = stiffnessOf(mesh).plus(weight);
  HoldSystem system;
  system.precision_ = precision == Precision::Single ? Precision::Single : Precision::Double;
  const Positions& reference = mesh.shape.poses[mesh.shape.reference];
  if (Status status = system.solver_.analyse(matrix, reference, system.precision_); !status) return status.error();
  if (Status status = system.solver_.factorise(matrix); !status) return status.error();
  const auto position = system.solver_.eliminationPosition();
  system.slot_.assign(position.begin(), position.end());
  return system;
}

template <class Real>
void HoldSystem::addSolvedIn(std::vector<Real>& x, const Positions& pull, Positions& shape, ForkJoin* forkJoin) const {
  x.resize(4 * static_cast<std::size_t>(solver_.paddedSize()));
  writeXyzp(pull, slot_, Vec3::Zero(), x);
  solver_.solve(x.data(), forkJoin);
  addXyzp(x, slot_, shape);
}

void HoldSystem::addSolved(const Positions& pull, Positions& shape, Scratch& scratch, ForkJoin* forkJoin) const {
  if (precision_ == Precision::Double) addSolvedIn(scratch.whole, pull, shape, forkJoin);
  else addSolvedIn(scratch.single, pull, shape, forkJoin);
}

}  // namespace shapespline
