// Matches objects of several poses, in any file order.
#include <doctest/doctest.h>

#include <algorithm>

#include "gltf_maker.h"

namespace shapespline::test::objects_test {

namespace {

// A box or a pyramid with a position and names.
struct Object {
  std::string node, mesh;
  Vec3 at;
  bool pyramid = false;
};

Positions corners(const Object& object) {
  Positions out = boxPose();
  if (object.pyramid) out = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.5, 1.5}};
  for (Vec3& p : out) p += object.at;
  return out;
}

const std::vector<Triangle>& facesOf(const Object& object) {
  static const std::vector<Triangle> pyramid{{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return object.pyramid ? pyramid : boxFaces();
}

// `moved` transforms all objects.
GltfMaker glbOf(const std::vector<Object>& objects, const Eigen::Affine3d& moved = Eigen::Affine3d::Identity()) {
  GltfMaker maker;
  for (const Object& object : objects) {
    Positions positions = corners(object);
    for (Vec3& p : positions) p = moved * p;
    const int vertices = maker.vectors(positions), indices = maker.indices(facesOf(object));
    const int mesh = maker.mesh({{"POSITION", vertices}}, indices);
    if (!object.mesh.empty()) maker.doc["meshes"][mesh]["name"] = object.mesh;
    json node = {{"mesh", mesh}};
    if (!object.node.empty()) node["name"] = object.node;
    maker.node(node);
  }
  return maker;
}

std::string objOf(const std::vector<Object>& objects, const Vec3& shift) {
  std::string out;
  int before = 1;
  for (const Object& object : objects) {
    if (!object.node.empty()) out += "o " + object.node + "\n";
    const Positions positions = corners(object);
    for (const Vec3& p : positions) {
      out += "v";
      for (int c = 0; c < 3; ++c) out += " " + std::to_string(p[c] + shift[c]);
      out += "\n";
    }
    for (const Triangle& f : facesOf(object)) {
      out += "f";
      for (int v : f) out += " " + std::to_string(before + v);
      out += "\n";
    }
    before += static_cast<int>(positions.size());
  }
  return out;
}

Import imported(const Files& files) {
  auto result = files.import();
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(*result);
}

// The second key is the first key, moved, so every object is matched correctly.
void checkMoved(const Import& import, const Eigen::Affine3d& moved) {
  Positions wanted = import.keyframes.keys[0].positions;
  for (Vec3& p : wanted) p = moved * p;
  CHECK(distance(import.keyframes.keys[1].positions, wanted) < 1e-5);
}

std::string rules(const Import& import) {
  std::string out;
  for (const MatchedObject& match : import.matches) out += "nso"[static_cast<int>(match.rule)];
  return out;
}

const Eigen::Affine3d shiftBy(Eigen::Translation3d(1, 0.5, 0.25));

const Object leftBox{"EyeL", "", {-3, 0, 0}}, rightBox{"EyeR", "", {3, 0, 0}}, hatObject{"Hat", "", {0, 0, 5}, true};

Import joined(const std::vector<Object>& first, const std::vector<Object>& second,
              const Eigen::Affine3d& moved = shiftBy) {
  return imported(Files().add("a.glb", glbOf(first).glb()).add("b.glb", glbOf(second, moved).glb()));
}

}  // namespace

TEST_CASE("named objects are matched by name, in any order") {
  const Import eyes = joined({leftBox, rightBox}, {rightBox, leftBox});
  checkMoved(eyes, shiftBy);
  CHECK(rules(eyes) == "nn");
  CHECK(eyes.matches[0].key == 1);
  CHECK(eyes.matches[0].object == "EyeL");
  CHECK(eyes.matches[0].found == "EyeL");
  const Import all = joined({leftBox, hatObject, rightBox}, {hatObject, rightBox, leftBox});
  checkMoved(all, shiftBy);
  CHECK(rules(all) == "nnn");
}

TEST_CASE("objects of OBJ files are matched by name as well, and keep those of the first file") {
  const Import import =
      imported(Files()
                   .add("a.obj", bytesOf(objOf({hatObject, leftBox, rightBox}, Vec3::Zero())))
                   .add("b.obj", bytesOf(objOf({rightBox, hatObject, leftBox}, shiftBy.translation()))));
  checkMoved(import, shiftBy);
  CHECK(rules(import) == "nnn");
  REQUIRE(import.scene.objects.size() == 3);
  CHECK(import.scene.objects[1].name == "EyeL");
  CHECK(import.scene.objects[1].start == 6);
  CHECK(import.scene.objects[1].count == 12);
}

TEST_CASE("one of several similar objects can be renamed: the others are matched by name") {
  const auto eye = [](const char* name, double x) { return Object{name, "", {x, x * x, 0}}; };
  const auto third = eye("Third", 1), other = eye("Other", 1);
  const Import alike = joined({leftBox, rightBox, third}, {rightBox, other, leftBox});
  checkMoved(alike, shiftBy);
  CHECK(rules(alike) == "nns");
  const Import unlike = joined({leftBox, rightBox, hatObject}, {rightBox, {"Cap", "", {0, 0, 5}, true}, leftBox});
  checkMoved(unlike, shiftBy);
  CHECK(rules(unlike) == "nns");
  const Import apart = joined({leftBox, rightBox, hatObject}, {rightBox, {"Box", "", {0, 0, 5}}, leftBox});
  checkMoved(apart, shiftBy);
  CHECK(apart.keyframes.vertexCount() == 16);
}

TEST_CASE("names of meshes are used if nodes have none, and trailing numbers are ignored") {
  const auto eye = [](const char* node, const char* mesh, double x) { return Object{node, mesh, {x, 0, 0}}; };
  checkMoved(joined({eye("", "L", -3), eye("", "R", 3)}, {eye("", "R", 3), eye("", "L", -3)}), shiftBy);
  checkMoved(joined({eye("L", "", -3), eye("R", "", 3)}, {eye("", "R", 3), eye("", "L", -3)}), shiftBy);
  checkMoved(joined({eye("node", "L", -3), eye("node", "R", 3)}, {eye("node", "R", 3), eye("node", "L", -3)}), shiftBy);
  checkMoved(joined({eye("L", "", -3), eye("R", "", 3)}, {eye("R.001", "", 3), eye("L.001", "", -3)}), shiftBy);
  checkMoved(joined({eye("Cube", "", -3), eye("Cube.001", "", 3)}, {eye("Cube.001", "", 3), eye("Cube", "", -3)}),
             shiftBy);
  checkMoved(joined({eye("\xe5\xb7\xa6", "", -3), eye("\xd0\x93", "", 3)},
                    {eye("\xd0\x93", "", 3), eye("\xe5\xb7\xa6", "", -3)}),
             shiftBy);
}

TEST_CASE("objects without names are matched by shape, and similar ones by position") {
  const auto plain = [](double x, bool pyramid = false) { return Object{"", "", {x, 0, 0}, pyramid}; };
  const Import shapes = joined({plain(-3), plain(0, true)}, {plain(0, true), plain(-3)});
  checkMoved(shapes, shiftBy);
  CHECK(rules(shapes) == "ss");
  checkMoved(joined({plain(-3), plain(3)}, {plain(3), plain(-3)}), shiftBy);
  checkMoved(joined({plain(-3), plain(0, true), plain(3)}, {plain(3), plain(-3), plain(0, true)}), shiftBy);
  // One file has more objects, whose default numbers differ.
  checkMoved(joined({plain(-3)}, {plain(0, true), plain(-3)}), shiftBy);
  // Both have one name.
  const Object left{"Eye", "", {-3, 0, 0}}, right{"Eye", "", {3, 0, 0}};
  checkMoved(joined({left, right}, {right, left}), shiftBy);
  // Every file uses different names.
  const Object other{"A", "", {-3, 0, 0}}, another{"B", "", {3, 0, 0}};
  checkMoved(joined({leftBox, rightBox}, {another, other}), shiftBy);
}

TEST_CASE("a rotation of the whole does not swap similar objects") {
  const auto plain = [](double x) { return Object{"", "", {x, 0, 0}}; };
  const Eigen::Affine3d turned(Eigen::AngleAxisd(3.14159, Vec3::UnitZ()));
  checkMoved(joined({plain(-3), plain(3)}, {plain(-3), plain(3)}, turned), turned);
  checkMoved(joined({plain(-3), plain(3)}, {plain(3), plain(-3)}, turned), turned);
}

TEST_CASE("automatic names do not prevent matching by shape") {
  const Object body{"Cube", "", {0, 0, 0}}, hat{"Cube.001", "", {0, 0, 5}, true};
  const Object otherBody{"Cube.001", "", {0, 0, 0}}, otherHat{"Cube", "", {0, 0, 5}, true};
  checkMoved(joined({body, hat}, {otherHat, otherBody}), shiftBy);
  checkMoved(joined({body, hat}, {otherBody, otherHat}), shiftBy);
}

TEST_CASE("names of parent nodes distinguish objects with the same name") {
  const auto nested = [](const std::vector<std::pair<std::string, double>>& sides, const Vec3& shift) {
    GltfMaker maker;
    for (const auto& [name, x] : sides) {
      Positions positions = corners({"", "", Vec3(x, 0, 0) + shift});
      const int mesh = maker.mesh({{"POSITION", maker.vectors(positions)}}, maker.indices(boxFaces()));
      const int eye = maker.add("nodes", {{"name", "Eye"}, {"mesh", mesh}});
      maker.node({{"name", name}, {"children", {eye}}});
    }
    return maker.glb();
  };
  // Positions alone would give the opposite match, because the objects change sides.
  const Import import = imported(Files()
                                     .add("a.glb", nested({{"left", -3}, {"right", 3}}, Vec3::Zero()))
                                     .add("b.glb", nested({{"right", -3}, {"left", 3}}, Vec3::Zero())));
  CHECK(rules(import) == "nn");
  CHECK(import.keyframes.keys[1].positions[0].x() == doctest::Approx(3));
}

TEST_CASE("a chosen object is found in files with other names") {
  ImportOptions options;
  options.objects = {"EyeL"};
  const Object renamed{"EyeL.002", "", {-3, 0, 0}};
  const auto import = Files()
                          .add("a.glb", glbOf({leftBox, hatObject}).glb())
                          .add("b.glb", glbOf({hatObject, renamed}, shiftBy).glb())
                          .import(options);
  REQUIRE(import.ok());
  CHECK(import->keyframes.vertexCount() == 8);
  checkMoved(*import, shiftBy);
}

TEST_CASE("a further pose is matched with the objects of its mesh") {
  const Import mesh = joined({leftBox, rightBox}, {leftBox, rightBox});
  ImportOptions options;
  options.like = mesh.keyframes.faces;
  options.likePose = mesh.keyframes.keys[0].positions;
  options.likeObjects = mesh.scene.objects;
  const Bytes pose = glbOf({rightBox, leftBox}, shiftBy).glb();
  const auto further = Files().add("c.glb", pose).add("c.glb", pose).import(options);
  REQUIRE(further.ok());
  CHECK(distance(further->keyframes.keys[0].positions, mesh.keyframes.keys[1].positions) < 1e-5);
}

TEST_CASE("groups count as objects, and can share vertices") {
  const auto file = [](bool swapped, double up) {
    const std::string z = " " + std::to_string(up) + "\n";
    const std::string left = "g left\nf 1 2 5\nf 1 5 4\n", right = "g right\nf 2 3 6\nf 2 6 5\n";
    return "v 0 0 0\nv 1 0" + z + "v 2 0 0\nv 0 1 0\nv 1 1" + z + "v 2 1 0\n" + (swapped ? right + left : left + right);
  };
  const Import import =
      imported(Files().add("a.obj", bytesOf(file(false, 0.1))).add("b.obj", bytesOf(file(true, 0.7))));
  CHECK(import.keyframes.vertexCount() == 6);
  CHECK(import.keyframes.keys[1].positions[1].z() == doctest::Approx(0.7));
  CHECK(import.keyframes.keys[1].positions[0].x() == 0);
  CHECK(import.keyframes.keys[1].positions[2].x() == 2);
}

TEST_CASE("many objects without names do not take quadratic time") {
  // Few similar objects are compared in pairs. For many, the file order decides.
  const auto file = [](int count) {
    GltfMaker maker;
    const Object small{"", "", {0, 0, 0}, true};
    const int vertices = maker.vectors(corners(small)), indices = maker.indices(facesOf(small));
    const int mesh = maker.mesh({{"POSITION", vertices}}, indices);
    for (int i = 0; i < count; ++i) maker.node({{"mesh", mesh}, {"translation", {2 * i, i % 7, 0}}});
    return maker.glb();
  };
  const Import import = imported(Files().add("a.glb", file(3000)).add("b.glb", file(3000)));
  CHECK(import.matches.size() == 1000);
  CHECK(import.keyframes.keys[0].positions == import.keyframes.keys[1].positions);
}

}  // namespace shapespline::test::objects_test
