#include "io/pose_match.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/mesh/same_surface.h"

namespace shapespline {

namespace {

// Of each vertex the run that it belongs to: vertices that follow each other at the same place in all poses.
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

// How two triangles that follow each other share a side: 0-1-2 and 0-2-3 of a quad, 0-1-3 and 1-2-3 of it, or neither.
enum class Cut { None, First, Second };

Cut cutOf(const Triangle& f, const Triangle& g) {
  if (f[0] == g[0] && f[2] == g[1]) return Cut::First;
  if (f[1] == g[0] && f[2] == g[2]) return Cut::Second;
  return Cut::None;
}

// Where the pose cuts a quad the other way than the mesh, its corners take the mesh's order. Both in points.
void turnDiagonals(const std::vector<Triangle>& mesh, const std::vector<Triangle>& pose, std::vector<int>& corners) {
  for (std::size_t f = 0; f + 1 < mesh.size(); ++f) {
    const Cut wanted = cutOf(mesh[f], mesh[f + 1]), given = cutOf(pose[f], pose[f + 1]);
    if (wanted == Cut::None || given == Cut::None || wanted == given) continue;
    int* c = &corners[3 * f];
    if (wanted == Cut::First) {
      const int quad[] = {c[0], c[1], c[4], c[2]};
      for (const auto& [at, of] : {std::pair{2, 2}, {3, 0}, {4, 2}, {5, 3}}) c[at] = quad[of];
    } else {
      const int quad[] = {c[0], c[1], c[2], c[5]};
      for (const auto& [at, of] : {std::pair{2, 3}, {3, 1}, {4, 2}, {5, 3}}) c[at] = quad[of];
    }
    ++f;
  }
}

bool allFinite(const Positions& pose) {
  return std::all_of(pose.begin(), pose.end(), [](const Vec3& p) { return p.allFinite(); });
}

// Whether the corners of two lists tell one surface's vertices. A point of one list may be several of the other, where
// the shape touches itself; but not where these are several points of the first in their turn: they belong together
// by chance then.
bool belongTogether(const std::vector<int>& a, int countA, const std::vector<int>& b, int countB) {
  std::vector<std::pair<int, int>> pairs(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) pairs[c] = {a[c], b[c]};
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<int> ofA(countA, 0), ofB(countB, 0);
  for (const auto& [pointA, pointB] : pairs) ++ofA[pointA], ++ofB[pointB];
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return ofA[pair.first] == 1 || ofB[pair.second] == 1; });
}

// What the sides of the faces differ from those of the mesh, squared and added up.
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

// Faces that name wrong vertices, each another one, tell their corners as those of a mesh in another order do; but the
// pose is the mesh's with the mesh's own faces then, and torn to pieces with these.
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
  if (poses[0]->size() == positions_.size() && sameSurface(faces_, faces)) {
    PoseMatch same;
    same.vertexOf.resize(positions_.size());
    std::iota(same.vertexOf.begin(), same.vertexOf.end(), 0);
    return same;
  }
  if (auto match = byCopies(faces, poses)) return match;
  return byCorners(faces, poses);
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
    return {};  // said where keys are checked
  const Positions* own[] = {&positions_};
  const Welding points = weldPoses(own), theirs = weldPoses(poses);
  PoseMatch match{{}, cornersOf(faces)};
  turnDiagonals(weldFaces(faces_, points), weldFaces(faces, theirs), match.cornerOf);
  std::vector<int> ofMesh = cornersOf(weldFaces(faces_, points)), ofPose;
  for (int v : match.cornerOf) ofPose.push_back(theirs.weldedOfRaw[v]);
  if (!belongTogether(ofMesh, points.count, ofPose, theirs.count)) return {};
  if (nameWrongVertices(positions_, cornersOf(faces_), *poses[0], match.cornerOf)) return {};
  return match;
}

}  // namespace shapespline
