#include "io/join_keys.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/format.h"
#include "io/base/objects.h"
#include "io/object_match.h"
#include "io/pose_match.h"

namespace shapespline {

namespace {

std::vector<const Positions*> posesOf(const std::vector<Key>& keys) {
  std::vector<const Positions*> poses;
  for (const Key& key : keys) poses.push_back(&key.positions);
  return poses;
}

// Splits of mesh vertices that a pose has at several positions: n + i becomes a copy of vertex copyOf[i].
struct Split {
  std::vector<int> copyOf;
  std::vector<Triangle> faces;
  std::vector<int> vertexOf;  // pose vertex of each of the n vertices and copies; -1 if no face decides
};

Split splitBy(const std::vector<int>& cornerOf, const Welding& points, const std::vector<Triangle>& faces, int n) {
  Split out{{}, faces, std::vector<int>(n, -1)};
  std::map<std::pair<int, int>, int> copyAt;  // copies of a vertex by position
  for (std::size_t corner = 0; corner < cornerOf.size(); ++corner) {
    int& v = out.faces[corner / 3][corner % 3];
    const int there = cornerOf[corner], point = points.weldedOfRaw[there];
    if (out.vertexOf[v] < 0) out.vertexOf[v] = there;
    if (points.weldedOfRaw[out.vertexOf[v]] == point) continue;
    const auto [copy, isNew] = copyAt.try_emplace({v, point}, n + static_cast<int>(out.copyOf.size()));
    if (isNew) {
      out.copyOf.push_back(v);
      out.vertexOf.push_back(there);
    }
    v = copy->second;
  }
  return out;
}

template <class T>
void appendCopies(const std::vector<int>& copyOf, std::size_t width, std::size_t at, std::vector<T>& values) {
  if (values.empty()) return;
  std::vector<T> copies;
  for (int v : copyOf) copies.insert(copies.end(), &values[width * v], &values[width * v] + width);
  values.insert(values.begin() + static_cast<std::ptrdiff_t>(width * at), copies.begin(), copies.end());
}

// Drawn vertices are the mesh vertices, followed by the copies (Seams::copyOf). Splitting adds mesh vertices, so the
// copies' indices shift. If a copied vertex is split, each new vertex gets its own copy.
void splitSeams(const Split& split, int n, const std::vector<Triangle>& before, Scene& scene) {
  Seams& seams = scene.seams;
  const int more = static_cast<int>(split.copyOf.size());
  appendCopies(split.copyOf, 2, n, scene.uvs);
  if (seams.copyOf.empty()) return;
  std::map<std::pair<int, int>, int> copyAt;  // drawn copy for a pair (drawn vertex, mesh vertex)
  for (std::size_t f = 0; f < seams.faces.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      int& drawn = seams.faces[f][c];
      const int vertex = split.faces[f][c];
      if (drawn < n) {
        drawn = vertex;
        continue;
      }
      drawn += more;
      if (vertex == before[f][c]) continue;
      const auto [copy, isNew] = copyAt.try_emplace({drawn, vertex}, n + more + static_cast<int>(seams.copyOf.size()));
      if (isNew) {
        seams.copyOf.push_back(vertex);
        for (int i = 0; i < 2 && !scene.uvs.empty(); ++i) scene.uvs.push_back(scene.uvs[2 * drawn + i]);
      }
      drawn = copy->second;
    }
}

void splitVertices(Split& split, Import& import) {
  const int n = import.keyframes.vertexCount();
  for (Key& key : import.keyframes.keys) appendCopies(split.copyOf, 1, n, key.positions);
  appendCopies(split.copyOf, 1, n, import.keyframes.normals);
  appendCopies(split.copyOf, 4, n, import.scene.colors);
  splitSeams(split, n, import.keyframes.faces, import.scene);
  import.keyframes.faces = std::move(split.faces);
}

Warning splitWarning(const std::string& name, int count, int key) {
  const std::string vertices =
      count == 1 ? "one vertex of the first pose has" : grouped(count) + " vertices of the first pose have";
  return {"split-vertices",
          "(" + name + "): " + vertices +
              " more than one position in this pose, so the surface opens. If that is not "
              "intended, weld the mesh before posing it.",
          count,
          key,
          -1,
          {},
          "Key"};
}

// A mesh with vertices ordered by object, for comparison with another file.
struct Arranged {
  std::vector<Triangle> faces;
  std::vector<int> vertexAt;  // file index of each vertex
  std::vector<Positions> poses;

  std::vector<const Positions*> posePointers() const {
    std::vector<const Positions*> out;
    for (const Positions& pose : poses) out.push_back(&pose);
    return out;
  }
};

// `order`: indices of the objects. Vertices of other objects are omitted; vertices without faces come last.
Arranged arranged(const std::vector<Triangle>& faces, const std::vector<ObjectFaces>& objects,
                  const std::vector<int>& order, std::span<const Positions* const> poses) {
  Arranged out;
  constexpr int unused = -2, open = -1;
  std::vector<int> number(poses[0]->size(), unused);
  for (const Triangle& face : faces)
    for (int v : face) number[v] = open;
  const auto append = [&](int v) {
    number[v] = static_cast<int>(out.vertexAt.size());
    out.vertexAt.push_back(v);
  };
  for (int index : order) {
    const ObjectFaces& object = objects[index];
    const auto first = faces.begin() + object.start, last = first + object.count;
    std::vector<int> vertices;
    for (auto face = first; face != last; ++face)
      for (int v : *face)
        if (number[v] == open) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    for (int v : vertices)
      if (number[v] == open) append(v);
    for (auto face = first; face != last; ++face)
      out.faces.push_back({number[(*face)[0]], number[(*face)[1]], number[(*face)[2]]});
  }
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == unused) append(static_cast<int>(v));
  for (const Positions* pose : poses) {
    Positions& positions = out.poses.emplace_back();
    for (int v : out.vertexAt) positions.push_back((*pose)[v]);
  }
  return out;
}

// Matches poses whose objects come in different orders. The result uses the files' own vertex numbers.
std::optional<PoseMatch> findArranged(const ObjectMesh& firstMesh, const ObjectMesh& otherMesh, const ObjectMatch& same,
                                      std::span<const Positions* const> poses) {
  std::vector<int> own(firstMesh.objects.size());
  std::iota(own.begin(), own.end(), 0);
  const Positions* pose = &firstMesh.positions;
  const Arranged first = arranged(firstMesh.faces, firstMesh.objects, own, {&pose, 1});
  const Arranged other = arranged(otherMesh.faces, otherMesh.objects, same.otherOf, poses);
  auto match = PoseMatcher(first.faces, first.poses[0]).find(other.faces, other.posePointers());
  if (!match) return match;
  PoseMatch out;
  out.vertexOf.resize(match->vertexOf.empty() ? 0 : first.vertexAt.size());
  for (std::size_t v = 0; v < match->vertexOf.size(); ++v)
    out.vertexOf[first.vertexAt[v]] = other.vertexAt[match->vertexOf[v]];
  for (int v : match->cornerOf) out.cornerOf.push_back(other.vertexAt[v]);
  return out;
}

// Error for equal vertex and face counts whose objects do not match by name.
Error otherObjects(const std::string& where, int key) {
  return {ErrorCode::FaceMismatch,
          where + ": objects of the same name have different faces than in key 1. Use poses of one mesh.", key};
}

}  // namespace

Warning leftOutWarning(const std::vector<std::string>& taken, int count) {
  return {"left-out-objects",
          "Not every file has the same objects. Only those that all files share are used: " + objectList(taken) + ".",
          count};
}

Status KeyJoiner::add(const std::vector<Triangle>& faces, std::vector<Key> added, const std::string& where,
                      const std::vector<ObjectFaces>& objects) {
  Keyframes& k = import_.keyframes;
  const int key = k.keyCount(), n = k.vertexCount();
  const std::vector<const Positions*> poses = posesOf(added);
  const ObjectMesh first{import_.scene.objects, k.faces, k.keys[0].positions}, other{objects, faces, *poses[0]};
  ObjectMatch same;
  if (first.isWhole() && other.isWhole()) same = matchObjects(first, other);
  if (!same.otherOf.empty() && !same.isComplete() && same.namesMoveObjects()) return otherObjects(where, key);
  const bool isArranged = !same.otherOf.empty() && same.isComplete() && !same.isInOrder();
  const auto match = isArranged ? findArranged(first, other, same, poses)
                                : PoseMatcher(k.faces, k.keys[0].positions).find(faces, poses);
  if (!match && poses[0]->size() != k.keys[0].positions.size())
    return vertexCountMismatch(where, key, poses[0]->size(), k.keys[0].positions.size());
  if (!match) {
    const Status sameFaces = compareFaces(k.faces, faces, key, where);
    return sameFaces ? otherObjects(where, key) : sameFaces;
  }
  if (isArranged && same.extra > 0) warnOfExtra(same.extra);
  addMatches(same, objects, key);

  std::vector<int> vertexOf = match->vertexOf;
  if (!match->cornerOf.empty()) {
    Split split = splitBy(match->cornerOf, weldPoses(poses), k.faces, n);
    if (!split.copyOf.empty()) {
      import_.warnings.push_back(splitWarning(added[0].name, static_cast<int>(split.copyOf.size()), key));
      splitVertices(split, import_);
    }
    vertexOf = std::move(split.vertexOf);
  }
  for (Key& one : added) {
    Positions positions(vertexOf.size());
    for (std::size_t v = 0; v < vertexOf.size(); ++v)
      // Vertices without faces stay in place.
      positions[v] = vertexOf[v] < 0 ? k.keys[0].positions[v] : one.positions[vertexOf[v]];
    k.keys.push_back({std::move(one.name), one.time, std::move(positions)});
  }
  return {};
}

void KeyJoiner::warnOfExtra(int count) {
  for (const Warning& warning : import_.warnings)
    if (warning.code == "left-out-objects") return;
  std::vector<std::string> names;
  for (const ObjectFaces& object : import_.scene.objects) addObject(object.name, names);
  import_.warnings.push_back(leftOutWarning(names, count));
}

void KeyJoiner::addMatches(const ObjectMatch& same, const std::vector<ObjectFaces>& objects, int key) {
  for (std::size_t i = 0; same.isComplete() && i < same.otherOf.size(); ++i)
    if (import_.matches.size() < maxObjects)
      import_.matches.push_back({key, import_.scene.objects[i].name, objects[same.otherOf[i]].name, same.rule[i]});
}

}  // namespace shapespline
