// The order of vertices and faces in the file, and the first corner of a face, must not affect the result.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/mesh/canonical_order.h"
#include "core/rotation/rigid_fit.h"
#include "real_data.h"
#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::canonical_order_test {

namespace {

/// Keys with renumbered vertices and faces.
struct Shuffled {
  Keyframes keyframes;
  std::vector<int> vertex, face;  ///< old index of each new one
};

Shuffled shuffled(const Keyframes& k, std::uint32_t seed) {
  std::mt19937 random(seed);
  Shuffled out{{}, std::vector<int>(k.vertexCount()), std::vector<int>(k.faceCount())};
  std::iota(out.vertex.begin(), out.vertex.end(), 0);
  std::iota(out.face.begin(), out.face.end(), 0);
  std::shuffle(out.vertex.begin(), out.vertex.end(), random);
  std::shuffle(out.face.begin(), out.face.end(), random);
  std::vector<int> number(out.vertex.size());
  for (std::size_t v = 0; v < number.size(); ++v) number[out.vertex[v]] = static_cast<int>(v);
  for (int f : out.face) {
    Triangle t;
    for (int c = 0; c < 3; ++c) t[c] = number[k.faces[f][c]];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    out.keyframes.faces.push_back(t);
  }
  for (const Key& key : k.keys) {
    out.keyframes.keys.push_back({key.name, key.time, {}});
    for (int v : out.vertex) out.keyframes.keys.back().positions.push_back(key.positions[v]);
  }
  if (!k.normals.empty())
    for (int v : out.vertex) out.keyframes.normals.push_back(k.normals[v]);
  return out;
}

std::vector<Positions> posesOf(const Keyframes& k) {
  std::vector<Positions> poses;
  for (const Key& key : k.keys) poses.push_back(key.positions);
  return poses;
}

/// Removes all symmetry.
Positions bumpy(const Positions& positions, double size = 0.03) {
  return mapped(positions, [=](const Vec3& p) -> Vec3 {
    const Vec3 bump(std::sin(3 * p.y() + p.z()), std::cos(2 * p.x() - 1.3 * p.z()),
                    std::sin(1.7 * p.x() + 2.1 * p.y() + 0.4 * p.z()));
    return p + size * bump;
  });
}

/// A bent bar with a few openings and with cuts along seams whose copies coincide, next to two different balls.
Keyframes severalParts() {
  Shape shape =
      joined(joined(box(1, 1, 10, 3, 4, 30), sphere({1.3, 0.1, 4}, 0.4, 8, 11)), sphere({0.2, 1.4, 8}, 0.3, 7, 9));
  shape.faces.erase(shape.faces.begin() + 100, shape.faces.begin() + 106);
  for (int f = 300; f < 420; ++f)
    for (int& v : shape.faces[f]) {
      shape.positions.push_back(shape.positions[v]);
      v = static_cast<int>(shape.positions.size()) - 1;
    }
  shape.positions = bumpy(shape.positions);
  return keyframes(
      shape, {bend(0), bend(radians(70)), [](const Vec3& p) { return bend(radians(-40))(twist(radians(60))(p)); }});
}

void checkSameMesh(const Keyframes& k, std::uint32_t seed) {
  const Shuffled other = shuffled(k, seed);
  const MeshOrder a = canonicalOrder(k.faces, posesOf(k)),
                  b = canonicalOrder(other.keyframes.faces, posesOf(other.keyframes));
  CHECK(a.apply(k.faces) == b.apply(other.keyframes.faces));
  for (int j = 0; j < k.keyCount(); ++j)
    CHECK(a.apply(k.keys[j].positions) == b.apply(other.keyframes.keys[j].positions));
}

/// Evaluates both keyframes and compares every vertex and the patches.
void checkSameMotion(const Keyframes& k, std::uint32_t seed, const EncodingOptions& encoding) {
  const Shuffled other = shuffled(k, seed);
  Sequence a = sequenceOf(k, encoding), b = sequenceOf(other.keyframes, encoding);
  std::vector<int> patches;
  for (int f : other.face) patches.push_back(a.encoded().lri().patchOfInputFace()[f]);
  CHECK(patches == b.encoded().lri().patchOfInputFace());
  double largest = 0;
  const double start = k.keys.front().time, span = k.keys.back().time - start;
  for (double s = -0.4; s <= 1.4; s += 0.045) {
    const Positions x = shapeAt(a, start + s * span), y = shapeAt(b, start + s * span);
    for (std::size_t v = 0; v < y.size(); ++v) largest = std::max(largest, (x[other.vertex[v]] - y[v]).norm());
  }
  CHECK(largest < 1e-6 * diagonalOf(k));
  if (encoding.ghostFaces == 0) return;
  CHECK(a.stats().ghostFaces == b.stats().ghostFaces);
  std::vector<int> follows;
  for (int f : other.face) follows.push_back(a.encoded().lri().ghost().ghostFaceOf[f]);
  CHECK(follows == b.encoded().lri().ghost().ghostFaceOf);
  CHECK(a.encoded().lri().ghost().faces == b.encoded().lri().ghost().faces);
  for (std::size_t g = 0; g < b.encoded().lri().ghost().vertexOf.size(); ++g)
    CHECK(k.keys[0].positions[a.encoded().lri().ghost().vertexOf[g]] ==
          other.keyframes.keys[0].positions[b.encoded().lri().ghost().vertexOf[g]]);
}

EncodingOptions withGhost(int faces) {
  EncodingOptions options = doublePrecision();
  options.ghostFaces = faces;
  return options;
}

}  // namespace

TEST_CASE("every face and vertex is numbered once, with close numbers for neighbours") {
  const Keyframes k = severalParts();
  const MeshOrder order = canonicalOrder(k.faces, posesOf(k));
  std::vector<int> vertices = order.vertex, faces = order.oldFaces(), all(k.faceCount());
  std::iota(all.begin(), all.end(), 0);
  std::sort(faces.begin(), faces.end());
  CHECK(faces == all);
  std::sort(vertices.begin(), vertices.end());
  all.resize(k.vertexCount());
  std::iota(all.begin(), all.end(), 0);
  CHECK(vertices == all);
  const std::vector<Triangle> ordered = order.apply(k.faces);
  for (std::size_t f = 0; f < ordered.size(); ++f) {
    Triangle old = k.faces[order.corner[f] / 3];
    std::rotate(old.begin(), old.begin() + order.corner[f] % 3, old.end());
    for (int c = 0; c < 3; ++c) CHECK(order.vertex[ordered[f][c]] == old[c]);
  }
  const Shuffled other = shuffled(keyframes({bumpy(bar().positions), bar().faces}, {bend(0), bend(1)}), 1);
  int farthest = 0;
  for (const Triangle& t : canonicalOrder(other.keyframes.faces, posesOf(other.keyframes)).apply(other.keyframes.faces))
    farthest = std::max(farthest, *std::max_element(t.begin(), t.end()) - *std::min_element(t.begin(), t.end()));
  CHECK(farthest < 60);  // there are 674 vertices; a ring around the bar has 16
}

TEST_CASE("a mesh of any kind has one order, independent of the file's") {
  Keyframes parts = severalParts();
  for (std::uint32_t seed = 1; seed <= 5; ++seed) checkSameMesh(parts, seed);

  // Fins at a common edge, faces without area, a part with opposite winding, unused vertices.
  Shape odd = box(1, 2, 3, 2, 3, 4);
  odd.positions = bumpy(odd.positions, 0.1);
  const Triangle side = odd.faces[7];
  for (int i = 0; i < 4; ++i) {
    odd.positions.emplace_back(1 + 0.3 * i, 2 - 0.5 * i, 0.1 * i * i);
    const int tip = static_cast<int>(odd.positions.size()) - 1;
    odd.faces.push_back(i % 2 ? Triangle{side[0], side[1], tip} : Triangle{side[1], side[0], tip});
  }
  odd.faces.push_back({side[0], side[0], side[2]});
  odd.faces.push_back({side[1], side[2], side[2]});
  odd.faces.push_back({side[1], side[1], side[1]});
  for (int f = 20; f < 30; ++f) std::swap(odd.faces[f][0], odd.faces[f][1]);
  for (std::uint32_t seed = 1; seed <= 5; ++seed) checkSameMesh(keyframes(odd, {bend(0), bend(0.3), twist(1)}), seed);
}

TEST_CASE("parts that differ only in faces far from the first are distinguished") {
  Shape part = box(1, 1, 3, 3, 3, 8);
  part.positions = mapped(bumpy(part.positions), [](const Vec3& p) -> Vec3 { return p + Vec3(2, 1, 0); });
  Shape other = part;
  other.positions = mapped(part.positions, [](const Vec3& p) -> Vec3 { return {-p.x(), -p.y(), p.z()}; });
  const Triangle a = other.faces[20],
                 b = other.faces[21];  // (0, 1, 2) and (0, 2, 3), or (0, 1, 3) and (1, 2, 3): the other diagonal
  const bool fromFirst = a[0] == b[0];
  const int q[] = {a[0], a[1], fromFirst ? a[2] : b[1], fromFirst ? b[2] : a[2]};
  other.faces[20] = fromFirst ? Triangle{q[0], q[1], q[3]} : Triangle{q[0], q[1], q[2]};
  other.faces[21] = fromFirst ? Triangle{q[1], q[2], q[3]} : Triangle{q[0], q[2], q[3]};
  for (std::uint32_t seed = 1; seed <= 5; ++seed)
    checkSameMesh(keyframes(joined(part, other), {turn(Vec3::UnitX(), 0), turn(Vec3(1, 2, 3), 1)}), seed);
}

TEST_CASE("a symmetric shape is also ordered, up to its symmetry") {
  // A rotation by 15 degrees about its axis maps a ball to itself, but the second key distinguishes its poles.
  const Shape ball = sphere({0, 0, 0}, 1, 16, 24);
  const Map stretched = [](const Vec3& p) -> Vec3 { return {p.x(), p.y(), p.z() * (p.z() > 0 ? 2 : 1)}; };
  const Keyframes k = keyframes(ball, {turn(Vec3::UnitZ(), 0), stretched});
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Shuffled other = shuffled(k, seed);
    const MeshOrder a = canonicalOrder(k.faces, posesOf(k)),
                    b = canonicalOrder(other.keyframes.faces, posesOf(other.keyframes));
    CHECK(a.apply(k.faces) == b.apply(other.keyframes.faces));
    for (int j = 0; j < 2; ++j)
      CHECK(fitRigid(a.apply(k.keys[j].positions), b.apply(other.keyframes.keys[j].positions)).largestDistance < 1e-12);
  }
}

TEST_CASE("the order is the same for poses moved rigidly and for keys in another order") {
  const Keyframes k = severalParts();
  const std::vector<Positions> poses = posesOf(k);
  std::vector<Positions> moved;
  for (std::size_t j = 0; j < poses.size(); ++j)
    moved.push_back(mapped(poses[j], turn(Vec3(1, 2, j), 1.0 + j, Vec3(300, -20.0 * j, 7))));
  const MeshOrder order = canonicalOrder(k.faces, poses);
  CHECK(order.corner == canonicalOrder(k.faces, moved).corner);
  CHECK(order.corner == canonicalOrder(k.faces, {poses[2], poses[0], poses[1]}).corner);
}

TEST_CASE("the motion of several parts is the same for any order in the file") {
  const Keyframes k = severalParts();
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    checkSameMotion(k, seed, doublePrecision());
    checkSameMotion(k, seed, withGhost(300));
  }
}

TEST_CASE("the motion of real shapes is the same for any order in the file") {
  struct Set {
    const char* name;
    std::vector<std::string> files;
  };
  const Set sets[] = {{"lion", {"turns/lion/1.obj", "turns/lion/2.obj", "turns/lion/3.obj"}},
                      {"wolf", {"obj/wolf/wolf-1.obj", "obj/wolf/wolf-4.obj", "obj/wolf/wolf-8.obj"}},
                      {"horse", {"morph/Horse.glb"}},
                      {"cactus", {"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"}},
                      {"saddle", {"turns/saddle/monkey_saddle_1.ply", "turns/saddle/monkey_saddle_2.ply"}}};
  for (const Set& set : sets) {
    if (!hasData(set.files)) continue;
    CAPTURE(set.name);
    const Keyframes k = realKeyframes(set.files);
    checkSameMotion(k, 1, doublePrecision());
    checkSameMotion(k, 2, withGhost(400));
  }
}

}  // namespace shapespline::test::canonical_order_test
