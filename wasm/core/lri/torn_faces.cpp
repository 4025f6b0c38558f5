#include "core/lri/torn_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shapespline {

namespace {

// Largest ratios of an edge or a height between two poses. On skinned, sculpted and captured characters, about one face
// in 500 exceeds the first. A mouth that opens tears its membrane by more than the second all around.
constexpr double ordinaryChange = 5, tornChange = 8;

// Edges and heights of a triangle. If one direction of a face is stretched far, some of them are, too.
std::array<double, 6> extentsOf(const Positions& p, const Triangle& t) {
  const Vec3 sides[] = {p[t[1]] - p[t[0]], p[t[2]] - p[t[1]], p[t[0]] - p[t[2]]};
  const double twiceArea = sides[0].cross(sides[1]).norm();
  std::array<double, 6> extents;
  for (int k = 0; k < 3; ++k) {
    extents[k] = sides[k].norm();
    extents[3 + k] = twiceArea / extents[k];
  }
  return extents;
}

// The root of each component's area, by pose.
std::vector<std::vector<double>> sizesOf(const WeldedShape& shape, const std::vector<char>& hasArea,
                                         const Components& parts) {
  std::vector<std::vector<double>> sizes;
  for (const Positions& p : shape.poses) {
    std::vector<double>& size = sizes.emplace_back(parts.count, 0);
    for (int f = 0; f < shape.faceCount(); ++f) {
      const Triangle& t = shape.faces[f];
      if (hasArea[f]) size[parts.ofFace[f]] += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() / 2;
    }
    for (double& one : size) one = std::sqrt(one);
  }
  return sizes;
}

// The largest ratio of an edge or a height between two poses, relative to the size of the component.
double largestChange(const WeldedShape& shape, int face, int part, const std::vector<std::vector<double>>& sizes) {
  std::array<double, 6> least, most;
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(0);
  for (std::size_t c = 0; c < shape.poses.size(); ++c) {
    const std::array<double, 6> extents = extentsOf(shape.poses[c], shape.faces[face]);
    for (int k = 0; k < 6; ++k) {
      least[k] = std::min(least[k], extents[k] / sizes[c][part]);
      most[k] = std::max(most[k], extents[k] / sizes[c][part]);
    }
  }
  double largest = 1;
  for (int k = 0; k < 6; ++k) largest = std::max(largest, most[k] / least[k]);
  return largest;
}

double tornShare(double change) {
  const double x = std::clamp(std::log(change / ordinaryChange) / std::log(tornChange / ordinaryChange), 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

// Closes gaps: faces between torn faces are torn, too. Each face takes the largest share of the
// faces at its vertices, and then the smallest, which is the largest negative one.
void closeGaps(const WeldedShape& shape, const std::vector<char>& hasArea, std::vector<double>& torn) {
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<double> at(shape.vertexCount(), -1);
    for (std::size_t f = 0; f < torn.size(); ++f)
      if (hasArea[f])
        for (int v : shape.faces[f]) at[v] = std::max(at[v], torn[f]);
    for (std::size_t f = 0; f < torn.size(); ++f)
      if (hasArea[f]) {
        for (int v : shape.faces[f]) torn[f] = std::max(torn[f], at[v]);
        torn[f] = -torn[f];
      }
  }
}

}  // namespace

std::vector<double> tornShares(const WeldedShape& shape, const std::vector<char>& hasArea, const Components& parts) {
  const std::vector<std::vector<double>> sizes = sizesOf(shape, hasArea, parts);
  std::vector<double> torn(shape.faces.size(), 0);
  for (std::size_t f = 0; f < torn.size(); ++f)
    if (hasArea[f]) torn[f] = tornShare(largestChange(shape, static_cast<int>(f), parts.ofFace[f], sizes));
  if (std::none_of(torn.begin(), torn.end(), [](double share) { return share > 0; })) return {};
  closeGaps(shape, hasArea, torn);
  std::vector<double> least(parts.count, 1);
  for (std::size_t f = 0; f < torn.size(); ++f)
    if (hasArea[f]) least[parts.ofFace[f]] = std::min(least[parts.ofFace[f]], torn[f]);
  for (std::size_t f = 0; f < torn.size(); ++f)
    if (hasArea[f]) torn[f] -= least[parts.ofFace[f]];
  return torn;
}

std::vector<int> anchorsOf(const WeldedShape& shape, const ShapeTopology& topology) {
  std::vector<int> anchor(shape.faceCount(), -1);
  topology.eachUsedFace([&](int f) { anchor[f] = f; });
  if (topology.torn.empty()) return anchor;
  std::vector<int> nearest(shape.vertexCount(), -1), reached;  // a queue of vertices
  const auto settle = [&](int f, int anchorFace) {
    anchor[f] = anchorFace;
    for (int v : shape.faces[f])
      if (nearest[v] < 0) {
        nearest[v] = anchorFace;
        reached.push_back(v);
      }
  };
  topology.eachUsedFace([&](int f) { settle(f, f); });
  const VertexFaces facesAt = facesOfVertices(shape.vertexCount(), shape.faces);
  for (std::size_t taken = 0; taken < reached.size(); ++taken)
    for (int f : facesAt.of(reached[taken]))
      if (topology.hasArea[f] && anchor[f] < 0) settle(f, nearest[reached[taken]]);
  return anchor;
}

std::vector<TornFace> encodeTornFaces(const WeldedShape& shape, const ShapeTopology& topology,
                                      const LocalFramePoses& frames, bool facesRest) {
  std::vector<TornFace> result;
  for (std::size_t f = 0; f < topology.torn.size(); ++f) {
    if (topology.torn[f] == 0) continue;
    const Triangle& t = shape.faces[f];
    const FaceFrame frame = referenceFrame(shape, static_cast<int>(f));
    const Vec2 b = frame.edges.col(0), c = frame.edges.col(1);
    Mat2 hats;
    hats << hatGradient(c - b), hatGradient(-c);
    const Mat2 ofEdges = topology.torn[f] * frame.edges.inverse() * hats;
    TornFace torn{t, topology.anchor[f], frames.ofFace[f], {}, {}};
    for (int column = 0; column < shape.columns(); ++column) {
      const Positions& p = shape.poses[facesRest ? shape.reference : column];
      const auto add = [&](const Quaternion& turn, TornFace::Columns& columns) {
        const Quaternion back = facesRest ? Quaternion::Identity() : turn.conjugate();
        const Vec3 first = back * (p[t[1]] - p[t[0]]), second = back * (p[t[2]] - p[t[0]]);
        columns.first.push_back(ofEdges(0, 0) * first + ofEdges(1, 0) * second);
        columns.second.push_back(ofEdges(0, 1) * first + ofEdges(1, 1) * second);
      };
      add(frames.rotation[column][torn.frame], torn.inFrame);
      add(rotationOf(shape, torn.anchorFace, column), torn.inAnchor);
    }
    result.push_back(std::move(torn));
  }
  return result;
}

}  // namespace shapespline
