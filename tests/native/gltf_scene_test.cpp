// glTF scenes with extensions, joined morph targets, animations that are poses, and excessive sizes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "gltf_maker.h"
#include "io/gltf/gltf_extensions.h"

namespace shapespline::test::gltf_scene_test {

namespace {

Result<Import> tried(const GltfMaker& maker, const ImportOptions& options = {}) {
  return Files().add("m.glb", maker.glb()).import(options);
}

Import imported(const GltfMaker& maker, const ImportOptions& options = {}) {
  auto result = tried(maker, options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(*result);
}

ImportOptions at(std::vector<double> times) {
  ImportOptions options;
  options.sampleTimes = std::move(times);
  return options;
}

std::string messageOf(const Result<Import>& result) { return result ? "" : result.error().message; }

const Warning* warningOf(const Import& import, const std::string& code) {
  const auto found = std::find_if(import.warnings.begin(), import.warnings.end(),
                                  [&](const Warning& warning) { return warning.code == code; });
  return found == import.warnings.end() ? nullptr : &*found;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

json pointerTo(const std::string& pointer) {
  return {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}};
}

// An animation with one channel, whose target is a pointer.
void addPointer(GltfMaker& maker, const std::string& pointer, int times, int values, const char* how = "LINEAR") {
  maker.add("animations", {{"name", "pointed"},
                           {"samplers", {{{"input", times}, {"output", values}, {"interpolation", how}}}},
                           {"channels", {{{"sampler", 0}, {"target", pointerTo(pointer)}}}}});
}

// A box at another position, with visibility.
int addBox(GltfMaker& maker, double x, const char* name, bool visible = true) {
  Positions positions = boxPose();
  for (Vec3& p : positions) p.x() += x;
  const int mesh = maker.mesh({{"POSITION", maker.vectors(positions)}}, maker.indices(boxFaces()));
  json node = {{"mesh", mesh}, {"name", name}};
  if (!visible) node["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
  return maker.node(node);
}

int bytes(GltfMaker& maker, const std::vector<std::uint8_t>& values) {
  return maker.accessor(values, "SCALAR", 1, glUInt8);
}

}  // namespace

TEST_CASE("pointers to a node's translation, rotation and scale move it like its own channels") {
  for (const char* required : {"extensionsUsed", "extensionsRequired"}) {
    GltfMaker maker = boxFile();
    maker.doc[required] = {"KHR_animation_pointer"};
    const int times = maker.scalars({0, 1});
    addPointer(maker, "/nodes/0/translation", times, maker.vectors({{0, 0, 0}, {2, 0, 0}}));
    json& animation = maker.doc["animations"][0];
    const float half = std::sqrt(0.5f);
    animation["samplers"].push_back(
        {{"input", times},
         {"output", maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, half, half}, "VEC4", 4, glFloat32)}});
    animation["samplers"].push_back({{"input", times}, {"output", maker.vectors({{1, 1, 1}, {3, 3, 3}})}});
    animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "rotation"}}}});
    animation["channels"].push_back({{"sampler", 2}, {"target", pointerTo("/nodes/0/scale")}});
    const Import import = imported(maker, at({0, 1}));
    CHECK(import.keyframes.keys[0].positions[7] == Vec3(1, 1, 2));
    // Scaled by 3, rotated by a quarter turn about z, moved by 2.
    CHECK((import.keyframes.keys[1].positions[7] - Vec3(-3 + 2, 3, 6)).norm() < 1e-6);
    CHECK(!warningOf(import, "extension-ignored"));
  }
}

TEST_CASE("pointers to morph weights: of a node, of a mesh, of one target") {
  const auto moved = [](const char* pointer, bool one) {
    GltfMaker maker = morphFile({0, 1, 5});
    addPointer(maker, pointer, maker.scalars({0, 1}), one ? maker.scalars({0, 1}) : maker.scalars({0, 0, 0, 1}));
    return imported(maker, at({0, 1})).keyframes.keys[1].positions;
  };
  for (const char* pointer : {"/nodes/0/weights", "/meshes/0/weights"})
    CHECK(distance(moved(pointer, false), boxPose(5)) < 1e-6);
  for (const char* pointer : {"/nodes/0/weights/1", "/meshes/0/weights/1"})
    CHECK(distance(moved(pointer, true), boxPose(5)) < 1e-6);
}

TEST_CASE("pointers that cannot be followed are named; those of materials are ignored") {
  const auto with = [](const char* pointer) {
    GltfMaker maker = morphFile({0, 1});
    const int times = maker.scalars({0, 1});
    addPointer(maker, pointer, times, maker.scalars({0, 1}));
    return imported(maker);
  };
  const Import matrix = with("/nodes/0/matrix");
  REQUIRE(warningOf(matrix, "pointer-ignored"));
  CHECK(says(warningOf(matrix, "pointer-ignored")->message, "/nodes/0/matrix"));
  CHECK(!warningOf(with("/materials/0/pbrMetallicRoughness/roughnessFactor"), "pointer-ignored"));
  GltfMaker none = boxFile();
  addPointer(none, "/nodes/7/translation", none.scalars({0, 1}), none.vectors({{0, 0, 0}, {1, 0, 0}}));
  CHECK(says(messageOf(tried(none)), "node 7, which does not exist"));
  GltfMaker weight = morphFile({0, 1});
  addPointer(weight, "/nodes/0/weights/4", weight.scalars({0, 1}), weight.scalars({0, 1}));
  CHECK(says(messageOf(tried(weight)), "too few morph targets"));
}

TEST_CASE("hidden nodes and their children are not shown") {
  GltfMaker maker = morphFile({0, 1});
  addBox(maker, 9, "ghost", false);
  const int child = addBox(maker, 20, "child");
  maker.doc["scenes"][0]["nodes"].erase(2);
  maker.doc["nodes"][1]["children"] = {child};
  const Import import = imported(maker);
  CHECK(import.keyframes.vertexCount() == 8);
  CHECK(import.objects == std::vector<std::string>{"mesh 0"});
  const auto pose = Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).import();
  REQUIRE(pose.ok());
  CHECK(pose->keyframes.vertexCount() == 8);
}

TEST_CASE("a file with hidden meshes only gives an error") {
  GltfMaker maker = morphFile({0, 1});
  maker.doc["nodes"][0]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}}};
  CHECK(says(messageOf(tried(maker)), "only hidden meshes (KHR_node_visibility)"));
}

TEST_CASE("if visibility changes, the first key decides, with a warning") {
  GltfMaker maker = boxFile();
  addBox(maker, 9, "lamp", false);
  const int times = maker.scalars({0, 1});
  addPointer(maker, "/nodes/1/extensions/KHR_node_visibility/visible", times, bytes(maker, {1, 0}), "STEP");
  json& animation = maker.doc["animations"][0];
  animation["samplers"].push_back({{"input", times}, {"output", maker.vectors({{0, 0, 0}, {2, 0, 0}})}});
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "translation"}}}});
  const Import shown = imported(maker, at({0, 0.5, 1}));
  CHECK(shown.keyframes.vertexCount() == 16);
  REQUIRE(warningOf(shown, "visibility-changes"));
  CHECK(warningOf(shown, "visibility-changes")->count == 1);
  const Import before = imported(maker, at({0, 0.5}));
  CHECK(!warningOf(before, "visibility-changes"));
  const Import hidden = imported(maker, at({1, 2}));
  CHECK(hidden.keyframes.vertexCount() == 8);
  CHECK(!warningOf(hidden, "visibility-changes"));
}

TEST_CASE("each instance of EXT_mesh_gpu_instancing is shown at its position") {
  GltfMaker maker = morphFile({0, 1});
  maker.doc["nodes"][0]["translation"] = {10, 0, 0};
  const float half = std::sqrt(0.5f);
  const int translations = maker.vectors({{0, 0, 0}, {0, 5, 0}}), scales = maker.vectors({{1, 1, 1}, {2, 2, -2}});
  const int rotations = maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, half, half}, "VEC4", 4, glFloat32);
  maker.doc["nodes"][0]["extensions"] = {
      {"EXT_mesh_gpu_instancing",
       {{"attributes", {{"TRANSLATION", translations}, {"SCALE", scales}, {"ROTATION", rotations}}}}}};
  maker.doc["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  const Import import = imported(maker);
  REQUIRE(import.keyframes.vertexCount() == 16);
  CHECK(import.keyframes.keys[0].positions[7] == Vec3(11, 1, 2));
  CHECK((import.keyframes.keys[0].positions[15] - Vec3(10 - 2, 5 + 2, -4)).norm() < 1e-6);
  // The second copy is mirrored, so its faces are reversed.
  const Triangle& first = import.keyframes.faces[0];
  CHECK(import.keyframes.faces[12] == Triangle{first[0] + 8, first[2] + 8, first[1] + 8});
  CHECK(import.scene.objects.size() == 1);
  maker.doc["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = maker.vectors({{1, 1, 1}});
  CHECK(says(messageOf(tried(maker)), "as many elements"));
}

TEST_CASE("ignored extensions that may change the shape are named") {
  const auto with = [](const char* used, const char* onNode) {
    GltfMaker maker = morphFile({0, 1});
    if (*used) maker.doc["extensionsUsed"] = {used};
    if (*onNode) maker.doc["nodes"][0]["extensions"] = {{onNode, {{"x", 1}}}};
    return imported(maker);
  };
  const Import known = with("AGI_articulations", "");
  REQUIRE(warningOf(known, "extension-ignored"));
  CHECK(says(warningOf(known, "extension-ignored")->message, "\"AGI_articulations\""));
  REQUIRE(warningOf(with("ACME_bend", "ACME_bend"), "extension-ignored"));
  CHECK(!warningOf(with("ACME_bend", ""), "extension-ignored"));
  CHECK(!warningOf(with("KHR_lights_punctual", "KHR_lights_punctual"), "extension-ignored"));
  GltfMaker look = morphFile({0, 1});
  look.doc["materials"] = {{{"extensions", {{"ACME_glow", {{"x", 1}}}}}}};
  CHECK(!warningOf(imported(look), "extension-ignored"));
  GltfMaker required = morphFile({0, 1});
  required.doc["extensionsRequired"] = {"AGI_articulations"};
  CHECK(says(messageOf(tried(required)), "needs the glTF extension \"AGI_articulations\""));
}

TEST_CASE("a family of extensions hides none of its names that are listed themselves") {
  const auto all = knownExtensions();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const std::string_view family = all[k].name.substr(0, all[k].name.size() - 1);
      CHECK_MESSAGE(!(all[k].name.ends_with('*') && all[i].name.starts_with(family) && all[i].use == all[k].use),
                    all[i].name);
    }
}

namespace {

// Morph targets of two meshes: each a list of names and bends.
using Targets = std::vector<std::pair<std::string, double>>;

int addMorphMesh(GltfMaker& maker, double x, const Targets& targets, bool named) {
  Positions base = boxPose();
  for (Vec3& p : base) p.x() += x;
  json deltas = json::array(), names = json::array();
  for (const auto& [name, bend] : targets) {
    deltas.push_back({{"POSITION", maker.vectors(difference(boxPose(bend), boxPose()))}});
    names.push_back(name);
  }
  const int mesh = maker.mesh({{"POSITION", maker.vectors(base)}}, maker.indices(boxFaces()), deltas);
  if (named) maker.doc["meshes"][mesh]["extras"] = {{"targetNames", names}};
  return maker.node({{"mesh", mesh}});
}

// Bend of the top of each box in each key.
std::vector<std::pair<double, double>> bends(const Import& import) {
  std::vector<std::pair<double, double>> out;
  for (const Key& key : import.keyframes.keys)
    out.emplace_back(key.positions[4].x() - key.positions[0].x(), key.positions[12].x() - key.positions[8].x());
  return out;
}

std::vector<std::string> names(const Import& import) {
  std::vector<std::string> out;
  for (const Key& key : import.keyframes.keys) out.push_back(key.name);
  return out;
}

}  // namespace

TEST_CASE("morph targets of several meshes are joined by name, and by index without names") {
  GltfMaker maker;
  addMorphMesh(maker, 0, {{"bend", 1}, {"twist", 2}}, true);
  addMorphMesh(maker, 9, {{"twist", 4}, {"only", 8}}, true);
  const Import named = imported(maker);
  CHECK(names(named) == std::vector<std::string>{"base", "bend", "twist", "only"});
  CHECK(bends(named) == std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {2, 4}, {0, 8}});

  GltfMaker half;
  addMorphMesh(half, 0, {{"", 1}, {"", 2}}, false);
  addMorphMesh(half, 9, {{"bend", 4}}, true);
  const Import byIndex = imported(half);
  CHECK(names(byIndex) == std::vector<std::string>{"base", "bend", "target 2"});
  CHECK(bends(byIndex) == std::vector<std::pair<double, double>>{{0, 0}, {1, 4}, {2, 0}});

  GltfMaker twice;
  addMorphMesh(twice, 0, {{"a", 1}, {"a", 2}}, true);
  addMorphMesh(twice, 9, {{"a", 4}, {"a", 8}}, true);
  CHECK(bends(imported(twice)) == std::vector<std::pair<double, double>>{{0, 0}, {1, 4}, {2, 8}});
}

TEST_CASE("names of morph targets in the primitive, in the targets or in the accessors join them too") {
  const auto move = [](const char* place) {
    GltfMaker maker;
    for (const auto& [x, targets] : {std::pair(0, Targets{{"jaw", 1}, {"blink", 2}}), {9, Targets{{"blink", 4}}}}) {
      addMorphMesh(maker, x, targets, false);
      json& primitive = maker.doc["meshes"].back()["primitives"][0];
      for (std::size_t t = 0; t < targets.size(); ++t) {
        json& target = primitive["targets"][t];
        const std::string& name = targets[t].first;
        if (place[0] == 'a') maker.doc["accessors"][target["POSITION"].get<int>()]["name"] = name;
        else if (place[0] == 'p') primitive["extras"]["targetNames"].push_back(name);
        else target[place] = {{"name", name}};
      }
    }
    return maker;
  };
  for (const char* place : {"primitive", "extra", "extras", "accessor"}) {
    CAPTURE(place);
    const Import import = imported(move(place));
    CHECK(names(import) == std::vector<std::string>{"base", "jaw", "blink"});
    CHECK(bends(import) == std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {2, 4}});
  }
  // The mesh's own names come first, and those of the primitive fill gaps.
  GltfMaker both = move("primitive");
  both.doc["meshes"][1]["extras"]["targetNames"] = {"jaw"};
  CHECK(bends(imported(both)) == std::vector<std::pair<double, double>>{{0, 0}, {1, 4}, {2, 0}});
  both.doc["meshes"][1]["extras"]["targetNames"] = {""};
  CHECK(bends(imported(both)) == std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {2, 4}});
  // Names of accessors mean nothing if the program names all accessors.
  GltfMaker numbered = move("accessor");
  for (json& accessor : numbered.doc["accessors"])
    accessor["name"] = "a" + std::to_string(&accessor - &numbered.doc["accessors"][0]);
  CHECK(bends(imported(numbered)) == std::vector<std::pair<double, double>>{{0, 0}, {1, 4}, {2, 0}});
}

TEST_CASE("each node's weights drive its own targets") {
  GltfMaker maker;
  addMorphMesh(maker, 0, {{"bend", 1}, {"twist", 2}}, true);
  addMorphMesh(maker, 9, {{"twist", 4}}, true);
  const int times = maker.scalars({0, 1});
  maker.animation("play", 0, "weights", times, maker.scalars({0, 0, 0, 1}));
  maker.doc["animations"][0]["samplers"].push_back({{"input", times}, {"output", maker.scalars({0, 1})}});
  maker.doc["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 1}, {"path", "weights"}}}});
  CHECK(bends(imported(maker)) == std::vector<std::pair<double, double>>{{0, 0}, {2, 4}});
}

namespace {

// Animates the box's position to these x.
void addMove(GltfMaker& maker, const char* name, const std::vector<double>& xs) {
  std::vector<float> times;
  Positions values;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    times.push_back(0.25f + static_cast<float>(i));
    values.push_back({xs[i], 0, 0});
  }
  maker.animation(name, 0, "translation", maker.scalars(times), maker.vectors(values));
}

std::vector<double> places(const Import& import) {
  std::vector<double> out;
  for (const Key& key : import.keyframes.keys) out.push_back(key.positions[0].x());
  return out;
}

}  // namespace

TEST_CASE("animations of one pose are skipped for the first that moves, and listed") {
  for (const std::vector<double>& still : {std::vector<double>{3}, {3, 3}, {3, 3, 3}}) {
    GltfMaker maker = boxFile();
    maker.add("animations", {{"name", "empty"}, {"samplers", json::array()}, {"channels", json::array()}});
    addMove(maker, "TPose", still);
    addMove(maker, "walk", {0, 4});
    const Import import = imported(maker);
    CHECK(import.animation == 1);
    REQUIRE(import.animations.size() == 2);
    CHECK(import.animations[0].name == "TPose");
    CHECK(import.animations[0].keys == static_cast<int>(still.size()));
    CHECK(!import.animations[0].moves);
    CHECK(import.animations[1].moves);
    CHECK(places(import).back() == doctest::Approx(4));
    for (ImportOptions options : {ImportOptions{}, at({0.25, 1})}) {
      options.animation = "TPose";
      const std::string message = messageOf(tried(maker, options));
      CHECK(says(message, "\"TPose\" is one pose. Choose an animation that moves: 1 \"walk\"."));
    }
    ImportOptions byName;
    byName.animation = "walk";
    CHECK(imported(maker, byName).animation == 1);
  }
}

TEST_CASE("if no animation moves, each is a key with its name") {
  GltfMaker maker = boxFile();
  addMove(maker, "TPose", {0});
  addMove(maker, "reach", {1, 1});
  addMove(maker, "crouch", {5});
  const Import import = imported(maker);
  CHECK(names(import) == std::vector<std::string>{"TPose", "reach", "crouch"});
  CHECK(places(import) == std::vector<double>{0, 1, 5});
  CHECK(import.keyframes.keys[2].time == 2);
  CHECK(import.animation == -1);
  ImportOptions samples;
  samples.sampleCount = 4, samples.sampleAsked = true;
  CHECK(says(messageOf(tried(maker, samples)), "Omit the animation and the samples"));
  ImportOptions one;
  one.animation = 1;
  CHECK(says(messageOf(tried(maker, one)), "Omit the animation and the samples"));
}

TEST_CASE("a still animation beside morph targets leaves these as keys; alone it is one pose") {
  GltfMaker morphs = morphFile({0, 1, 2});
  addMove(morphs, "Action", {0, 0});
  CHECK(names(imported(morphs)) == std::vector<std::string>{"base", "target 1", "target 2"});
  GltfMaker box = boxFile();
  addMove(box, "Action", {2});
  CHECK(says(messageOf(tried(box)), "has only one pose"));
}

TEST_CASE("files with one still action each are keys: the actions, not the pose at rest") {
  const auto pose = [](double x, const char* name = "Action") {
    GltfMaker maker = boxFile();
    addMove(maker, name, {x, x});
    return maker.glb();
  };
  const auto three = Files().add("pose0.glb", pose(0)).add("pose1.glb", pose(2)).add("pose2.glb", pose(5)).import();
  REQUIRE(three.ok());
  CHECK(places(*three) == std::vector<double>{0, 2, 5});
  CHECK(names(*three) == std::vector<std::string>{"pose0", "pose1", "pose2"});
  CHECK(!warningOf(*three, "same-poses"));
  const auto named = Files().add("a.glb", pose(0, "sit")).add("b.glb", pose(2, "stand")).import();
  REQUIRE(named.ok());
  CHECK(names(*named) == std::vector<std::string>{"sit", "stand"});
  // Given alone, twice, and as an additional pose of the mesh.
  ImportOptions like;
  like.like = three->keyframes.faces;
  like.likePose = three->keyframes.keys[0].positions;
  const auto further = Files().add("d.glb", pose(7)).add("d.glb", pose(7)).import(like);
  REQUIRE(further.ok());
  CHECK(places(*further) == std::vector<double>{7, 7});
}

TEST_CASE("a still action poses its file beside others that have none, or one that moves") {
  const auto file = [](std::vector<double> xs) {
    GltfMaker maker = boxFile();
    if (!xs.empty()) addMove(maker, "Action", std::move(xs));
    return maker.glb();
  };
  const auto of = [&](std::vector<std::vector<double>> actions) {
    Files files;
    for (std::size_t i = 0; i < actions.size(); ++i) files.add("f" + std::to_string(i) + ".glb", file(actions[i]));
    const auto import = files.import();
    REQUIRE(import.ok());
    return places(*import);
  };
  CHECK(of({{}, {2, 2}}) == std::vector<double>{0, 2});
  CHECK(of({{}, {2}, {5, 5}}) == std::vector<double>{0, 2, 5});
  CHECK(of({{2, 2}, {}, {5, 5}}) == std::vector<double>{2, 0, 5});
  CHECK(of({{2, 2}, {0, 7}, {5, 5}}) == std::vector<double>{2, 0, 5});
}

TEST_CASE("objects of the first file are found in files that hide them") {
  const auto file = [](bool visible, double x) {
    GltfMaker maker = boxFile();
    maker.doc["nodes"][0]["translation"] = {x, 0, 0};
    addBox(maker, 9, "lamp", visible);
    return maker.glb();
  };
  const auto both = Files().add("a.glb", file(true, 0)).add("b.glb", file(false, 1)).import();
  REQUIRE(both.ok());
  CHECK(both->keyframes.vertexCount() == 16);
  REQUIRE(warningOf(*both, "visibility-changes"));
  CHECK(says(warningOf(*both, "visibility-changes")->message, "b.glb"));
  CHECK(!warningOf(*both, "left-out-objects"));
  const auto one = Files().add("a.glb", file(false, 0)).add("b.glb", file(true, 1)).import();
  REQUIRE(one.ok());
  CHECK(one->keyframes.vertexCount() == 8);
}

TEST_CASE("two pose libraries follow each other; one contained in every file counts once") {
  const auto library = [](std::vector<double> xs) {
    GltfMaker maker = boxFile();
    for (double x : xs) addMove(maker, ("at " + std::to_string(int(x))).c_str(), {x});
    return maker.glb();
  };
  const auto both = Files().add("a.glb", library({0, 1})).add("b.glb", library({2, 3, 4})).import();
  REQUIRE(both.ok());
  CHECK(places(*both) == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(names(*both)[4] == "at 4");
  const auto same = Files().add("a.glb", library({0, 1})).add("b.glb", library({0, 1})).import();
  REQUIRE(same.ok());
  CHECK(places(*same) == std::vector<double>{0, 1});
  CHECK(warningOf(*same, "repeated-animation"));
}

TEST_CASE("poses that files show in other places are those of the files, whatever their actions") {
  const auto file = [](double x) {
    GltfMaker maker = boxFile();
    maker.doc["nodes"][0]["translation"] = {x, 0, 0};
    addMove(maker, "left over", {9});
    return maker.glb();
  };
  const auto import = Files().add("a.glb", file(0)).add("b.glb", file(1)).import();
  REQUIRE(import.ok());
  CHECK(places(*import) == std::vector<double>{0, 1});
}

TEST_CASE("repeated use of a few bytes is counted before a vertex is read") {
  const auto grid = [](int side) {
    GltfMaker maker;
    Positions points;
    std::vector<Triangle> faces;
    for (int i = 0; i < side * side; ++i) points.push_back({double(i % side), double(i / side), 0});
    for (int i = 0; i + side < side * side; ++i)
      if (i % side + 1 < side) faces.push_back({i, i + 1, i + side});
    maker.mesh({{"POSITION", maker.vectors(points)}}, maker.indices(faces));
    return maker;
  };
  const auto refused = [](const GltfMaker& maker, const std::string& part) {
    const auto result = Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).import();
    REQUIRE(!result.ok());
    CHECK(result.error().code == ErrorCode::TooLarge);
    CHECK_MESSAGE(says(result.error().message, part), result.error().message);
  };
  GltfMaker nodes = grid(30);
  for (int i = 0; i < 4000; ++i) nodes.node({{"mesh", 0}});
  refused(nodes, "shows 3,600,000 vertices and 3,364,000 faces, more than is supported for a file of");

  GltfMaker instances = grid(30);
  const int many = instances.add("accessors", {{"componentType", glFloat32}, {"count", 5000}, {"type", "VEC3"}});
  instances.node(
      {{"mesh", 0}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", many}}}}}}}});
  refused(instances, "shows 4,500,000 vertices");

  GltfMaker targets = grid(60);
  const int zeros = targets.add("accessors", {{"componentType", glFloat32}, {"count", 3600}, {"type", "VEC3"}});
  for (int t = 0; t < 2000; ++t) targets.doc["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", zeros}});
  targets.node({{"mesh", 0}});
  CHECK(says(messageOf(tried(targets)), "shows 3,600 vertices in 2,001 keys, more than is supported for a file of"));

  // Requesting each frame gives as many keys as the file has frames.
  GltfMaker frames = grid(60);
  for (int i = 0; i < 4; ++i) frames.node({{"mesh", 0}, {"translation", {70 * i, 0, 0}}});
  std::vector<double> moves;
  for (int i = 0; i < 1000; ++i) moves.push_back(i);
  addMove(frames, "walk", moves);
  ImportOptions every;
  every.everyFrame = true;
  CHECK(says(messageOf(tried(frames, every)), "shows 14,400 vertices in 1,000 keys, more than is supported"));
  CHECK(tried(frames).ok());

  GltfMaker skins = grid(60);
  const int joints = skins.add("accessors", {{"componentType", glUInt8}, {"count", 3600}, {"type", "VEC4"}});
  const int weights = skins.add("accessors", {{"componentType", glFloat32}, {"count", 3600}, {"type", "VEC4"}});
  for (int set = 0; set < 400; ++set) {
    skins.doc["meshes"][0]["primitives"][0]["attributes"]["JOINTS_" + std::to_string(set)] = joints;
    skins.doc["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_" + std::to_string(set)] = weights;
  }
  const int node = skins.node({{"mesh", 0}, {"skin", 0}});
  skins.add("skins", {{"joints", {node}}});
  refused(skins, "more than is supported for a file of");

  // A typical scene: one mesh shown a hundred times.
  GltfMaker fits = grid(30);
  for (int i = 0; i < 100; ++i) fits.node({{"mesh", 0}, {"translation", {40 * i, 0, 0}}});
  CHECK(Files().add("a.glb", fits.glb()).add("b.glb", fits.glb()).import().ok());
}

TEST_CASE("indices of lists must be whole numbers in range") {
  const auto with = [](auto change) {
    GltfMaker maker = morphFile({0, 1});
    maker.add("nodes", {{"name", "other"}});
    change(maker.doc);
    return messageOf(tried(maker));
  };
  CHECK(says(with([](json& doc) { doc["nodes"][1]["children"] = {4294967296}; }), "\"children\" is 4294967296"));
  CHECK(says(with([](json& doc) { doc["scenes"][0]["nodes"] = {4294967296}; }), "\"nodes\" is 4294967296"));
  CHECK(says(with([](json& doc) { doc["skins"] = {{{"joints", {4294967297}}}}; }), "\"joints\" is 4294967297"));
  CHECK(says(with([](json& doc) { doc["nodes"][1]["children"] = {-1}; }), "\"children\" is negative"));
  CHECK(says(with([](json& doc) { doc["nodes"][1]["children"] = {0.5}; }), "\"children\" is not a whole number"));
}

}  // namespace shapespline::test::gltf_scene_test
