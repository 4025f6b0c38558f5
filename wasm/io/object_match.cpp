#include "io/object_match.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/base/centroid.h"
#include "core/rotation/rigid_fit.h"
#include "io/pose_match.h"

namespace shapespline {

namespace {

// Limit of face comparisons when searching for similar objects, as a multiple of all faces. Bounds the cost of files
// with many unnamed objects.
constexpr std::int64_t maxComparisons = 40;
// Maximum number of similar objects to match by position, which takes quadratic time.
constexpr std::size_t maxMatched = 400;
// Maximum number of points per object for fitting a rigid motion.
constexpr std::size_t maxPoints = 64;

// Returns "Cube" for Blender's "Cube.001".
std::string_view withoutNumber(std::string_view name) {
  std::size_t end = name.size();
  while (end > 0 && name[end - 1] >= '0' && name[end - 1] <= '9') --end;
  return end > 1 && end < name.size() && name[end - 1] == '.' ? name.substr(0, end - 1) : name;
}

// Candidate names of an object, most specific first; empty strings for missing names.
constexpr int propertyNames = 5;
std::string nameOf(const ObjectFaces& object, int kind) {
  const std::string &node = object.nodeName, &mesh = object.meshName;
  const std::string& any = node.empty() ? mesh : node;
  switch (kind) {
    case 0: return node.empty() ? "" : object.path + node;
    case 1: return node;
    case 2: return mesh;
    case 3: return any;
    default: return std::string(withoutNumber(any));
  }
}

bool isNamed(const ObjectFaces& object) { return !object.nodeName.empty() || !object.meshName.empty(); }

// An object as a mesh with its own vertex numbers.
struct LocalMesh {
  std::vector<int> vertices;
  std::vector<Triangle> faces;
  Positions positions;

  LocalMesh() = default;
  LocalMesh(const ObjectMesh& mesh, int index) {
    const ObjectFaces& object = mesh.objects[index];
    faces.assign(mesh.faces.begin() + object.start, mesh.faces.begin() + object.start + object.count);
    for (const Triangle& face : faces) vertices.insert(vertices.end(), face.begin(), face.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (Triangle& face : faces)
      for (int& v : face)
        v = static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    for (int v : vertices) positions.push_back(mesh.positions[v]);
  }
};

struct Placement {
  Mat3 rotation = Mat3::Identity();
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // centre before and after the motion

  Vec3 operator()(const Vec3& p) const { return rotation * (p - from) + to; }
};

using Pairs = std::vector<std::pair<int, int>>;

struct Matcher {
  const ObjectMesh& first;
  const ObjectMesh& other;
  ObjectMatch out{};
  std::vector<char> unsure{}, otherUnsure{};        // objects with names that may mean another object in the other pose
  std::vector<char> taken{};                        // whether each object of the other pose is matched
  std::vector<LocalMesh> firstMesh{}, otherMesh{};  // filled on demand
  std::int64_t room = 0;                            // remaining number of face comparisons

  bool isOpen(int i) const { return out.otherOf[i] < 0; }

  void match(int i, int j, MatchRule rule) {
    out.otherOf[i] = j;
    out.rule[i] = rule;
    taken[j] = 1;
  }

  std::vector<int> openFirst() const {
    std::vector<int> open;
    for (std::size_t i = 0; i < out.otherOf.size(); ++i)
      if (isOpen(static_cast<int>(i))) open.push_back(static_cast<int>(i));
    return open;
  }

  std::vector<int> openOther() const {
    std::vector<int> open;
    for (std::size_t j = 0; j < taken.size(); ++j)
      if (!taken[j]) open.push_back(static_cast<int>(j));
    return open;
  }

  // Matching by name.

  void mistrust(int i, int j) { unsure[i] = otherUnsure[j] = 1; }

  using ByName = std::map<std::string, std::vector<int>>;

  static ByName byName(const std::vector<ObjectFaces>& objects, const std::vector<int>& open, int kind) {
    ByName out;
    for (int i : open)
      if (std::string name = nameOf(objects[i], kind); !name.empty()) out[std::move(name)].push_back(i);
    return out;
  }

  void matchNames(int kind) {
    const ByName ours = byName(first.objects, openFirst(), kind), theirs = byName(other.objects, openOther(), kind);
    for (const auto& [name, mine] : ours) {
      const auto found = theirs.find(name);
      if (found == theirs.end() || mine.size() > 1 || found->second.size() > 1) continue;
      const int i = mine[0], j = found->second[0];
      if (first.objects[i].count == other.objects[j].count) match(i, j, MatchRule::Name);
      else mistrust(i, j);
    }
  }

  // Objects with equal names are distinguished by shape only.
  void matchWithinNames(int kind) {
    const ByName ours = byName(first.objects, openFirst(), kind), theirs = byName(other.objects, openOther(), kind);
    for (const auto& [name, mine] : ours)
      if (const auto found = theirs.find(name); found != theirs.end()) matchShapes(mine, found->second);
  }

  // Matching by shape.

  const LocalMesh& meshOf(std::vector<LocalMesh>& meshes, const ObjectMesh& whole, int index) {
    meshes.resize(whole.objects.size());
    if (meshes[index].faces.empty()) meshes[index] = LocalMesh(whole, index);
    return meshes[index];
  }
  const LocalMesh& ours(int i) { return meshOf(firstMesh, first, i); }
  const LocalMesh& theirs(int j) { return meshOf(otherMesh, other, j); }

  bool areAlike(const LocalMesh& a, const LocalMesh& b) {
    if (--room < 0 || a.faces.size() != b.faces.size() || a.faces.empty()) return false;
    room -= static_cast<std::int64_t>(a.faces.size());
    if (a.positions.size() == b.positions.size() && a.faces == b.faces) return true;
    room -= 9 * static_cast<std::int64_t>(a.faces.size());
    const Positions* pose = &b.positions;
    return PoseMatcher(a.faces, a.positions).find(b.faces, {&pose, 1}).has_value();
  }

  // Similar objects of both poses.
  struct Class {
    std::vector<int> mine, others;
  };

  std::vector<Class> classesOf(const std::vector<int>& mine, const std::vector<int>& others) {
    std::vector<Class> classes;
    for (int i : mine) {
      if (room < 0) return classes;
      const auto same = std::find_if(classes.begin(), classes.end(),
                                     [&](const Class& c) { return areAlike(ours(c.mine[0]), ours(i)); });
      if (same == classes.end()) classes.push_back({{i}, {}});
      else same->mine.push_back(i);
    }
    for (int j : others) {
      if (room < 0) return classes;
      const auto same = std::find_if(classes.begin(), classes.end(),
                                     [&](const Class& c) { return areAlike(ours(c.mine[0]), theirs(j)); });
      if (same != classes.end()) same->others.push_back(j);
    }
    return classes;
  }

  void matchShapes(const std::vector<int>& mine, const std::vector<int>& others) {
    std::vector<Class> classes = classesOf(mine, others);
    std::erase_if(classes, [](const Class& c) { return c.others.empty(); });
    for (const Class& c : classes)
      if (c.mine.size() == 1 && c.others.size() == 1) match(c.mine[0], c.others[0], MatchRule::Shape);
    for (const Class& c : classes)
      if (c.mine.size() > 1 || c.others.size() > 1) matchByPlace(c);
  }

  // Matching similar objects by position.

  // Adds corresponding points of both objects. Uses the centres alone if the files number their vertices differently.
  void addPoints(int i, int j, Positions& from, Positions& to) {
    const LocalMesh &a = ours(i), &b = theirs(j);
    if (a.faces != b.faces) {
      from.push_back(centroidOf(a.positions));
      to.push_back(centroidOf(b.positions));
      return;
    }
    const std::size_t step = a.positions.size() / maxPoints + 1;
    for (std::size_t v = 0; v < a.positions.size(); v += step) {
      from.push_back(a.positions[v]);
      to.push_back(b.positions[v]);
    }
  }

  Placement placementOf(const Pairs& pairs) {
    Positions from, to;
    for (const auto& [i, j] : pairs) addPoints(i, j, from, to);
    Placement out{Mat3::Identity(), centroidOf(from), centroidOf(to)};
    if (from.size() >= 3) out.rotation = fitRigid(from, to).rotation;
    return out;
  }

  // Mean squared distance of the pairs from a common rigid motion.
  double strainOf(const Pairs& pairs) {
    Positions from, to;
    for (const auto& [i, j] : pairs) addPoints(i, j, from, to);
    const Placement place = placementOf(pairs);
    double sum = 0;
    for (std::size_t v = 0; v < from.size(); ++v) sum += (place(from[v]) - to[v]).squaredNorm();
    return sum / static_cast<double>(from.size());
  }

  // Pairs each object with the nearest one after the motion.
  Pairs nearest(const Class& c, const Placement& place) {
    std::vector<std::tuple<double, int, int>> distances;
    for (int i : c.mine) {
      const Vec3 at = place(centroidOf(ours(i).positions));
      for (int j : c.others) distances.emplace_back((at - centroidOf(theirs(j).positions)).squaredNorm(), i, j);
    }
    std::sort(distances.begin(), distances.end());
    Pairs pairs;
    std::vector<char> hasOther(first.objects.size(), 0), isTaken(other.objects.size(), 0);
    for (const auto& [distance, i, j] : distances) {
      if (hasOther[i] || isTaken[j]) continue;
      hasOther[i] = isTaken[j] = 1;
      pairs.emplace_back(i, j);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Pairs inOrder(const Class& c) const {
    Pairs pairs;
    for (std::size_t k = 0; k < std::min(c.mine.size(), c.others.size()); ++k)
      pairs.emplace_back(c.mine[k], c.others[k]);
    return pairs;
  }

  // Candidate motions for the class: the motion of matched objects, of the class centre, of its first object.
  std::vector<Placement> placementsOf(const Class& c) {
    constexpr std::size_t maxTries = 8;
    std::vector<Placement> places;
    Pairs matched;
    for (std::size_t i = 0; i < out.otherOf.size() && matched.size() < maxMatched; ++i)
      if (out.otherOf[i] >= 0) matched.emplace_back(static_cast<int>(i), out.otherOf[i]);
    if (!matched.empty()) places.push_back(placementOf(matched));
    Placement centre;
    for (int i : c.mine) centre.from += centroidOf(ours(i).positions) / static_cast<double>(c.mine.size());
    for (int j : c.others) centre.to += centroidOf(theirs(j).positions) / static_cast<double>(c.others.size());
    places.push_back(centre);
    for (std::size_t k = 0; k < c.others.size() && k < maxTries; ++k)
      places.push_back(placementOf({{c.mine[0], c.others[k]}}));
    return places;
  }

  void matchByPlace(const Class& c) {
    const Pairs order = inOrder(c);
    MatchRule rule = MatchRule::Order;
    Pairs best = order;
    if (c.mine.size() <= maxMatched && c.others.size() <= maxMatched) {
      // File order may be random, so a different order must fit the poses clearly better.
      const bool sameCount = c.mine.size() == c.others.size();
      double least = sameCount ? strainOf(order) : std::numeric_limits<double>::infinity();
      double limit = 0.5 * least;
      for (const Placement& place : placementsOf(c)) {
        const Pairs pairs = nearest(c, place);
        const double strain = strainOf(pairs);
        if (pairs == order) rule = best == order ? MatchRule::Shape : rule;
        if (!(strain < limit)) continue;
        best = pairs;
        limit = strain;
        rule = MatchRule::Shape;
      }
    }
    for (const auto& [i, j] : best) match(i, j, rule);
  }

  // Generated names such as Cube.001 may denote a different object in each file, unless the files agree on the order.
  void checkNames() {
    if (out.isInOrder()) return;
    for (std::size_t i = 0; i < out.otherOf.size(); ++i) {
      const int j = out.otherOf[i];
      if (j < 0 || areAlike(ours(static_cast<int>(i)), theirs(j)) || room < 0) continue;
      out.otherOf[i] = -1;
      out.rule[i] = MatchRule::Order;
      taken[j] = 0;
      mistrust(static_cast<int>(i), j);
    }
  }

  // If both poses have the same number of unmatched objects, these were renamed. Otherwise, if some names match,
  // objects with different names are different, even if they are similar.
  void matchRest() {
    const bool namesTell = std::find(out.rule.begin(), out.rule.end(), MatchRule::Name) != out.rule.end();
    std::vector<int> mine = openFirst(), others = openOther();
    if (!namesTell || mine.size() == others.size()) return matchShapes(mine, others);
    std::erase_if(mine, [&](int i) { return isNamed(first.objects[i]) && !unsure[i]; });
    std::erase_if(others, [&](int j) { return isNamed(other.objects[j]) && !otherUnsure[j]; });
    matchShapes(mine, openOther());
    std::erase_if(others, [&](int j) { return taken[j]; });
    matchShapes(openFirst(), others);
  }

  ObjectMatch run() {
    out.otherOf.assign(first.objects.size(), -1);
    out.rule.assign(first.objects.size(), MatchRule::Order);
    taken.assign(other.objects.size(), 0);
    unsure.assign(first.objects.size(), 0);
    otherUnsure.assign(other.objects.size(), 0);
    room = maxComparisons * static_cast<std::int64_t>(first.faces.size() + other.faces.size());
    for (int kind = 0; kind < propertyNames; ++kind) matchNames(kind);
    checkNames();
    if (first.objects.size() == 1 && other.objects.size() == 1 && isOpen(0)) match(0, 0, MatchRule::Order);
    for (int kind = 0; kind < propertyNames; ++kind) matchWithinNames(kind);
    matchRest();
    out.extra = static_cast<int>(std::count(taken.begin(), taken.end(), 0));
    return std::move(out);
  }
};

}  // namespace

bool ObjectMesh::isWhole() const {
  int next = 0;
  for (const ObjectFaces& object : objects) {
    if (object.start != next || object.count < 0) return false;
    next += object.count;
  }
  return !objects.empty() && next == static_cast<int>(faces.size());
}

bool ObjectMatch::isComplete() const {
  return std::none_of(otherOf.begin(), otherOf.end(), [](int other) { return other < 0; });
}

bool ObjectMatch::namesMoveObjects() const {
  for (std::size_t i = 0; i < otherOf.size(); ++i)
    if (otherOf[i] >= 0 && otherOf[i] != static_cast<int>(i) && rule[i] == MatchRule::Name) return true;
  return false;
}

bool ObjectMatch::isInOrder() const {
  for (std::size_t i = 0; i < otherOf.size(); ++i)
    if (otherOf[i] != static_cast<int>(i)) return false;
  return extra == 0;
}

ObjectMatch matchObjects(const ObjectMesh& first, const ObjectMesh& other) { return Matcher{first, other}.run(); }

}  // namespace shapespline
