// The generated meshes for tests and benchmarks, and their checks.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "core/sequence/mesh_report.h"
#include "core/space/gram_matrix.h"
#include "dense.h"
#include "io/import.h"
#include "shapes/bench_mesh.h"
#include "shapes/bench_parts.h"
#include "shapes/shape_check.h"

namespace shapespline::test::shapes_test {

TEST_CASE("mesh checks: they detect a hole, a reversed face, a pinched vertex, a fold and a crossing") {
  const Keyframes good = makeBenchKeyframes(1000, 2, 5);
  const Positions& positions = good.keys[0].positions;
  const int vertices = good.vertexCount();
  std::vector<Triangle> faces = good.faces;
  faces.pop_back();
  CHECK_FALSE(isClosedManifold(faces, vertices));
  faces = good.faces;
  std::swap(faces[0][0], faces[0][1]);
  CHECK_FALSE(isClosedManifold(faces, vertices));
  CHECK_FALSE(isClosedManifold(good.faces, vertices + 1));

  // Two tetrahedra that share one vertex.
  const std::vector<Triangle> pinched{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2},
                                      {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {0, 6, 5}};
  CHECK_FALSE(isClosedManifold(pinched, 7));

  const Positions corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.9, 0.9, 0.01}};
  CHECK(sharpestEdge({{0, 1, 2}, {1, 0, 3}}, corners) > 170);
  CHECK(sharpestEdge({{0, 1, 2}, {2, 1, 3}}, corners) < 10);
  CHECK(smallestAngle({{0, 1, 2}}, corners) == doctest::Approx(45));

  Positions two = positions;
  std::vector<Triangle> both = good.faces;
  for (const Vec3& p : positions) two.push_back(p + Vec3(0.3, 0.1, 0));
  for (const Triangle& f : good.faces) both.push_back({f[0] + vertices, f[1] + vertices, f[2] + vertices});
  CHECK(selfIntersections(both, two) > 0);
  for (int v = vertices; v < 2 * vertices; ++v) two[v].x() += 50;
  CHECK(selfIntersections(both, two) == 0);
}

TEST_CASE("bench meshes: the requested number of faces, closed, irregular, shuffled, without crossings") {
  for (int faces : {64, 1001, 10000, 32000}) {
    CAPTURE(faces);
    const Keyframes mesh = makeBenchKeyframes(faces, 3, 5);
    REQUIRE(validate(mesh).ok());
    CHECK(mesh.faceCount() == faces + faces % 2);
    CHECK(mesh.vertexCount() == mesh.faceCount() / 2 + 2);
    CHECK(isClosedManifold(mesh.faces, mesh.vertexCount()));
    if (faces < 1000) continue;  // too coarse for further checks

    const double volume = enclosedVolume(mesh.keys[0].positions, mesh.faces);
    for (const Key& key : mesh.keys) {
      CHECK(enclosedVolume(key.positions, mesh.faces) == doctest::Approx(volume).epsilon(0.01));
      CHECK(smallestAngle(mesh.faces, key.positions) > 3);
      if (faces <= 10000) CHECK(selfIntersections(mesh.faces, key.positions) == 0);
    }
    std::vector<int> valence(mesh.vertexCount(), 0);
    double apart = 0;
    for (const Triangle& face : mesh.faces) {
      for (int v : face) ++valence[v];
      apart += std::abs(face[0] - face[1]);
    }
    CHECK(std::set<int>(valence.begin(), valence.end()).size() >= 5);
    // Two random indices are a third of the range apart on average.
    CHECK(apart / mesh.faceCount() == doctest::Approx(mesh.vertexCount() / 3.0).epsilon(0.1));
  }
}

TEST_CASE("bench meshes: the same arguments give the same mesh, another seed a different mesh") {
  const Keyframes a = makeBenchKeyframes(2000, 4, 9), b = makeBenchKeyframes(2000, 4, 9);
  const Keyframes c = makeBenchKeyframes(2000, 4, 10);
  CHECK(a.faces == b.faces);
  CHECK(a.keyCount() == 4);
  for (int j = 0; j < 4; ++j) CHECK(a.keys[j].positions == b.keys[j].positions);
  CHECK(a.faces != c.faces);
}

TEST_CASE("bench meshes of parts: the requested number of faces in several open parts, with slivers, in every key") {
  for (int faces : {2400, 9999}) {
    CAPTURE(faces);
    const Keyframes mesh = makeBenchParts(faces, 3, 5);
    REQUIRE(validate(mesh).ok());
    CHECK(mesh.faceCount() == faces + faces % 2);
    const MeshReport report = reportOf(mesh);
    CHECK(report.components == 21);
    CHECK(report.weldedVertices == report.vertices);
    CHECK(report.unreferencedVertices == 0);
    CHECK(report.degenerateFaces == 0);
    CHECK(report.counts.boundaryEdges > faces / 50);
    CHECK(report.counts.nonManifoldEdges + report.counts.inconsistentEdges + report.counts.duplicateFaces == 0);
    for (const Key& key : mesh.keys) {
      CHECK(smallestAngle(mesh.faces, key.positions) > 0.02);
      CHECK(smallestAngle(mesh.faces, key.positions) < 1.5);
    }
  }
}

TEST_CASE("bench meshes of parts: the parts rotate separately, the same arguments give the same mesh") {
  const Keyframes a = makeBenchParts(2400, 4, 9), b = makeBenchParts(2400, 4, 9);
  CHECK(a.faces == b.faces);
  CHECK(a.keyCount() == 4);
  for (int j = 0; j < 4; ++j) CHECK(a.keys[j].positions == b.keys[j].positions);
  CHECK(a.faces != makeBenchParts(2400, 4, 10).faces);

  // Rotation of the balls relative to the nearby body: up to 60 degrees, plus about ten degrees of the body's local
  // bending.
  const std::vector<char> all(a.faces.size(), 1);
  const std::vector<int> componentOf = connectedComponents(dualGraph(a.vertexCount(), a.faces, all), all).ofFace;
  std::vector<std::set<int>> component(*std::max_element(componentOf.begin(), componentOf.end()) + 1);
  for (std::size_t f = 0; f < a.faces.size(); ++f)
    component[componentOf[f]].insert(a.faces[f].begin(), a.faces[f].end());
  const auto body = *std::max_element(component.begin(), component.end(),
                                      [](const auto& p, const auto& q) { return p.size() < q.size(); });
  std::vector<Triangle> bodyFaces;
  std::copy_if(a.faces.begin(), a.faces.end(), std::back_inserter(bodyFaces),
               [&](const Triangle& face) { return body.count(face[0]) > 0; });
  CHECK(countMesh(a.vertexCount(), bodyFaces).boundaryEdges > 20);
  const auto rotationNear = [&](const std::set<int>& vertices, const Vec3& centre) {
    Positions before, after;
    for (int v : vertices)
      if ((a.keys[0].positions[v] - centre).norm() < 0.8)
        before.push_back(a.keys[0].positions[v]), after.push_back(a.keys[1].positions[v]);
    return fitRigid(before, after).rotation;
  };
  int balls = 0;
  double most = 0;
  for (const auto& part : component) {
    Eigen::AlignedBox3d box;
    for (int v : part) box.extend(a.keys[0].positions[v]);
    if (box.sizes().maxCoeff() > 0.41) continue;
    ++balls;
    const Mat3 own = rotationNear(body, box.center()).transpose() * rotationNear(part, box.center());
    most = std::max(most, Eigen::AngleAxisd(own).angle() * 180 / M_PI);
  }
  CHECK(balls == 5);
  CHECK(most > 30);
  CHECK(most < 80);
}

TEST_CASE("bench meshes: a subdivided mesh is the same shape with four times the faces") {
  const Keyframes coarse = makeBenchKeyframes(1000, 3, 3), fine = subdivided(coarse);
  REQUIRE(validate(fine).ok());
  CHECK(fine.faceCount() == 4 * coarse.faceCount());
  CHECK(isClosedManifold(fine.faces, fine.vertexCount()));
  for (int j = 0; j < 3; ++j) {
    CHECK(enclosedVolume(fine.keys[j].positions, fine.faces) ==
          doctest::Approx(enclosedVolume(coarse.keys[j].positions, coarse.faces)).epsilon(1e-12));
  }
}

}  // namespace shapespline::test::shapes_test
