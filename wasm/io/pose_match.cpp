#include "io/pose_match.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/mesh/same_surface.h"
#include "io/quad_cuts.h"

namespace shapespline {

namespace {

// Run index of each vertex. A run consists of consecutive vertices that coincide in all poses.
std::vector<int> runsOf(std::span<const Positions* const> poses) {
  std::vector<int> run(poses[0]->size(), 0);
  for (std::size_t v = 1; v < run.size(); ++v) {
    const bool same =
        std::all_of(poses.begin(), poses.end(), [v](const Positions* p) { return (*p)[v] == (*p)[v - 1]; });
    run[v] = run[v - 1] + (same ? 0 : 1);
  }
  return run;
}

int countOf(const std::vector<int>& run) { return run.empty() ? 0 : run.back() + 1; }

std::vector<Triangle> mapped(const std::vector<Triangle>& faces, const std::vector<int>& to) {
  std::vector<Triangle> out(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int c = 0; c < 3; ++c) out[f][c] = to[faces[f][c]];
  return out;
}

std::vector<int> cornersOf(const std::vector<Triangle>& faces) {
  std::vector<int> corners;
  corners.reserve(3 * faces.size());
  for (const Triangle& f : faces) corners.insert(corners.end(), f.begin(), f.end());
  return corners;
}

bool allFinite(const Positions& pose) {
  return std::all_of(pose.begin(), pose.end(), [](const Vec3& p) { return p.allFinite(); });
}

// Whether the corners of two lists match as vertices of one surface. A point of one list may match several points of
// the other if the shape touches itself. If these in turn match several points of the first list, the match is a
// coincidence.
bool belongTogether(const std::vector<int>& a, int countA, const std::vector<int>& b, int countB) {
  std::vector<std::pair<int, int>> pairs(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) pairs[c] = {a[c], b[c]};
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<int> ofA(countA, 0), ofB(countB, 0);
  for (const auto& [pointA, pointB] : pairs) {
    ++ofA[pointA];
    ++ofB[pointB];
  }
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return ofA[pair.first] == 1 || ofB[pair.second] == 1; });
}

// Sum of squared differences between corresponding side lengths in the mesh and the pose.
double strainOf(const Positions& mesh, const std::vector<int>& corners, const Positions& pose,
                const std::vector<int>& posed) {
  double sum = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t d = c % 3 == 2 ? c - 2 : c + 1;
    const double change = (pose[posed[c]] - pose[posed[d]]).norm() - (mesh[corners[c]] - mesh[corners[d]]).norm();
    sum += change * change;
  }
  return sum;
}

// Faces with wrong indices can look like reordered faces. In that case the pose fits the faces of the mesh, but its own
// faces tear it.
bool nameWrongVertices(const Positions& mesh, const std::vector<int>& corners, const Positions& pose,
                       const std::vector<int>& posed) {
  return mesh.size() == pose.size() &&
         strainOf(mesh, corners, pose, posed) > 4 * strainOf(mesh, corners, pose, corners);
}

}  // namespace

Welding weldPoses(std::span<const Positions* const> poses) { return weld(poses, weldTolerances(poses)); }

std::optional<PoseMatch> PoseMatcher::find(const std::vector<Triangle>& faces,
                                           std::span<const Positions* const> poses) const {
  if (faces.size() != faces_.size()) return {};
  const bool same = poses[0]->size() == positions_.size() && sameSurface(faces_, faces);
  // Triangles without shared vertices, numbered in file order, are equal for both cuts of a quad.
  const bool cutsShow = positions_.size() <= faces_.size() + 2;
  if (!same || !cutsShow) {
    if (auto match = same ? std::nullopt : byCopies(faces, poses)) return match;
    if (auto match = byCorners(faces, poses); !same || (match && match->cornerOf != cornersOf(faces))) return match;
  }
  PoseMatch match;
  match.vertexOf.resize(positions_.size());
  std::iota(match.vertexOf.begin(), match.vertexOf.end(), 0);
  return match;
}

std::optional<PoseMatch> PoseMatcher::byCopies(const std::vector<Triangle>& faces,
                                               std::span<const Positions* const> poses) const {
  const Positions* own[] = {&positions_};
  const std::vector<int> runs = runsOf(own), theirs = runsOf(poses);
  if (countOf(runs) != countOf(theirs) || !sameSurface(mapped(faces_, runs), mapped(faces, theirs))) return {};
  std::vector<int> vertexOfRun(countOf(theirs));
  for (int v = static_cast<int>(theirs.size()) - 1; v >= 0; --v) vertexOfRun[theirs[v]] = v;
  PoseMatch match;
  for (int run : runs) match.vertexOf.push_back(vertexOfRun[run]);
  return match;
}

std::optional<PoseMatch> PoseMatcher::byCorners(const std::vector<Triangle>& faces,
                                                std::span<const Positions* const> poses) const {
  if (!allFinite(positions_) || !std::all_of(poses.begin(), poses.end(), [](auto* p) { return allFinite(*p); }))
    return {};  // checking the keys reports the error
  const Positions* own[] = {&positions_};
  const Welding points = weldPoses(own), theirs = weldPoses(poses);
  const std::vector<int> vertexOf = cornersOf(faces);
  PoseMatch match;
  for (int corner : matchCorners(weldFaces(faces_, points), weldFaces(faces, theirs)))
    match.cornerOf.push_back(vertexOf[corner]);
  std::vector<int> ofMesh = cornersOf(weldFaces(faces_, points)), ofPose;
  for (int v : match.cornerOf) ofPose.push_back(theirs.weldedOfRaw[v]);
  if (!belongTogether(ofMesh, points.count, ofPose, theirs.count)) return {};
  if (nameWrongVertices(positions_, cornersOf(faces_), *poses[0], match.cornerOf)) return {};
  return match;
}

}  // namespace shapespline
