#include "core/hold/rigid_groups.h"

#include <algorithm>

#include "core/base/centroid.h"
#include "core/base/union_find.h"

namespace shapespline {

namespace {

// Shares of the shape's size: allowed slack of a joint, and distance of touching parts.
constexpr double slack = 0.03, touches = 0.01;

// Distance between the corners of two faces in a pose.
double gap(const Positions& p, const Triangle& a, const Triangle& b) {
  double nearest = (p[a[0]] - p[b[0]]).norm();
  for (const int i : a)
    for (const int j : b) nearest = std::min(nearest, (p[i] - p[j]).norm());
  return nearest;
}

}  // namespace

bool staysJoined(const HoldMesh& mesh, const ComponentJoint& joint) {
  const WeldedShape& shape = mesh.shape;
  const double size = sizeOf(shape.poses[shape.reference]);
  double given = 0, apart = 0;
  for (int key = 0; key < shape.keys; ++key) {
    given = std::max(given, (joint.offset[key] - joint.offset[shape.reference]).norm());
    apart = std::max(apart, gap(shape.poses[key], shape.faces[joint.anchorFace], shape.faces[joint.contactFace]));
  }
  return given < slack * size || apart < touches * size;
}

std::vector<int> rigidGroupsOf(const HoldMesh& mesh) {
  const std::vector<Triangle>& faces = mesh.shape.faces;
  UnionFind joined(mesh.shape.vertexCount());
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (mesh.localFrameOf[f] >= 0) {
      joined.join(faces[f][0], faces[f][1]);
      joined.join(faces[f][0], faces[f][2]);
    }
  for (const ComponentJoint& joint : mesh.joints)
    if (staysJoined(mesh, joint)) joined.join(faces[joint.anchorFace][0], faces[joint.contactFace][0]);
  for (const LooseVertex& loose : mesh.loose) joined.join(faces[loose.anchorFace][0], loose.vertex);
  std::vector<int> body, number(mesh.shape.vertexCount(), -1);
  int count = 0;
  for (int v = 0; v < mesh.shape.vertexCount(); ++v) {
    int& n = number[joined.find(v)];
    if (n < 0) n = count++;
    body.push_back(n);
  }
  return body;
}

}  // namespace shapespline
