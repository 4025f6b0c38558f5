// Compares samplers, skins and combined motions with poses computed by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "gltf_maker.h"

namespace shapespline::test::gltf_animation_test {

namespace {

constexpr double floatError = 1e-6;

Import sampled(const GltfMaker& maker, const std::vector<double>& times) {
  ImportOptions options;
  options.sampleTimes = times;
  auto result = Files().add("m.glb", maker.glb()).import(options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(*result);
}

Positions moved(const Eigen::Affine3d& transform, Positions points) {
  for (Vec3& p : points) p = transform * p;
  return points;
}

Eigen::Affine3d shift(double x) { return Eigen::Affine3d(Eigen::Translation3d(x, 0, 0)); }

// The box on two joints: its lower half follows joint 1, its upper half joint 2, whose rest position is z = 2.
GltfMaker skinnedFile() {
  GltfMaker maker;
  std::vector<std::uint8_t> joints;
  std::vector<float> weights;
  for (int v = 0; v < 8; ++v) {
    const bool upper = v & 4;
    for (int k = 0; k < 4; ++k)
      joints.push_back(k == 0 ? upper : k == 1 ? !upper : 0), weights.push_back(k == 0 ? 0.75f : k == 1 ? 0.25f : 0);
  }
  std::vector<float> inverse(32, 0);
  for (int j = 0; j < 2; ++j)
    for (int k = 0; k < 4; ++k) inverse[16 * j + 5 * k] = 1;
  inverse[16 + 14] = -2;
  json attributes = {{"POSITION", maker.vectors(boxPose())},
                     {"JOINTS_0", maker.accessor(joints, "VEC4", 4, glUInt8)},
                     {"WEIGHTS_0", maker.accessor(weights, "VEC4", 4, glFloat32)}};
  const int mesh = maker.mesh(attributes, maker.indices(boxFaces()));
  maker.node({{"mesh", mesh}, {"skin", 0}, {"translation", {100, 0, 0}}});  // the node's transform must be ignored
  const int tip = maker.add("nodes", {{"name", "tip"}, {"translation", {0, 0, 2}}});
  const int root = maker.node({{"name", "root"}, {"children", {tip}}});
  maker.add("skins",
            {{"joints", {root, tip}}, {"inverseBindMatrices", maker.accessor(inverse, "MAT4", 16, glFloat32)}});
  return maker;
}

Positions skinnedByHand(const Eigen::Affine3d& root, const Eigen::Affine3d& tip) {
  Positions out = boxPose();
  for (int v = 0; v < 8; ++v) {
    const Vec3 p = out[v], low = root * p, high = root * tip * Eigen::Translation3d(0, 0, -2) * p;
    out[v] = v & 4 ? Vec3(0.75 * high + 0.25 * low) : Vec3(0.75 * low + 0.25 * high);
  }
  return out;
}

}  // namespace

TEST_CASE("linear, step and cubic samplers") {
  GltfMaker maker = boxFile();
  const int times = maker.scalars({1, 3});
  const int values = maker.vectors({{0, 0, 0}, {8, 0, 0}});
  // In-tangent, value, out-tangent at each time.
  const int cubic = maker.vectors({{9, 9, 9}, {0, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {8, 0, 0}, {9, 9, 9}});
  const auto at = [&](const char* interpolation, double t) {
    GltfMaker file = maker;
    file.animation("move", 0, "translation", times, interpolation[0] == 'C' ? cubic : values, interpolation);
    return sampled(file, {t, t + 100}).keyframes.keys[0].positions[0].x();
  };
  CHECK(at("LINEAR", 1.5) == doctest::Approx(2));
  CHECK(at("STEP", 1.5) == 0);
  CHECK(at("STEP", 2.999) == 0);
  CHECK(at("STEP", 3) == doctest::Approx(8));
  CHECK(at("LINEAR", 0) == 0);  // constant before the first key
  CHECK(at("LINEAR", 50) == doctest::Approx(8));
  // s = 1/4, length 2: h00 * 0 + h10 * 2 * 2 + h01 * 8 + h11 * 2 * -1
  const double s = 0.25, h10 = s * s * s - 2 * s * s + s, h01 = 3 * s * s - 2 * s * s * s, h11 = s * s * s - s * s;
  CHECK(at("CUBICSPLINE", 1.5) == doctest::Approx(4 * h10 + 8 * h01 - 2 * h11));
  CHECK(at("CUBICSPLINE", 3) == doctest::Approx(8));
}

TEST_CASE("equal times are a cut: the earlier value before, the later value from then on, one key there") {
  const auto warningsOf = [](const Import& import) {
    return std::count_if(import.warnings.begin(), import.warnings.end(),
                         [](const Warning& warning) { return warning.code == "animation-cut"; });
  };
  const auto at = [&](const std::vector<float>& times, const Positions& values, const char* interpolation, double t) {
    GltfMaker file = boxFile();
    file.animation("move", 0, "translation", file.scalars(times), file.vectors(values), interpolation);
    const Import import = sampled(file, {t, t + 100});
    CHECK(import.animations[0].keys == 3);
    CHECK(warningsOf(import) == 1);
    return import.keyframes.keys[0].positions[0].x();
  };
  const Vec3 o = Vec3::Zero();
  const Positions two = {{0, 0, 0}, {2, 0, 0}, {6, 0, 0}, {8, 0, 0}};
  const Positions three = {{0, 0, 0}, {2, 0, 0}, {90, 0, 0}, {6, 0, 0}, {8, 0, 0}};
  Positions cubic;
  for (const Vec3& value : two) cubic.insert(cubic.end(), {o, value, o});
  for (const auto& [times, values, interpolation] : {std::tuple(std::vector<float>{0, 1, 1, 2}, two, "LINEAR"),
                                                     {{0, 1, 1, 1, 2}, three, "LINEAR"},
                                                     {{0, 1, 1, 2}, cubic, "CUBICSPLINE"},
                                                     {{0, 1, 1, 1, 2}, three, "STEP"}}) {
    CAPTURE(interpolation);
    CHECK(at(times, values, interpolation, 1 - 1e-7) == doctest::Approx(interpolation[0] == 'S' ? 0 : 2));
    CHECK(at(times, values, interpolation, 1) == doctest::Approx(6));
    CHECK(at(times, values, interpolation, 2) == doctest::Approx(8));
  }
  // The key times of morph weights are keys: one at the cut.
  GltfMaker morph = morphFile({0, 1});
  morph.animation("cut", 0, "weights", morph.scalars({0, 0.5f, 0.5f, 1}), morph.scalars({0, 0.25f, 1, 0.5f}));
  auto import = Files().add("m.glb", morph.glb()).import();
  REQUIRE(import.ok());
  REQUIRE(import->keyframes.keyCount() == 3);
  CHECK(import->keyframes.keys[1].time == 0.5);
  CHECK(distance(import->keyframes.keys[1].positions, boxPose(1)) < floatError);
  CHECK(warningsOf(*import) == 1);
}

TEST_CASE("rotations are interpolated on the sphere, along the shorter arc, also from normalised integers") {
  GltfMaker maker = boxFile();
  const int times = maker.scalars({0, 1});
  const float h = std::sqrt(0.5f);
  const auto expected = moved(Eigen::Affine3d(Eigen::AngleAxisd(std::numbers::pi / 6, Vec3::UnitZ())), boxPose());
  for (float sign : {1.0f, -1.0f}) {
    GltfMaker file = maker;
    file.animation("turn", 0, "rotation", times,
                   file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, sign * h, sign * h}, "VEC4", 4, glFloat32));
    CHECK(distance(sampled(file, {1 / 3.0, 1}).keyframes.keys[0].positions, expected) < floatError);
  }
  GltfMaker file = maker;
  const std::int16_t q = static_cast<std::int16_t>(std::lround(32767 * h));
  file.animation("turn", 0, "rotation", times,
                 file.accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, q, q}, "VEC4", 4, glInt16, true));
  CHECK(distance(sampled(file, {1 / 3.0, 1}).keyframes.keys[0].positions, expected) < 1e-4);  // 15 bits of precision
}

TEST_CASE("a skin: joints count, the mesh node's own transform does not") {
  GltfMaker maker = skinnedFile();
  const float h = std::sqrt(0.5f);
  maker.animation("bend", 1, "rotation", maker.scalars({0, 2}),
                  maker.accessor(std::vector<float>{0, 0, 0, 1, h, 0, 0, h}, "VEC4", 4, glFloat32));
  const Import import = sampled(maker, {0, 1});
  const Eigen::Affine3d tip = Eigen::Translation3d(0, 0, 2) * Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX());
  CHECK(distance(import.keyframes.keys[0].positions, boxPose()) < floatError);
  CHECK(distance(import.keyframes.keys[1].positions, skinnedByHand(Eigen::Affine3d::Identity(), tip)) < floatError);
}

TEST_CASE("an animation of a file without a mesh moves the bones with its names") {
  const GltfMaker character = skinnedFile();
  GltfMaker walk;
  const float h = std::sqrt(0.5f);
  const int tip = walk.node({{"name", "tip"}});
  walk.animation("walk", tip, "rotation", walk.scalars({0, 2}),
                 walk.accessor(std::vector<float>{0, 0, 0, 1, h, 0, 0, h}, "VEC4", 4, glFloat32));
  const Eigen::Affine3d turned = Eigen::Translation3d(0, 0, 2) * Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX());
  const Positions expected = skinnedByHand(Eigen::Affine3d::Identity(), turned);
  ImportOptions some, named;
  some.sampleCount = 3, some.sampleAsked = true;
  named.animation = std::string("walk");
  for (const ImportOptions& options : {ImportOptions(), some, named}) {
    const Files files = Files().add("walk.glb", walk.glb()).add("character.glb", character.glb());
    const auto import = files.import(options);
    REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
    CHECK(import->animations[0].name == "walk");
    CHECK(distance(import->keyframes.keys.back().positions, expected) < floatError);
  }
  const auto alone = Files().add("walk.glb", walk.glb()).import();
  REQUIRE(!alone.ok());
  CHECK(alone.error().message ==
        "walk.glb has an animation but no mesh. Open it together with the GLB of its character, or export both as one "
        "GLB (with skin).");
  walk.doc["nodes"][0]["name"] = "Hips";
  const auto other = Files().add("walk.glb", walk.glb()).add("character.glb", character.glb()).import();
  REQUIRE(!other.ok());
  CHECK(other.error().message.find("bones that character.glb does not have: \"Hips\"") != std::string::npos);
}

TEST_CASE("skin, node transform and morph weights move together") {
  GltfMaker maker = skinnedFile();
  const json target = {{"POSITION", maker.vectors(Positions(8, Vec3(0, 1, 0)))}};
  maker.doc["meshes"][0]["primitives"][0]["targets"] =
      json::array({target});  // some compilers treat {target} alone as a copy
  const int times = maker.scalars({0, 1});
  const int animation = maker.animation("all", 0, "weights", times, maker.scalars({0, 1}));
  const auto channel = [&](int node, const char* path, int values) {
    auto& a = maker.doc["animations"][animation];
    a["samplers"].push_back({{"input", times}, {"output", values}});
    a["channels"].push_back({{"sampler", a["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  channel(2, "translation", maker.vectors({{0, 0, 0}, {4, 0, 0}}));  // the root
  channel(1, "scale", maker.vectors({{1, 1, 1}, {3, 1, 1}}));        // the tip
  const Import import = sampled(maker, {0, 0.5});
  Eigen::Affine3d tip = Eigen::Affine3d(Eigen::Translation3d(0, 0, 2));
  tip.scale(Vec3(2, 1, 1));
  Positions expected = skinnedByHand(shift(2), tip);
  for (Vec3& p : expected) p.y() += 0.5;  // y is kept by both joints
  CHECK(distance(import.keyframes.keys[1].positions, expected) < floatError);
  SUBCASE("such an animation is sampled 8 times by default") {
    const auto result = Files().add("m.glb", maker.glb()).import();
    REQUIRE(result.ok());
    CHECK(result->keyframes.keyCount() == 8);
  }
}

TEST_CASE("weights that do not sum to one are scaled, unused joints are ignored") {
  GltfMaker maker = skinnedFile();
  auto* weights = reinterpret_cast<float*>(maker.bin.data() + maker.doc["bufferViews"][3]["byteOffset"].get<int>());
  // The views have positions, joints and weights in an unknown order, so find the 32 floats.
  for (const auto& view : maker.doc["bufferViews"])
    if (view["byteLength"] == 128) {
      auto* f = reinterpret_cast<float*>(maker.bin.data() + view["byteOffset"].get<int>());
      if (f[0] == 0.75f) weights = f;
    }
  REQUIRE(weights[0] == 0.75f);
  for (int i = 0; i < 32; ++i) weights[i] *= 2;
  for (const auto& view : maker.doc["bufferViews"])
    if (view["byteLength"] == 32)
      for (int v = 0; v < 8; ++v) maker.bin[view["byteOffset"].get<int>() + 4 * v + 3] = 200;
  const auto result = Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).import();
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  CHECK(distance(result->keyframes.keys[0].positions, boxPose()) < floatError);
}

TEST_CASE("more than four joints per vertex") {
  GltfMaker maker = skinnedFile();
  auto& attributes = maker.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] = maker.accessor(std::vector<std::uint16_t>(32, 1), "VEC4", 4, glUInt16);
  std::vector<float> weights(32, 0);
  for (int v = 0; v < 8; ++v) weights[4 * v] = 1;  // half of the total weight now follows the tip
  attributes["WEIGHTS_1"] = maker.accessor(weights, "VEC4", 4, glFloat32);
  maker.doc["nodes"][1]["translation"] = {0, 0, 4};
  const auto result = Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).import();
  REQUIRE(result.ok());
  CHECK(result->keyframes.keys[0].positions[0].z() == doctest::Approx(2 * (0.5 + 0.125)));
  CHECK(result->keyframes.keys[0].positions[4].z() == doctest::Approx(2 + 2 * (0.5 + 0.375)));
}

TEST_CASE("an animated node with a matrix starts from the matrix") {
  GltfMaker maker = boxFile();
  const Eigen::Affine3d start = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) *
                                Eigen::Scaling(Vec3(1, 2, 0.5));
  maker.doc["nodes"][0]["matrix"] = std::vector<double>(start.matrix().data(), start.matrix().data() + 16);
  maker.animation("move", 0, "translation", maker.scalars({0, 1}), maker.vectors({{1, 2, 3}, {5, 2, 3}}));
  const Import import = sampled(maker, {0, 1});
  CHECK(distance(import.keyframes.keys[0].positions, moved(start, boxPose())) < floatError);
  CHECK(distance(import.keyframes.keys[1].positions, moved(shift(4) * start, boxPose())) < floatError);
}

TEST_CASE("animations that move nothing of the mesh are not offered") {
  GltfMaker maker = morphFile({0, 1});
  const int camera = maker.node({{"name", "camera"}});
  maker.animation("camera", camera, "translation", maker.scalars({0, 1}), maker.vectors({{0, 0, 0}, {1, 0, 0}}));
  const auto result = Files().add("m.glb", maker.glb()).import();
  REQUIRE(result.ok());
  CHECK(result->animations.empty());
  CHECK(result->keyframes.keyCount() == 2);
  ImportOptions options;
  options.animation = 0;
  CHECK(Files().add("m.glb", maker.glb()).import(options).error().code == ErrorCode::UnknownAnimation);
}

TEST_CASE("several files without an animation are keys; a warning states that nothing is sampled") {
  ImportOptions name, count, times;
  name.animation = 0;
  count.sampleAsked = true;
  times.sampleTimes = {0, 1};
  for (const ImportOptions& options : {name, count, times}) {
    const auto result = Files().add("a.glb", boxFile().glb()).add("b.glb", boxFile(1).glb()).import(options);
    REQUIRE(!result.ok());
    CHECK(result.error().code == ErrorCode::UnknownAnimation);
    CHECK(result.error().message == "a.glb has no animation that moves its mesh.");
  }
}

TEST_CASE("an import reports its stages") {
  for (const Files& files : {Files().add("a.glb", boxFile().glb()).add("b.glb", boxFile(1).glb()),
                             Files().add("m.glb", morphFile({0, 1, 2}).glb())}) {
    std::vector<NamedBytes> named;
    for (std::size_t i = 0; i < files.names.size(); ++i) named.push_back({files.names[i], files.bytes[i]});
    std::vector<double> fractions;
    REQUIRE(importKeyframes(named, {}, [&](const char* stage, double fraction) {
      CHECK(std::string(stage).size() > 4);
      fractions.push_back(fraction);
    }));
    CHECK(fractions.size() >= 2);
    CHECK(fractions.front() == 0);
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    CHECK(fractions.back() < 1);
  }
}

TEST_CASE("sample times beyond the animation are clamped, with a warning") {
  GltfMaker maker = boxFile();
  maker.animation("move", 0, "translation", maker.scalars({0, 1}), maker.vectors({{0, 0, 0}, {1, 0, 0}}));
  const Import import = sampled(maker, {0.5, 9});
  REQUIRE(!import.warnings.empty());
  CHECK(import.warnings[0].code == "sample-outside-animation");
  CHECK(sampled(maker, {1.0 / 3, 0.5}).keyframes.keys[0].name == "0.333 s");
  ImportOptions options;
  options.sampleTimes = {0.5, 0.25};
  CHECK(Files().add("m.glb", maker.glb()).import(options).error().code == ErrorCode::TimesNotIncreasing);
  options.sampleTimes = {};
  options.sampleAsked = true;
  for (int count : {-1, 0, 1}) {
    options.sampleCount = count;
    CHECK(Files().add("m.glb", maker.glb()).import(options).error().code == ErrorCode::TooFewKeys);
  }
  options.sampleCount = 2'000'000'000;
  CHECK(Files().add("m.glb", maker.glb()).import(options).error().code == ErrorCode::TooLarge);
}

}  // namespace shapespline::test::gltf_animation_test
