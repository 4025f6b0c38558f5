// Checks which animations of a glTF file play together, against poses computed by hand.
#include <doctest/doctest.h>

#include "gltf_maker.h"

namespace shapespline::test::gltf_together_test {

namespace {

constexpr double floatError = 1e-6;

// Boxes side by side, one node each. Box k is vertices 8 k to 8 k + 7.
GltfMaker boxes(int count) {
  GltfMaker maker;
  const int mesh = maker.mesh({{"POSITION", maker.vectors(boxPose())}}, maker.indices(boxFaces()));
  for (int k = 0; k < count; ++k) maker.node({{"mesh", mesh}, {"name", "box " + std::to_string(k)}});
  return maker;
}

// Moves a node from its place by 1 along x, from `start` to `end`.
void move(GltfMaker& maker, const char* name, int node, float start = 0, float end = 1) {
  maker.animation(name, node, "translation", maker.scalars({start, end}), maker.vectors({{0, 0, 0}, {1, 0, 0}}));
}

struct Taken {
  Import import;
  std::vector<double> moved;  // distance of each box at the last key
};

Result<Import> read(const GltfMaker& maker, const ImportOptions& options) {
  return Files().add("m.glb", maker.glb()).import(options);
}

Taken taken(const GltfMaker& maker, const ImportOptions& options = {}) {
  auto import = read(maker, options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  Taken out{std::move(*import), {}};
  const auto& keys = out.import.keyframes.keys;
  for (std::size_t v = 0; v < keys[0].positions.size(); v += 8)
    out.moved.push_back(keys.back().positions[v].x() - boxPose()[0].x());
  return out;
}

const Warning* warningOf(const Import& import, const std::string& code) {
  for (const Warning& warning : import.warnings)
    if (warning.code == code) return &warning;
  return nullptr;
}

using Moved = std::vector<double>;

}  // namespace

TEST_CASE("animations of different objects play together if start and length agree") {
  GltfMaker maker = boxes(3);
  for (int k = 0; k < 3; ++k) move(maker, ("action " + std::to_string(k)).c_str(), k);
  const Taken all = taken(maker);
  CHECK(all.moved == Moved{1, 1, 1});
  CHECK(all.import.animation == 3);
  REQUIRE(all.import.animations.size() == 4);
  CHECK(all.import.animations[3].together == std::vector<int>{0, 1, 2});
  CHECK(all.import.animations[3].name == "action 0 + action 1 + action 2");
  CHECK(warningOf(all.import, "other-animations") == nullptr);
  // A choice keeps its meaning.
  ImportOptions one;
  one.animation = 1;
  CHECK(taken(maker, one).moved == Moved{0, 1, 0});
  one.animation = std::string("action 2");
  CHECK(taken(maker, one).moved == Moved{0, 0, 1});
}

TEST_CASE("animations of equal names play together, whatever their lengths; the short one holds its end") {
  GltfMaker maker = boxes(2);
  move(maker, "walk", 0, 0, 1);
  move(maker, "walk", 1, 0, 2);
  ImportOptions options;
  options.sampleTimes = {0, 1, 2};
  const Taken both = taken(maker, options);
  CHECK(both.moved == Moved{1, 1});
  CHECK(both.import.keyframes.keys[1].positions[0].x() == doctest::Approx(1));
  CHECK(both.import.keyframes.keys[1].positions[8].x() == doctest::Approx(0.5));
}

TEST_CASE("animations of other objects with other times are left out with a warning, and --animation all adds them") {
  GltfMaker maker = boxes(3);
  move(maker, "arm", 0);
  move(maker, "ball", 1, 0, 2);
  move(maker, "lid", 2, 0.5, 1.5);
  const Taken first = taken(maker);
  CHECK(first.moved == Moved{1, 0, 0});
  const Warning* warning = warningOf(first.import, "other-animations");
  REQUIRE(warning);
  CHECK(warning->message.find("\"ball\", \"lid\"") != std::string::npos);
  CHECK(warning->message.find("--animation all") != std::string::npos);
  ImportOptions options;
  options.animation = std::string("all");
  const Taken all = taken(maker, options);
  CHECK(all.moved == Moved{1, 1, 1});
  CHECK(all.import.keyframes.keys.back().time == 2);
  CHECK(warningOf(all.import, "other-animations") == nullptr);
}

TEST_CASE("animations that move the same path of a node are alternatives") {
  GltfMaker maker = boxes(2);
  move(maker, "walk", 0);
  move(maker, "run", 0);
  move(maker, "lid", 1, 0, 3);
  const Taken first = taken(maker);
  CHECK(first.moved == Moved{1, 0});
  CHECK(first.import.animations.size() == 3);
  const Warning* warning = warningOf(first.import, "other-animations");
  REQUIRE(warning);
  CHECK(warning->message.find("run") == std::string::npos);
  CHECK(warning->message.find("--animation all") == std::string::npos);
  ImportOptions options;
  options.animation = std::string("all");
  const auto refused = read(maker, options);
  REQUIRE(!refused.ok());
  CHECK(refused.error().code == ErrorCode::UnknownAnimation);
  CHECK(refused.error().message.find("0 \"walk\", 1 \"run\", 2 \"lid\"") != std::string::npos);
  // An animation may have this name.
  maker.doc["animations"][1]["name"] = "all";
  CHECK(taken(maker, options).import.animation == 1);
}

TEST_CASE("alternatives of all objects are not reported as left out, and only offered together if they can be") {
  GltfMaker maker = boxes(2);
  for (const char* name : {"walk", "run"})
    for (int k = 0; k < 2; ++k) move(maker, name, k);
  const Taken walk = taken(maker);
  CHECK(walk.moved == Moved{1, 1});
  CHECK(warningOf(walk.import, "other-animations") == nullptr);
  ImportOptions options;
  options.animation = 9;
  const auto refused = read(maker, options);
  REQUIRE(!refused.ok());
  CHECK(refused.error().message.find("or all") == std::string::npos);
}

TEST_CASE("shape keys play with the action of their object, and a still action joins them") {
  GltfMaker maker = morphFile({0, 1});
  maker.node({{"mesh", 0}});
  maker.animation("object", 0, "rotation", maker.scalars({0, 1}),
                  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4, glFloat32));
  maker.animation("shape", 0, "weights", maker.scalars({0, 1}), maker.scalars({0, 1}));
  maker.animation("still", 1, "translation", maker.scalars({0, 1}), maker.vectors({{7, 0, 0}, {7, 0, 0}}));
  const Taken all = taken(maker);
  CHECK(all.import.animations.back().together == std::vector<int>{0, 1, 2});
  Positions expected = boxPose(1);
  for (Vec3& p : expected) p = Vec3(-p.x(), -p.y(), p.z());
  const Positions& last = all.import.keyframes.keys.back().positions;
  CHECK(distance(Positions(last.begin(), last.begin() + 8), expected) < floatError);
  CHECK(last[8].x() == doctest::Approx(7));
}

TEST_CASE("clips of one skeleton are alternatives, even if they move different bones") {
  GltfMaker maker = boxes(1);
  const int tip = maker.add("nodes", {{"name", "tip"}});
  const int root = maker.node({{"name", "root"}, {"children", {tip}}});
  maker.add("skins", {{"joints", {root, tip}}});
  maker.doc["nodes"][0]["skin"] = 0;
  std::vector<std::uint8_t> joints(32, 0);
  std::vector<float> weights(32, 0);
  for (int v = 0; v < 8; ++v) joints[4 * v] = v & 4 ? 1 : 0, weights[4 * v] = 1;
  json& attributes = maker.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = maker.accessor(joints, "VEC4", 4, glUInt8);
  attributes["WEIGHTS_0"] = maker.accessor(weights, "VEC4", 4, glFloat32);
  move(maker, "hop", root);
  move(maker, "nod", tip);
  const Taken first = taken(maker);
  CHECK(first.moved == Moved{1});
  CHECK(first.import.animation == 0);
  CHECK(warningOf(first.import, "other-animations") != nullptr);
}

}  // namespace shapespline::test::gltf_together_test
