// The generated shapes: samples, benchmark meshes, and the tools that make them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "core/mesh/measures.h"
#include "core/rotation/rigid_fit.h"
#include "core/sequence/gram_matrix.h"
#include "core/sequence/mesh_report.h"
#include "dense.h"
#include "io/import.h"
#include "samples/bench_mesh.h"
#include "samples/bench_parts.h"
#include "samples/edit_mesh.h"
#include "samples/polygonise.h"
#include "samples/random.h"
#include "samples/remesh.h"
#include "samples/sample_file.h"
#include "samples/shape_check.h"
#include "samples/skin.h"

using namespace shapespline;
using namespace shapespline::test;

namespace {

double sphere(const Vec3& p) { return p.norm() - 1; }

Surface sphereSurface(double cell) { return polygonise(sphere, Vec3::Constant(-1.5), Vec3::Constant(1.5), cell); }

// Two limbs at right angles: a trunk upwards and an arm to the right.
Body smallBody() {
  Body body;
  Limb trunk = makeLimb({{{0, 0, 0}, 0.5}, {{0, 3, 0}, 0.4}}, 13);
  trunk.edge = 0.2;
  Limb arm = makeLimb({{{0, 1.5, 0}, 0.3}, {{2, 1.5, 0}, 0.25}}, 9);
  arm.edge = 0.15;
  arm.blend = 0.1;
  attach(body, -1, trunk);
  attach(body, 0, arm);
  return body;
}

std::vector<double> edgeLengths(const std::vector<Triangle>& faces, const Positions& positions) {
  std::vector<double> lengths;
  for (const Triangle& face : faces) {
    for (int c = 0; c < 3; ++c) lengths.push_back((positions[face[c]] - positions[face[(c + 1) % 3]]).norm());
  }
  return lengths;
}

int eulerCharacteristic(const Surface& surface) {
  return static_cast<int>(surface.positions.size()) - static_cast<int>(surface.faces.size()) / 2;
}

double largestDistance(const Positions& a, const Positions& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
  return largest;
}

}  // namespace

TEST_CASE("samples: every sample is small, closed, well shaped and keeps its volume" * dense) {
  for (const SampleMaker& maker : sampleMakers()) {
    CAPTURE(maker.id);
    const Sample sample = maker.make();
    CHECK(sample.id == maker.id);
    const Keyframes& keyframes = sample.keyframes;
    REQUIRE(validate(keyframes).ok());
    CHECK(keyframes.faceCount() >= 5000);
    CHECK(keyframes.faceCount() <= 21000);
    CHECK(isClosedManifold(keyframes.faces, keyframes.vertexCount()));
    const double volume = enclosedVolume(keyframes.keys[0].positions, keyframes.faces);
    CHECK(volume > 0);
    for (const Key& key : keyframes.keys) {
      CAPTURE(key.time);
      // Seen: at most 2 % apart (a folding elbow of the dachshund), no angle below 12 degrees, no edge above 120.
      CHECK(enclosedVolume(key.positions, keyframes.faces) == doctest::Approx(volume).epsilon(0.03));
      CHECK(smallestAngle(keyframes.faces, key.positions) > 10);
      CHECK(sharpestEdge(keyframes.faces, key.positions) < 135);
      CHECK(selfIntersections(keyframes.faces, key.positions) == 0);
    }

    const auto glb = sampleGlb(sample);
    REQUIRE(glb.ok());
    CHECK(glb->size() <= 500 * 1024);
    const NamedBytes file{sampleFileName(sample), *glb};
    const auto read = importKeyframes({&file, 1}, {});
    REQUIRE(read.ok());
    CHECK(read->warnings.empty());
    CHECK(read->keyframes.faces == keyframes.faces);
    REQUIRE(read->keyframes.keyCount() == keyframes.keyCount());
    for (int j = 0; j < keyframes.keyCount(); ++j) {
      CHECK(read->keyframes.keys[j].time == doctest::Approx(keyframes.keys[j].time).epsilon(1e-6));
      // Base and difference are each rounded to float32: the shapes are up to 10 units long.
      CHECK(largestDistance(read->keyframes.keys[j].positions, keyframes.keys[j].positions) < 4e-6);
    }
  }
}

TEST_CASE("samples: a paw of the dachshund that is planted moves with the ground" * dense) {
  // Half a stride of 0.22 either way in 0.62 of the cycle, as the generator has it.
  constexpr double ground = 2 * 0.22 / 0.62;
  struct Paw {
    int landed;  // the key at which it touches down; it stands for this one and the next four
    double along, side;
  };
  const Keyframes walk = makeDachshund().keyframes;
  for (const Paw& paw : {Paw{0, -1, -1}, Paw{2, 1, -1}, Paw{4, -1, 1}, Paw{6, 1, 1}}) {
    CAPTURE(paw.landed);
    const Positions& middle = walk.keys[(paw.landed + 2) % 8].positions;
    int sole = 0;
    for (std::size_t v = 0; v < middle.size(); ++v) {
      if (middle[v].y() > 0.035 || middle[v].x() * paw.along < 0 || middle[v].z() * paw.side < 0) continue;
      ++sole;
      for (int k = 0; k < 5; ++k) {
        const Vec3 moved = walk.keys[(paw.landed + k) % 8].positions[v] + Vec3(ground * (k - 2) / 8, 0, 0);
        // Of a body 5 long. Seen: 0.012.
        CHECK((moved - middle[v]).norm() < 0.02);
      }
    }
    CHECK(sole > 10);
  }
}

TEST_CASE("samples: a paw that is planted on the way across the floor stays where it is" * dense) {
  const Keyframes stroll = makeStroll().keyframes;
  REQUIRE(stroll.keyCount() == 9);
  constexpr double way = 2 * 0.22 / 0.62 / 4;  // from key to key
  struct Paw {
    int landed;  // the key at which it touches down; it stands for this one and the next two
    double along, side;
  };
  for (const Paw& paw : {Paw{0, -1, -1}, Paw{1, 1, -1}, Paw{2, -1, 1}, Paw{3, 1, 1}})
    for (const int landed : {paw.landed, paw.landed + 4}) {
      if (landed + 2 > 8) continue;
      CAPTURE(landed);
      const Positions& middle = stroll.keys[landed + 1].positions;
      int sole = 0;
      for (std::size_t v = 0; v < middle.size(); ++v) {
        const Vec3& p = middle[v];
        if (p.y() > 0.035 || (p.x() - way * (landed + 1 - 4)) * paw.along < 0 || p.z() * paw.side < 0) continue;
        ++sole;
        // Of a body 5 long.
        for (const int key : {landed, landed + 2}) CHECK((stroll.keys[key].positions[v] - p).norm() < 0.02);
      }
      CHECK(sole > 10);
    }
}

TEST_CASE("samples: the list names each file, its times, its boundary and what it holds") {
  Sample sample = makeTwistedBar();
  sample.boundary = BoundaryKind::Periodic;
  sample.hold = true;
  sample.description = "with \"quotes\"";
  const auto list = nlohmann::json::parse(sampleList({sample, sample}));
  REQUIRE(list.size() == 2);
  CHECK(list[0]["id"] == "twisted-bar");
  CHECK(list[0]["files"] == nlohmann::json{"twisted-bar.glb"});
  CHECK(list[0]["times"] == nlohmann::json{0.0, 0.5, 1.0});
  CHECK(list[0]["boundary"] == "periodic");
  CHECK(list[0]["hold"] == "on");
  CHECK(list[0]["description"] == sample.description);
}

TEST_CASE("samples: the bar is twisted about its axis by its angles") {
  const Keyframes bar = makeTwistedBar().keyframes;
  const Positions& rest = bar.keys[0].positions;
  for (int j = 1; j < 3; ++j) {
    const double whole = (j == 1 ? 180 : 350) * M_PI / 180;
    for (std::size_t v = 0; v < rest.size(); ++v) {
      const Eigen::AngleAxisd turn(whole * (rest[v].x() + 5) / 10, Vec3::UnitX());
      REQUIRE((bar.keys[j].positions[v] - turn * rest[v]).norm() < 1e-12);
    }
  }
}

TEST_CASE("samples: a polygonised sphere is closed, faces outwards and has the sphere's volume") {
  const Surface surface = sphereSurface(0.1);
  CHECK(isClosedManifold(surface.faces, static_cast<int>(surface.positions.size())));
  CHECK(eulerCharacteristic(surface) == 2);
  // The chord error of cells of 0.1 on the unit sphere takes away less than 1 %.
  CHECK(enclosedVolume(surface.positions, surface.faces) == doctest::Approx(4 * M_PI / 3).epsilon(0.01));
}

TEST_CASE("samples: remeshing gives nearly equilateral triangles of the wanted size on the surface") {
  const double wanted = 0.15;
  const Surface surface = remesh(sphereSurface(0.1), sphere, [&](const Vec3&) { return wanted; }, 8);
  CHECK(isClosedManifold(surface.faces, static_cast<int>(surface.positions.size())));
  CHECK(eulerCharacteristic(surface) == 2);
  CHECK(smallestAngle(surface.faces, surface.positions) > 30);
  for (double length : edgeLengths(surface.faces, surface.positions)) {
    REQUIRE(length > 0.5 * wanted);
    REQUIRE(length < 1.6 * wanted);
  }
  for (const Vec3& p : surface.positions)
    REQUIRE(std::abs(sphere(p)) < 1e-5);  // the last projection stops short of rounding
}

TEST_CASE("samples: splits, collapses and flips in any order keep a mesh closed") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  Random random(seed);
  EditMesh mesh(sphereSurface(0.35));
  const auto never = [](const Vec3&, const Vec3&) { return false; };
  int collapses = 0, flips = 0;
  for (int round = 0; round < 4; ++round) {
    mesh.splitEdges([&](int a, int b) { return (a * 31 + b * 17 + round) % 5 == 0; });
    for (int i = 0; i < 300; ++i) {
      const int a = static_cast<int>(random.below(mesh.vertexCount()));
      const std::vector<int> ring = mesh.ring(a);
      if (ring.empty()) continue;  // collapsed away
      const int b = ring[random.below(ring.size())];
      const Vec3 middle = 0.5 * (mesh.position(a) + mesh.position(b));
      if (random.below(2)) flips += mesh.flip(a, b);
      else collapses += mesh.collapse(a, b, middle, never);
    }
    mesh.compact();
  }
  CHECK(collapses > 50);
  CHECK(flips > 50);
  const Surface surface = mesh.take();
  CHECK(isClosedManifold(surface.faces, static_cast<int>(surface.positions.size())));
  CHECK(eulerCharacteristic(surface) == 2);
}

TEST_CASE("samples: a bend turns what lies beyond it by the whole angle and what lies before not at all") {
  const Body body = smallBody();
  Pose pose(body);
  bend(pose, body, 0, 0.2, 0.8, Vec3(0, 0, 1.2));
  const auto joints = jointTransforms(body, pose);
  CHECK((joints[0].matrix() - Eigen::Matrix4d::Identity()).norm() < 1e-15);
  CHECK(Eigen::AngleAxisd(joints[12].linear()).angle() == doctest::Approx(1.2));
  // The arm is attached to the trunk's middle joint and has no turns of its own.
  CHECK((joints[20].matrix() - joints[6].matrix()).norm() < 1e-15);
}

TEST_CASE("samples: a skinned surface follows a rigid motion exactly and keeps its volume in a bend") {
  const Body body = smallBody();
  const Surface surface = makeSurface(body);
  REQUIRE(isClosedManifold(surface.faces, static_cast<int>(surface.positions.size())));
  const Binding binding = bindSurface(surface, body, 6);
  for (const auto& shares : binding) {
    double sum = 0;
    for (const Share& share : shares) sum += share.weight;
    REQUIRE(sum == doctest::Approx(1));
  }

  Pose moved(body);
  moved.root = Eigen::Translation3d(1, -2, 3) * Eigen::AngleAxisd(2.5, Vec3(1, 2, 2).normalized());
  const Positions rigid = skin(surface, binding, jointTransforms(body, moved));
  for (std::size_t v = 0; v < rigid.size(); ++v) REQUIRE((rigid[v] - moved.root * surface.positions[v]).norm() < 1e-12);

  Pose bent(body);
  bend(bent, body, 0, 0.1, 0.9, Vec3(1.5, 0, 0));
  const Positions curved = skin(surface, binding, jointTransforms(body, bent));
  const double volume = enclosedVolume(surface.positions, surface.faces);
  CHECK(enclosedVolume(curved, surface.faces) == doctest::Approx(volume).epsilon(0.01));
  CHECK(selfIntersections(surface.faces, curved) == 0);
}

TEST_CASE("samples: the checks see a hole, a turned face, a pinched vertex, a fold and a crossing") {
  const Surface good = sphereSurface(0.4);
  const int vertices = static_cast<int>(good.positions.size());
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

  Positions two = good.positions;
  std::vector<Triangle> both = good.faces;
  for (const Vec3& p : good.positions) two.push_back(p + Vec3(1.1, 0.3, 0));
  for (const Triangle& f : good.faces) both.push_back({f[0] + vertices, f[1] + vertices, f[2] + vertices});
  CHECK(selfIntersections(both, two) > 0);
  for (int v = vertices; v < 2 * vertices; ++v) two[v].x() += 5;
  CHECK(selfIntersections(both, two) == 0);
}

TEST_CASE("bench meshes: the wanted number of faces, closed, irregular, shuffled, without crossings") {
  for (int faces : {64, 1001, 10000, 32000}) {
    CAPTURE(faces);
    const Keyframes mesh = makeBenchKeyframes(faces, 3, 5);
    REQUIRE(validate(mesh).ok());
    CHECK(mesh.faceCount() == faces + faces % 2);
    CHECK(mesh.vertexCount() == mesh.faceCount() / 2 + 2);
    CHECK(isClosedManifold(mesh.faces, mesh.vertexCount()));
    if (faces < 1000) continue;  // too coarse for the rest

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

TEST_CASE("bench meshes: the same arguments give the same mesh, another seed another one") {
  const Keyframes a = makeBenchKeyframes(2000, 4, 9), b = makeBenchKeyframes(2000, 4, 9);
  const Keyframes c = makeBenchKeyframes(2000, 4, 10);
  CHECK(a.faces == b.faces);
  CHECK(a.keyCount() == 4);
  for (int j = 0; j < 4; ++j) CHECK(a.keys[j].positions == b.keys[j].positions);
  CHECK(a.faces != c.faces);
}

TEST_CASE("bench meshes of parts: the wanted number of faces in several open parts, slivers among them, in every key") {
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

TEST_CASE("bench meshes of parts: the parts turn on their own, the same arguments give the same mesh") {
  const Keyframes a = makeBenchParts(2400, 4, 9), b = makeBenchParts(2400, 4, 9);
  CHECK(a.faces == b.faces);
  CHECK(a.keyCount() == 4);
  for (int j = 0; j < 4; ++j) CHECK(a.keys[j].positions == b.keys[j].positions);
  CHECK(a.faces != makeBenchParts(2400, 4, 10).faces);

  // The balls against the body beside them: up to 60 degrees of their own, and some ten by which the body bends there.
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
