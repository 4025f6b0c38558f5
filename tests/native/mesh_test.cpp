// Topology, welding and components of small difficult meshes.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/lri/lri.h"
#include "core/mesh/component_tree.h"
#include "core/mesh/contact.h"
#include "core/mesh/weld.h"
#include "shapes.h"

namespace shapespline::test::mesh_test {

namespace {

Shape tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

Shape moebius() {
  Shape s;
  const int n = 24;
  for (int i = 0; i < n; ++i)
    for (double side : {-0.3, 0.3}) {
      const double a = 2 * pi * i / n;
      const double r = 1 + side * std::cos(a / 2);
      s.positions.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2));
    }
  for (int i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    s.faces.push_back({a, b, c}), s.faces.push_back({b, d, c});
  }
  return s;
}

// Moves each shape through three poses. The motion must pass the keys and contain no NaN.
void checkMotion(const Shape& shape, const char* name) {
  CAPTURE(name);
  const Keyframes k = keyframes(
      shape, {turn(Vec3::UnitX(), 0), turn(Vec3(1, 1, 0), 0.8, Vec3(0.1, 0, 0)),
              [](const Vec3& p) -> Vec3 { return {1.2 * p.x() + 0.2 * p.y(), p.y(), p.z() + 0.3 * p.x() * p.x()}; }});
  for (const Precision precision : {Precision::Double, Precision::Single}) {
    EncodingOptions options;
    options.precision = precision;
    auto s = Sequence::create(k, options, {});
    REQUIRE_MESSAGE(s.ok(), (s ? "" : s.error().message));
    for (double t : {-0.4, 0.0, 0.25, 0.5, 0.8, 1.0, 1.4}) {
      Positions p;
      REQUIRE(s->evaluate(t, p).ok());
      REQUIRE(p.size() == shape.positions.size());
      for (const Vec3& x : p) CHECK(x.allFinite());
      for (const Key& key : k.keys)
        if (key.time == t)
          CHECK(largestDistance(p, key.positions) < (precision == Precision::Double ? 1e-9 : 1e-5) * diagonalOf(k));
    }
  }
}

}  // namespace

TEST_CASE("counts of a closed, an open and a non-manifold mesh") {
  const Shape closed = tetrahedron();
  MeshCounts c = countMesh(4, closed.faces);
  CHECK(c.edges == 6);
  CHECK(c.boundaryEdges == 0);
  CHECK(c.inconsistentEdges == 0);

  Shape open = closed;
  open.faces.pop_back();
  c = countMesh(4, open.faces);
  CHECK(c.boundaryEdges == 3);

  Shape fin = closed;  // a third face at an edge, one repeated face, one flipped, one unused vertex
  fin.positions.insert(fin.positions.end(), {{2, 2, 2}, {9, 9, 9}});
  fin.faces.push_back({0, 1, 4});
  fin.faces.push_back({1, 0, 2});
  c = countMesh(6, fin.faces);
  CHECK(c.nonManifoldEdges >= 1);
  CHECK(c.duplicateFaces == 1);
  CHECK(countUnreferenced(6, fin.faces) == 1);
  CHECK(countMesh(48, moebius().faces).inconsistentEdges >= 1);
}

TEST_CASE("vertices weld where they coincide in every key, and only there") {
  Positions a = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e-9}, {1, 0, 0}};
  Positions b = {{5, 0, 0}, {6, 0, 0}, {5, 0, 0}, {7, 0, 0}};  // the last two vertices separate in the second key
  const Positions* poses[] = {&a, &b};
  const Welding w = weld(poses, std::vector<double>(std::size(poses), 1e-6));
  CHECK(w.count == 3);
  CHECK(w.weldedOfRaw[2] == w.weldedOfRaw[0]);
  CHECK(w.weldedOfRaw[3] != w.weldedOfRaw[1]);
}

TEST_CASE("welding finds partners across cell borders") {
  Positions p;
  for (int i = 0; i < 2000; ++i) p.emplace_back(i * 0.37, -i * 0.11, 0.5 * i);
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) p.push_back(p[i] + Vec3(9e-7, -9e-7, 9e-7) / std::sqrt(3.0));
  const Positions* poses[] = {&p};
  CHECK(weld(poses, std::vector<double>(std::size(poses), 1e-6)).count == static_cast<int>(n));
}

TEST_CASE("seams shade together where the file's normals agree within a degree") {
  Welding w;
  w.weldedOfRaw = {0, 0, 0};
  w.rawOfWelded = {0};
  w.count = 1;
  int groups = 0;
  const auto group = shadingGroups(w, {{0, 0, 1}, {0, 0.01, 1}, {0, 1, 0}}, groups);
  CHECK(groups == 2);
  CHECK(group[0] == group[1]);
  CHECK(group[0] != group[2]);
  CHECK(shadingGroups(w, {}, groups)[2] == 0);
}

TEST_CASE("repeated faces are counted in any order of their vertices, those without three vertices too") {
  const std::vector<Triangle> faces = {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {0, 1, 3}, {3, 3, 1}, {1, 3, 3}, {3, 1, 1}};
  CHECK(countMesh(4, faces).duplicateFaces == 3);
}

TEST_CASE("components are numbered and counted consistently: faces that share a vertex belong together") {
  Shape shape = joined(joined(sphere({0, 3, 0}, 0.2), tetrahedron()), bar());
  shape.faces.push_back({0, static_cast<int>(shape.positions.size()) - 1, 1});  // connects the first part to the last
  std::vector<char> use(shape.faces.size(), 1);
  const auto n = static_cast<int>(shape.positions.size());
  const auto bothCounts = [&] {
    const int numbered = connectedComponents(dualGraph(n, shape.faces, use), use).count;
    CHECK(countComponents(n, shape.faces, use) == numbered);
    return numbered;
  };
  CHECK(bothCounts() == 2);
  use.back() = 0;
  CHECK(bothCounts() == 3);
  std::fill(use.begin(), use.end(), 0);
  CHECK(bothCounts() == 0);
  use[0] = use[4] = 1;
  const Components components = connectedComponents(dualGraph(n, shape.faces, use), use);
  CHECK(components.ofFace[0] == 0);
  CHECK(components.ofFace[1] == -1);
}

TEST_CASE("long work is reported block by block, in order and to its end") {
  std::vector<double> heard;
  std::size_t next = 0;
  inBlocks([&](double fraction) { heard.push_back(fraction); }, 40000,
           [&](std::size_t begin, std::size_t end) {
             CHECK(begin == next);
             next = end;
           });
  CHECK(next == 40000);
  REQUIRE(heard.size() == 3);
  CHECK(heard[0] == 0);
  CHECK(heard[1] == doctest::Approx(16384.0 / 40000));
}

TEST_CASE("nested parts of a progress report have the right place in the whole") {
  double heard = -1;
  const auto hear = [&](double fraction) { heard = fraction; };
  const FractionReport part = partOf(partOf(hear, 0.5, 1), 0.5, 0.75);
  reportFraction(part, 0);
  CHECK(heard == 0.75);
  reportFraction(part, 1);
  CHECK(heard == 0.875);
  CHECK(!partOf({}, 0, 0.5));
}

TEST_CASE("contacts equal those found by comparing all vertices") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  constexpr int parts = 9, size = 400;
  std::vector<Positions> poses(6);
  std::vector<int> partOf;
  for (int v = 0; v < parts * size; ++v) {
    partOf.push_back(v % 10 == 3 ? -1 : v * 7 % parts);
    for (Positions& pose : poses) pose.emplace_back(number(random) + v * 7 % parts, number(random), number(random));
  }
  std::vector<const Positions*> all;
  for (const Positions& pose : poses) all.push_back(&pose);
  const ContactSearch search(all, partOf, parts);
  const std::vector<int> label = {4, 1, 2, 4, 3, 5, 6, 7, 8};
  const std::vector<int> shared = search.sharedLabels(label);
  const auto distance = [&](int a, int b, std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t k = first; k < last; ++k) largest = std::max(largest, (poses[k][a] - poses[k][b]).squaredNorm());
    return largest;
  };
  std::vector<int> lastFound;
  for (int u = 0; u < parts * size; u += 9) {  // these vertices form one part
    if (partOf[u] < 0) continue;
    const int own = label[partOf[u]];
    const auto isOther = [&](int v) { return partOf[v] >= 0 && label[partOf[v]] != own; };
    Contact expected;
    for (const std::size_t k : {0, 1, 3, 5}) {  // four of six poses are searched
      int nearest = -1;
      for (int v = 0; v < parts * size; ++v)
        if (isOther(v) && (nearest < 0 || distance(u, v, k, k + 1) < distance(u, nearest, k, k + 1))) nearest = v;
      if (const double d = distance(u, nearest, 0, 6); d < expected.distance) expected = {d, u, nearest};
    }
    Contact found;
    search.nearestOther(u, shared, own, found, lastFound);
    CHECK(found.to == expected.to);
    CHECK(found.distance == expected.distance);
    int lowest = -1, lowestExpected = -1;
    search.lowestOther(u, shared, own, 2 * found.distance, lowest);
    for (int v = parts * size - 1; v >= 0; --v)
      if (isOther(v) && distance(u, v, 0, 6) < 2 * found.distance) lowestExpected = v;
    CHECK(lowest == lowestExpected);
  }
}

TEST_CASE("components are attached to their nearest neighbour, rooted at the largest") {
  const Shape parts = joined(joined(sphere({0, 3, 0}, 0.2), sphere({0, 0, 0}, 1)), sphere({0, 1.6, 0}, 0.4));
  const std::vector<char> use(parts.faces.size(), 1);
  const Components components =
      connectedComponents(dualGraph(static_cast<int>(parts.positions.size()), parts.faces, use), use);
  REQUIRE(components.count == 3);
  const Positions* poses[] = {&parts.positions};
  const ComponentTree tree = linkComponents(parts.faces, components, poses);
  CHECK(tree.root() == 1);
  CHECK(tree.link[2].parent == 1);
  CHECK(tree.link[0].parent == 2);
  CHECK(components.ofFace[tree.link[0].anchorFace] == 2);
  CHECK(components.ofFace[tree.link[0].contactFace] == 0);
}

TEST_CASE("rounding does not decide where a component is attached if several places are equally near") {
  Shape hat = box(0.5, 0.5, 0.5, 1, 1, 1);
  for (Vec3& p : hat.positions) p += Vec3(0, 0, 10.3);
  const Shape parts = joined(box(1, 1, 10, 2, 2, 20), hat);
  const std::vector<char> use(parts.faces.size(), 1);
  const Components components =
      connectedComponents(dualGraph(static_cast<int>(parts.positions.size()), parts.faces, use), use);
  REQUIRE(components.count == 2);
  const auto attached = [&](double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Positions> poses(3, parts.positions);
    for (Positions& pose : poses)
      for (Vec3& p : pose)
        for (double& x : p) x += noise * (random() / 0x1p32 - 0.5);
    const Positions* all[] = {&poses[0], &poses[1], &poses[2]};
    const ComponentLink link = linkComponents(parts.faces, components, all).link[1];
    return std::pair(link.anchorFace, link.contactFace);
  };
  const auto exact = attached(0, 0);
  for (unsigned seed = 1; seed <= 30; ++seed) CHECK(attached(1e-6, seed) == exact);
}

TEST_CASE("every kind of mesh moves through its keys and stays finite") {
  checkMotion(tetrahedron(), "tetrahedron");
  Shape open = bar();
  open.faces.resize(open.faces.size() / 2);
  checkMotion(open, "open, with unreferenced vertices");
  checkMotion(moebius(), "Moebius strip");
  checkMotion({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, "one triangle");
  Shape twoFans = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0.3}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  checkMotion(twoFans, "two faces that share a vertex");
  Shape repeated = tetrahedron();
  repeated.faces.push_back(repeated.faces[0]);
  repeated.faces.push_back({0, 1, 2});
  checkMotion(repeated, "repeated and flipped faces");
  Shape flat = bar();
  const int extra = static_cast<int>(flat.positions.size());
  flat.positions.push_back((flat.positions[0] + flat.positions[1]) / 2);  // on an edge, so its face has no area
  flat.positions.emplace_back(3, 3, 3);                                   // belongs only to faces without area
  flat.faces.push_back({0, 1, extra});
  flat.faces.push_back({extra, extra + 1, extra});
  checkMotion(flat, "degenerate faces");
  Shape needle = tetrahedron();
  needle.positions[3] = {1e-4, 1e-4, 1e-7};
  checkMotion(needle, "slivers");
  checkMotion(joined(bar(), sphere({2, 0, 3}, 0.5)), "two parts");
  Shape fin = bar();
  fin.positions.emplace_back(2, 0, 0);
  fin.faces.push_back({0, 1, static_cast<int>(fin.positions.size()) - 1});
  checkMotion(fin, "non-manifold edge");
}

TEST_CASE("a triangle without area in one key only passes through its keys") {
  const Shape shape = bar();
  Keyframes k = keyframes(shape, {bend(0), bend(1), bend(2)});
  const Triangle f = shape.faces[100];
  k.keys[1].positions[f[2]] = (k.keys[1].positions[f[0]] + k.keys[1].positions[f[1]]) / 2;
  auto s = Sequence::create(k, doublePrecision(), {});
  REQUIRE(s.ok());
  Positions p;
  for (const Key& key : k.keys) {
    REQUIRE(s->evaluate(key.time, p).ok());
    CHECK(largestDistance(p, key.positions) < 1e-9 * diagonalOf(k));
  }
}

}  // namespace shapespline::test::mesh_test
