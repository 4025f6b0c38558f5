// The ghost mesh: allowed and forbidden effects of collapses.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "core/ghost/simplify.h"
#include "core/mesh/measures.h"
#include "core/mesh/triangle.h"
#include "laplacian_meshes.h"
#include "shapes.h"
#include "shapes/bench_mesh.h"

namespace shapespline::test::simplify_test {

namespace {

WeldedShape posed(const Shape& shape, const std::vector<Map>& maps) {
  WeldedShape result;
  result.faces = shape.faces;
  for (const Map& map : maps) result.poses.push_back(mapped(shape.positions, map));
  result.keys = static_cast<int>(maps.size());
  return result;
}

GhostMesh simplified(const WeldedShape& shape, int target, bool optimal = false) {
  return simplify(shape, topologyOf(shape), {target, optimal}, [](double) {});
}

struct Topology {
  int euler, boundaryEdges, loops, components;
};

// Topology of a mesh that must be a consistently wound manifold without repeated faces.
Topology topologyOf(const GhostMesh& ghost) {
  const int n = static_cast<int>(ghost.poses.front().size()), m = static_cast<int>(ghost.faces.size());
  const MeshCounts counts = countMesh(n, ghost.faces);
  CHECK(counts.nonManifoldEdges == 0);
  CHECK(counts.inconsistentEdges == 0);
  CHECK(counts.duplicateFaces == 0);
  CHECK(countUnreferenced(n, ghost.faces) == 0);
  const FaceGraph graph = dualGraph(n, ghost.faces, std::vector<char>(m, 1));
  // Every vertex must be in one fan: its faces are connected across the edges at the vertex.
  const VertexFaces at = facesOfVertices(n, ghost.faces);
  for (int v = 0; v < n; ++v) {
    std::set<int> left(at.of(v).begin(), at.of(v).end());
    std::vector<int> open = {*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      for (int g : graph.of(f))
        if (left.erase(g)) open.push_back(g);
    }
    CHECK(left.empty());
  }
  // Boundary loops: each boundary edge leads to the next.
  std::map<int, int> next;
  for (const Triangle& t : ghost.faces)
    for (int c = 0; c < 3; ++c) {
      const int a = t[c], b = t[(c + 1) % 3];
      const bool inner = std::any_of(at.of(a).begin(), at.of(a).end(), [&](int f) {
        const Triangle& u = ghost.faces[f];
        return (u[0] == b && u[1] == a) || (u[1] == b && u[2] == a) || (u[2] == b && u[0] == a);
      });
      if (!inner) next[b] = a;
    }
  int loops = 0;
  std::set<int> seen;
  for (auto [start, unused] : next) {
    if (seen.count(start)) continue;
    ++loops;
    for (int v = start; seen.insert(v).second;) v = next[v];
  }
  return {n - counts.edges + m, counts.boundaryEdges, loops, connectedComponents(graph, std::vector<char>(m, 1)).count};
}

Shape torus(int around, int across) {
  Shape shape;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across;
      shape.positions.emplace_back((3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v));
      const auto at = [&](int a, int b) { return (a % around) * across + b % across; };
      shape.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      shape.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return shape;
}

// A square sheet in the xy plane, with an optional square hole in its middle.
Shape sheet(int cells, bool hole = false) {
  Shape shape;
  std::map<std::pair<int, int>, int> index;
  const auto vertex = [&](int i, int j) {
    const auto [it, added] = index.emplace(std::pair{i, j}, static_cast<int>(shape.positions.size()));
    if (added) shape.positions.emplace_back(4.0 * i / cells, 4.0 * j / cells, 0);
    return it->second;
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const auto middle = [&](int k) { return 3 * k >= cells && 3 * k < 2 * cells; };
      if (hole && middle(i) && middle(j)) continue;
      shape.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      shape.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return shape;
}

Map wave(double height) {
  return [=](const Vec3& p) -> Vec3 { return {p.x(), p.y(), height * std::sin(1.5 * p.x()) * std::cos(p.y())}; };
}

void checkMaps(const WeldedShape& shape, const GhostMesh& ghost) {
  const int ghosts = static_cast<int>(ghost.vertexOf.size());
  REQUIRE(ghost.poses.size() == shape.poses.size());
  REQUIRE(ghost.ghostOf.size() == shape.poses.front().size());
  for (const Positions& pose : ghost.poses) REQUIRE(static_cast<int>(pose.size()) == ghosts);
  for (const Triangle& t : ghost.faces)
    for (int v : t) REQUIRE((v >= 0 && v < ghosts));
  for (int g : ghost.ghostOf) REQUIRE((g >= -1 && g < ghosts));
  for (int g = 0; g < ghosts; ++g) {
    REQUIRE(ghost.vertexOf[g] >= 0);
    CHECK(ghost.ghostOf[ghost.vertexOf[g]] == g);
  }
}

// Every ghost vertex of a half-edge collapse is a vertex of the shape, in every pose.
void checkHalfEdge(const WeldedShape& shape, const GhostMesh& ghost) {
  checkMaps(shape, ghost);
  for (std::size_t c = 0; c < shape.poses.size(); ++c)
    for (std::size_t g = 0; g < ghost.vertexOf.size(); ++g)
      CHECK(ghost.poses[c][g] == shape.poses[c][ghost.vertexOf[g]]);
}

const std::vector<Map> bends = {bend(0), bend(radians(70)), bend(radians(-120))};

}  // namespace

TEST_CASE("simplify: reaches its target with vertices of the shape") {
  const WeldedShape shape = posed(box(1, 1, 10, 8, 8, 80), bends);
  for (int target : {2000, 500, 60}) {
    const GhostMesh ghost = simplified(shape, target);
    CHECK(static_cast<int>(ghost.faces.size()) <= target);
    CHECK(static_cast<int>(ghost.faces.size()) >= target - 1);
    checkHalfEdge(shape, ghost);
    CHECK(std::count(ghost.ghostOf.begin(), ghost.ghostOf.end(), -1) == 0);
    const Topology topology = topologyOf(ghost);
    CHECK(topology.euler == 2);
    CHECK(topology.boundaryEdges == 0);
  }
}

TEST_CASE("simplify: keeps the volume in every pose") {
  const Shape bar = box(1, 1, 10, 8, 8, 80);
  const WeldedShape shape = posed(bar, {bend(0), bend(radians(90)), twist(radians(180))});
  for (const bool optimal : {false, true}) {
    const GhostMesh ghost = simplified(shape, 800, optimal);
    for (std::size_t c = 0; c < shape.poses.size(); ++c) {
      const double whole = enclosedVolume(shape.poses[c], shape.faces),
                   coarse = enclosedVolume(ghost.poses[c], ghost.faces);
      CAPTURE(optimal);
      CAPTURE(c);
      CHECK(coarse == doctest::Approx(whole).epsilon(0.03));
    }
  }
}

TEST_CASE("simplify: a torus stays a torus, even when it is asked to become a tetrahedron") {
  const WeldedShape shape = posed(torus(48, 24), {turn(Vec3::UnitX(), 0), wave(0.2)});
  for (int target : {400, 4}) {
    const GhostMesh ghost = simplified(shape, target);
    const Topology topology = topologyOf(ghost);
    CHECK(topology.euler == 0);
    CHECK(topology.boundaryEdges == 0);
    CHECK(ghost.faces.size() <= 400);
    CHECK(ghost.faces.size() >= 14);  // the minimum for any torus
  }
}

TEST_CASE("simplify: boundaries stay in place") {
  for (const bool hole : {false, true}) {
    const Shape flat = sheet(30, hole);
    const WeldedShape shape = posed(flat, {wave(0), wave(0.3)});
    const GhostMesh ghost = simplified(shape, 200);
    checkHalfEdge(shape, ghost);
    CHECK(ghost.faces.size() <= 200);
    const Topology topology = topologyOf(ghost);
    CHECK(topology.loops == (hole ? 2 : 1));
    CHECK(topology.euler == (hole ? 0 : 1));
    CHECK(surfaceArea(ghost.poses[0], ghost.faces) ==
          doctest::Approx(surfaceArea(flat.positions, flat.faces)).epsilon(1e-9));
    int corners = 0;
    for (const Vec3& p : ghost.poses[0]) corners += (p.x() == 0 || p.x() == 4) && (p.y() == 0 || p.y() == 4);
    CHECK(corners == 4);
  }
}

TEST_CASE("simplify: no face is reversed or too thin in any pose") {
  const Keyframes k = makeBenchKeyframes(12000, 5, 7);
  WeldedShape shape;
  shape.faces = k.faces;
  for (const Key& key : k.keys) shape.poses.push_back(key.positions);
  shape.keys = k.keyCount();
  for (const bool optimal : {false, true}) {
    const GhostMesh ghost = simplified(shape, 1200, optimal);
    checkMaps(shape, ghost);
    CHECK(topologyOf(ghost).euler == 2);
    // Compares normals of all faces of the shape around a ghost vertex with the ghost's normals.
    const int ghosts = static_cast<int>(ghost.vertexOf.size());
    const auto normal = [](const Positions& p, const Triangle& t) -> Vec3 {
      return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
    };
    int against = 0, thin = 0;
    for (std::size_t c = 0; c < shape.poses.size(); ++c) {
      std::vector<Vec3> fine(ghosts, Vec3::Zero()), coarse(ghosts, Vec3::Zero());
      for (const Triangle& t : shape.faces)
        for (int v : t) fine[ghost.ghostOf[v]] += normal(shape.poses[c], t);
      const Positions& p = ghost.poses[c];
      for (const Triangle& t : ghost.faces) {
        for (int v : t) coarse[v] += normal(p, t);
        const double longest = std::max(
            {(p[t[1]] - p[t[0]]).squaredNorm(), (p[t[2]] - p[t[1]]).squaredNorm(), (p[t[0]] - p[t[2]]).squaredNorm()});
        thin += normal(p, t).norm() < 0.03 * longest;
      }
      for (int g = 0; g < ghosts; ++g) against += fine[g].dot(coarse[g]) <= 0;
    }
    CAPTURE(optimal);
    CHECK(against == 0);
    CHECK(thin == 0);
  }
}

TEST_CASE("simplify: a small share of the faces for every part") {
  const Shape body = box(1, 1, 10, 8, 8, 80);
  const Shape parts = joined(joined(body, sphere({1.2, 0, 5}, 0.2)), sphere({0, 1.5, 9}, 0.02));
  const WeldedShape shape = posed(parts, bends);
  const ShapeTopology whole = topologyOf(shape);
  for (int target : {1000, 200, 20}) {
    const GhostMesh ghost = simplified(shape, target);
    CHECK(topologyOf(ghost).components == 3);
    CHECK(topologyOf(ghost).euler == 6);
    CHECK(ghost.joinedComponents == 0);
    CHECK(static_cast<int>(ghost.faces.size()) <= target);
    std::vector<int> count(3, 0);
    for (const Triangle& t : ghost.faces) {
      const int v = ghost.vertexOf[t[0]];
      for (int f = 0; f < shape.faceCount(); ++f)
        if (shape.faces[f][0] == v || shape.faces[f][1] == v || shape.faces[f][2] == v) {
          ++count[whole.components.ofFace[f]];
          break;
        }
    }
    for (int component = 0; component < 3; ++component) {
      const double share =
          double(std::count(whole.components.ofFace.begin(), whole.components.ofFace.end(), component)) /
          shape.faceCount();
      CHECK(count[component] >= std::max(4, int(target * share / 2)));
    }
  }
}

TEST_CASE("simplify: parts too small for a tetrahedron of their own join the rest, the smallest first") {
  Shape parts = box(1, 1, 10, 4, 4, 40);
  for (int i = 0; i < 9; ++i) parts = joined(parts, sphere({1.5, 0, 0.5 + i}, 0.05 + 0.02 * i, 6, 8));
  const WeldedShape shape = posed(parts, bends);
  const GhostMesh ghost = simplified(shape, 24);
  checkHalfEdge(shape, ghost);
  CHECK(ghost.faces.size() <= 24);
  CHECK(ghost.joinedComponents > 0);
  CHECK(topologyOf(ghost).components == 10 - ghost.joinedComponents);
  const int n = static_cast<int>(shape.poses.front().size());
  CHECK(ghost.ghostOf[0] >= 0);                                               // a vertex of the bar
  CHECK(ghost.ghostOf[int(box(1, 1, 10, 4, 4, 40).positions.size())] == -1);  // a vertex of the smallest sphere
  CHECK(ghost.ghostOf[n - 1] >= 0);                                           // a vertex of the largest sphere
}

TEST_CASE("simplify: the same input gives the same ghost, and so does a pose that is moved rigidly") {
  const Shape bar = box(1, 1, 10, 8, 8, 80);
  const WeldedShape shape = posed(bar, bends);
  WeldedShape moved = shape;
  moved.poses[1] = mapped(moved.poses[1], turn(Vec3(1, 2, -0.5), 2.2, Vec3(3, -7, 11)));
  for (const bool optimal : {false, true}) {
    const GhostMesh a = simplified(shape, 700, optimal), b = simplified(shape, 700, optimal),
                    c = simplified(moved, 700, optimal);
    CHECK(a.faces == b.faces);
    CHECK(a.poses == b.poses);
    CHECK(a.faces == c.faces);
    CHECK(a.vertexOf == c.vertexOf);
    CHECK(a.ghostOf == c.ghostOf);
  }
}

TEST_CASE("simplify: non-manifold meshes keep their components") {
  SUBCASE("three sheets that meet along a line keep the line") {
    Shape book;
    const Shape page = sheet(16);
    for (int i = 0; i < 3; ++i) {
      const Map turned = turn(Vec3::UnitY(), 2 * pi * i / 3);
      const int offset = static_cast<int>(book.positions.size());
      std::vector<int> number;
      for (const Vec3& p : page.positions) {
        const Vec3 q = turned(p);
        const auto same = std::find_if(book.positions.begin(), book.positions.begin() + offset,
                                       [&](const Vec3& other) { return (other - q).norm() < 1e-9; });
        number.push_back(static_cast<int>(same - book.positions.begin()));
        if (same - book.positions.begin() == offset) {
          number.back() = static_cast<int>(book.positions.size());
          book.positions.push_back(q);
        }
      }
      for (const Triangle& t : page.faces) book.faces.push_back({number[t[0]], number[t[1]], number[t[2]]});
    }
    const WeldedShape shape = posed(book, {wave(0), twist(0.5, 4)});
    const MeshCounts before = countMesh(shape.vertexCount(), shape.faces);
    REQUIRE(before.nonManifoldEdges == 16);
    const GhostMesh ghost = simplified(shape, 200);
    checkHalfEdge(shape, ghost);
    const MeshCounts after = countMesh(int(ghost.vertexOf.size()), ghost.faces);
    CHECK(ghost.faces.size() <= 200);
    CHECK(after.nonManifoldEdges > 0);
    CHECK(int(ghost.vertexOf.size()) - after.edges + int(ghost.faces.size()) == 1);  // still contractible
  }
  SUBCASE("two spheres that touch in a vertex keep touching") {
    Shape both = sphere({0, 0, 0}, 1);
    const int first = static_cast<int>(both.positions.size()) - 1;
    both = joined(both, sphere({0, 0, -2}, 1));
    for (Triangle& t : both.faces)
      for (int& v : t)
        if (v == first + 1) v = first;
    const GhostMesh ghost = simplified(posed(both, {wave(0), wave(0.1)}), 100);
    const int m = static_cast<int>(ghost.faces.size());
    CHECK(m <= 100);
    CHECK(connectedComponents(dualGraph(int(ghost.vertexOf.size()), ghost.faces, std::vector<char>(m, 1)),
                              std::vector<char>(m, 1))
              .count == 1);
    CHECK(countMesh(int(ghost.vertexOf.size()), ghost.faces).nonManifoldEdges == 0);
  }
  SUBCASE("a double sheet becomes a single one") {
    Shape two = sheet(20);
    for (const Triangle& t : sheet(20).faces) two.faces.push_back({t[0], t[2], t[1]});
    const GhostMesh ghost = simplified(posed(two, {wave(0), wave(0.3)}), 100);
    CHECK(ghost.faces.size() <= 100);
    CHECK(topologyOf(ghost).loops == 1);
  }
}

TEST_CASE("simplify: survives any list of triangles") {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    const int n = 4 + random.below(60), m = 1 + random.below(300);
    WeldedShape shape;
    shape.keys = 2;
    shape.poses.resize(2);
    for (int v = 0; v < n; ++v)
      for (Positions& pose : shape.poses) {
        // A coarse lattice, where coincident and collinear points are common.
        const double step = round % 3 == 0 ? 1 : round % 3 == 1 ? 0.25 : 1e-9;
        const auto coordinate = [&] { return std::round(random.signedUnit() / step) * step; };
        pose.emplace_back(coordinate(), coordinate(), coordinate());
      }
    for (int f = 0; f < m; ++f) shape.faces.push_back({random.below(n), random.below(n), random.below(n)});
    const ShapeTopology parts = topologyOf(shape);
    if (parts.components.count == 0) continue;
    for (int target : {4, m / 2 + 4}) {
      const GhostMesh ghost = simplify(shape, parts, {target, round % 2 == 1}, [](double) {});
      checkMaps(shape, ghost);
      CHECK(!ghost.faces.empty());
      for (const Triangle& t : ghost.faces)
        for (const Positions& p : ghost.poses) CHECK(!isDegenerate(p[t[0]], p[t[1]], p[t[2]]));
    }
  }
}

TEST_CASE("simplify: progress rises from 0 to 1") {
  const WeldedShape shape = posed(box(1, 1, 10, 16, 16, 160), bends);
  double last = 0;
  int calls = 0;
  simplify(shape, topologyOf(shape), {500, false}, [&](double fraction) {
    CHECK(fraction >= last);
    CHECK(fraction <= 1);
    last = fraction;
    ++calls;
  });
  CHECK(last == 1);
  CHECK(calls > 3);
}

}  // namespace shapespline::test::simplify_test
