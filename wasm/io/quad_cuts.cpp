#include "io/quad_cuts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

namespace shapespline {

namespace {

using Quad = std::array<int, 4>;  // corners 3 f + c in cyclic order; the diagonal joins the first and third

int pointOf(const std::vector<Triangle>& faces, int corner) { return faces[corner / 3][corner % 3]; }

int nextCorner(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

// The quad of two triangles with a common edge, given a corner of f on that edge.
std::optional<Quad> quadOf(const std::vector<Triangle>& faces, int f, int g) {
  for (int a = 3 * f; a < 3 * f + 3; ++a)
    for (int b = 3 * g; b < 3 * g + 3; ++b) {
      const int c = nextCorner(a), d = nextCorner(b);
      if (pointOf(faces, a) == pointOf(faces, d) && pointOf(faces, c) == pointOf(faces, b))
        // f is a c e, g is b d h, with c = b and a = d: the quad is c e a h.
        return Quad{c, nextCorner(c), a, nextCorner(d)};
    }
  return {};
}

// How a pair of triangles cuts a quad: First is 0-1-2 and 0-2-3, Second is 0-1-3 and 1-2-3.
enum class Cut { None, First, Second };

Cut cutOf(const Triangle& f, const Triangle& g) {
  if (f[0] == g[0] && f[2] == g[1]) return Cut::First;
  if (f[1] == g[0] && f[2] == g[2]) return Cut::Second;
  return Cut::None;
}

// If the pose cuts a quad along the other diagonal, reorders its corners as in the mesh.
void turnUsualCuts(const std::vector<Triangle>& mesh, const std::vector<Triangle>& pose, std::vector<int>& corners) {
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

// Three numbers for sorted lists. They use the type of triangles, so one sort serves both.
using Entry = std::array<int, 3>;

// Both face lists, and the pose corner for each mesh corner as far as known.
struct Match {
  const std::vector<Triangle>&mesh, &pose;
  std::vector<int> corners;

  int meshPoint(int corner) const { return pointOf(mesh, corner); }
  int posePoint(int corner) const { return pointOf(pose, corners[corner]); }
  int cornerCount() const { return static_cast<int>(corners.size()); }
};

template <class EntryOf>
std::vector<Entry> sortedEntries(int count, EntryOf entryOf) {
  std::vector<Entry> entries(count);
  for (int i = 0; i < count; ++i) entries[i] = entryOf(i);
  std::sort(entries.begin(), entries.end());
  return entries;
}

// Votes of neighbouring faces for pairing a mesh point with a pose point.
class Votes {
 public:
  explicit Votes(const Match& match) : match_(match) {
    for (const Entry& entry :
         sortedEntries(match.cornerCount(), [&](int c) { return Entry{match.meshPoint(c), match.posePoint(c), 0}; })) {
      if (counts_.empty() || counts_.back()[0] != entry[0] || counts_.back()[1] != entry[1]) counts_.push_back(entry);
      ++counts_.back()[2];
    }
  }

  // Excludes the votes of faces f and g.
  int of(int corner, int stands, int f, int g) const {
    const int p = match_.meshPoint(corner), q = pointOf(match_.pose, stands);
    const auto it = std::lower_bound(counts_.begin(), counts_.end(), Entry{p, q, 0});
    if (it == counts_.end() || (*it)[0] != p || (*it)[1] != q) return 0;
    return (*it)[2] - saidBy(f, p, q) - (f != g ? saidBy(g, p, q) : 0);
  }

 private:
  int saidBy(int face, int p, int q) const {
    int count = 0;
    for (int c = 3 * face; c < 3 * face + 3; ++c) count += match_.meshPoint(c) == p && match_.posePoint(c) == q;
    return count;
  }

  const Match& match_;
  std::vector<Entry> counts_;  // count for each pair of points, sorted
};

// Marks the faces of all corners whose first number is paired with several second numbers.
void markSeveral(const std::vector<Entry>& entries, std::vector<bool>& disputed) {
  for (std::size_t from = 0, to = 0; from < entries.size(); from = to) {
    bool several = false;
    for (to = from; to < entries.size() && entries[to][0] == entries[from][0]; ++to)
      several |= entries[to][1] != entries[from][1];
    for (std::size_t i = from; i < to && several; ++i) disputed[entries[i][2] / 3] = true;
  }
}

// Faces with a corner whose point matches several points in the other list.
std::vector<bool> disputedFaces(const Match& match) {
  std::vector<bool> disputed(match.mesh.size(), false);
  const int n = match.cornerCount();
  markSeveral(sortedEntries(n, [&](int c) { return Entry{match.meshPoint(c), match.posePoint(c), c}; }), disputed);
  markSeveral(sortedEntries(n, [&](int c) { return Entry{match.posePoint(c), match.meshPoint(c), c}; }), disputed);
  return disputed;
}

struct QuadPair {
  int f, g;
  Quad mesh, pose;
};

// Pairs of disputed faces that form a quad in both lists.
std::vector<QuadPair> quadPairs(const Match& match, const std::vector<bool>& disputed) {
  const std::vector<Entry> sides = sortedEntries(match.cornerCount(), [&](int c) {
    const int a = match.meshPoint(c), b = match.meshPoint(nextCorner(c));
    return Entry{std::min(a, b), std::max(a, b), c / 3};
  });
  std::vector<QuadPair> out;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const int f = sides[i - 1][2], g = sides[i][2];
    const bool common = sides[i][0] == sides[i - 1][0] && sides[i][1] == sides[i - 1][1];
    if (!common || f == g || !disputed[f] || !disputed[g]) continue;
    const auto mesh = quadOf(match.mesh, f, g), pose = quadOf(match.pose, f, g);
    if (mesh && pose) out.push_back({f, g, *mesh, *pose});
  }
  return out;
}

// A new assignment of corners, and the number of faces gained in agreement.
struct Change {
  int gain;
  int f, g;
  std::array<std::pair<int, int>, 6> corners;
};

// The quad's points from another start, in the same cyclic order.
Change turnedQuad(const Match& match, const Votes& votes, const QuadPair& pair) {
  const auto& [f, g, mesh, pose] = pair;
  int now = 0, best = 0, turn = 0;
  for (int i = 0; i < 4; ++i) now += votes.of(mesh[i], match.corners[mesh[i]], f, g);
  for (int s = 0; s < 4; ++s) {
    int sum = 0;
    for (int i = 0; i < 4; ++i) sum += votes.of(mesh[i], pose[(i + s) % 4], f, g);
    if (sum > best) {
      best = sum;
      turn = s;
    }
  }
  Change change{best - now, f, g, {}};
  for (int k = 0; k < 6; ++k) {
    const int c = 3 * (k < 3 ? f : g) + k % 3;
    const auto at = std::find_if(mesh.begin(), mesh.end(),
                                 [&](int corner) { return match.meshPoint(corner) == match.meshPoint(c); });
    change.corners[k] = {c, pose[(at - mesh.begin() + turn) % 4]};
  }
  return change;
}

// One triangle, started at another corner.
Change turnedTriangle(const Match& match, const Votes& votes, int f) {
  int now = 0, best = 0, turn = 0;
  for (int c = 3 * f; c < 3 * f + 3; ++c) now += votes.of(c, match.corners[c], f, f);
  for (int s = 0; s < 3; ++s) {
    int sum = 0;
    for (int i = 0; i < 3; ++i) sum += votes.of(3 * f + i, 3 * f + (i + s) % 3, f, f);
    if (sum > best) {
      best = sum;
      turn = s;
    }
  }
  Change change{best - now, f, f, {}};
  for (int k = 0; k < 6; ++k) change.corners[k] = {3 * f + k % 3, 3 * f + (k + turn) % 3};
  return change;
}

// Applies changes with a gain, largest first, at most one per face.
bool make(const std::vector<Change>& changes, Match& match) {
  const std::vector<Entry> order =
      sortedEntries(static_cast<int>(changes.size()), [&](int i) { return Entry{-changes[i].gain, i, 0}; });
  std::vector<bool> changed(match.mesh.size(), false);
  bool any = false;
  for (const Entry& entry : order) {
    const Change& change = changes[entry[1]];
    if (change.gain <= 0) break;
    if (changed[change.f] || changed[change.g]) continue;
    changed[change.f] = changed[change.g] = any = true;
    for (const auto& [corner, stands] : change.corners) match.corners[corner] = stands;
  }
  return any;
}

// Runs one round. Returns false if no change gains agreement.
bool settle(Match& match) {
  const std::vector<bool> disputed = disputedFaces(match);
  const Votes votes(match);
  std::vector<Change> changes;
  for (const QuadPair& pair : quadPairs(match, disputed)) changes.push_back(turnedQuad(match, votes, pair));
  if (make(changes, match)) return true;
  changes.clear();
  for (int f = 0; f < static_cast<int>(match.mesh.size()); ++f)
    if (disputed[f]) changes.push_back(turnedTriangle(match, votes, f));
  return make(changes, match);
}

constexpr int rounds = 12;

}  // namespace

std::vector<int> matchCorners(const std::vector<Triangle>& mesh, const std::vector<Triangle>& pose) {
  Match match{mesh, pose, std::vector<int>(3 * mesh.size())};
  std::iota(match.corners.begin(), match.corners.end(), 0);
  turnUsualCuts(mesh, pose, match.corners);
  const std::vector<int> usual = match.corners;
  for (int round = 0; round < rounds && settle(match);) ++round;
  // If changes leave faces in disagreement, the mesh itself differs, not just its cuts.
  const std::vector<bool> disputed = disputedFaces(match);
  for (std::size_t c = 0; c < usual.size(); ++c)
    if (disputed[c / 3] && match.corners[c] != usual[c]) return usual;
  return std::move(match.corners);
}

}  // namespace shapespline
