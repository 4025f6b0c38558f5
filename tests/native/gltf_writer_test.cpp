// Exported GLBs have the right structure and exact bounds, and import again unchanged.
#include <doctest/doctest.h>

#include <cmath>

#include "gltf_maker.h"
#include "io/export.h"
#include "io/gltf/glb_container.h"

namespace shapespline::test::gltf_writer_test {

namespace {

std::vector<float> floats(const Positions& points) {
  std::vector<float> out;
  for (const Vec3& p : points)
    for (int c = 0; c < 3; ++c) out.push_back(static_cast<float>(p[c]));
  return out;
}

Positions outward(const Positions& points) {
  Positions out;
  for (const Vec3& p : points) out.push_back((p - Vec3(0.5, 0.5, 1)).normalized());
  return out;
}

struct Exported {
  Bytes bytes;
  json doc;
  std::span<const std::uint8_t> bin;
};

Exported exported(Result<std::vector<std::uint8_t>> written) {
  REQUIRE_MESSAGE(written.ok(), (written.ok() ? "" : written.error().message));
  Exported out{std::move(*written), {}, {}};
  const auto chunks = splitGlb(out.bytes, "export");
  REQUIRE(chunks.ok());
  out.doc = json::parse(chunks->json);
  out.bin = chunks->bin;
  return out;
}

// Bends 0, 0.1, 0.2, ... at the given times, followed by the stills.
AnimationSource bending(const std::vector<double>& seconds, const Scene& scene, int stills = 0) {
  AnimationSource source;
  source.faces = &boxFaces();
  source.scene = &scene;
  source.seconds = seconds;
  source.stills = stills;
  source.frame = [](int k, std::vector<float>& p, std::vector<float>& n) {
    p = floats(boxPose(0.1 * k));
    n = floats(outward(boxPose(0.1 * k)));
    return Status();
  };
  return source;
}

}  // namespace

TEST_CASE("an animated GLB: base, differences, one weight animation, exact bounds") {
  const Scene scene;
  const Exported file = exported(writeAnimatedGlb(bending({0, 0.5, 2}, scene)));
  const json& doc = file.doc;
  CHECK(doc["asset"]["version"] == "2.0");
  const json& primitive = doc["meshes"][0]["primitives"][0];
  CHECK(primitive["targets"].size() == 2);
  CHECK(doc["meshes"][0]["weights"].size() == 2);
  REQUIRE(doc["animations"].size() == 1);
  CHECK(doc["animations"][0]["channels"][0]["target"]["path"] == "weights");
  CHECK(doc["animations"][0]["samplers"][0]["interpolation"] == "LINEAR");
  CHECK(doc["buffers"].size() == 1);
  CHECK(doc["buffers"][0]["byteLength"] == file.bin.size());
  // Every accessor with bounds must have those of the floats in the file, bit for bit.
  int bounded = 0;
  for (const json& accessor : doc["accessors"]) {
    if (!accessor.contains("min")) continue;
    ++bounded;
    const std::size_t components = accessor["min"].size();
    const json& view = doc["bufferViews"][accessor["bufferView"].get<int>()];
    const std::size_t start = view["byteOffset"].get<std::size_t>() + accessor.value("byteOffset", 0);
    std::vector<float> low(components, INFINITY), high(components, -INFINITY);
    for (std::size_t i = 0; i < accessor["count"].get<std::size_t>() * components; ++i) {
      float value;
      std::memcpy(&value, &file.bin[start + 4 * i], 4);
      low[i % components] = std::min(low[i % components], value);
      high[i % components] = std::max(high[i % components], value);
    }
    for (std::size_t c = 0; c < components; ++c) {
      CHECK(accessor["min"][c].get<double>() == low[c]);
      CHECK(accessor["max"][c].get<double>() == high[c]);
    }
  }
  CHECK(bounded == 4);  // base, two targets, times
}

TEST_CASE("an exported animation imports with its frames as keys") {
  const Scene scene;
  const auto bytes = writeAnimatedGlb(bending({0, 0.5, 2}, scene));
  REQUIRE(bytes.ok());
  const auto import = Files().add("m.glb", *bytes).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  REQUIRE(import->keyframes.keyCount() == 3);
  CHECK(import->keyframes.faces == boxFaces());
  CHECK(import->keyframes.keys[1].time == 0.5);
  CHECK(import->keyframes.normals.size() == 8);
  for (int k = 0; k < 3; ++k) CHECK(distance(import->keyframes.keys[k].positions, boxPose(0.1 * k)) < 1e-6);
}

TEST_CASE("a saved project restores its keys, not its frames") {
  const Scene scene;
  AnimationSource source = bending({0, 0.25, 0.5, 0.75, 1}, scene, 1);
  source.project =
      R"({"version": 1, "keys": {"times": [-3, 0, 4], "names": ["still", "first", "last"], "frames": [5, 0, 4]}, "options": {"boundary": "hermite"}})";
  const auto bytes = writeAnimatedGlb(source);
  REQUIRE(bytes.ok());
  const Files files = Files().add("m.glb", *bytes);
  auto import = files.import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  REQUIRE(import->keyframes.keyCount() == 3);
  CHECK(import->keyframes.keys[0].name == "still");
  CHECK(import->keyframes.keys[0].time == -3);
  CHECK(distance(import->keyframes.keys[0].positions, boxPose(0.5)) < 1e-6);
  CHECK(distance(import->keyframes.keys[1].positions, boxPose(0)) < 1e-6);
  CHECK(distance(import->keyframes.keys[2].positions, boxPose(0.4)) < 1e-6);
  CHECK(json::parse(import->project)["options"]["boundary"] == "hermite");
  CHECK(import->warnings.empty());
  SUBCASE("requested samples take precedence") {
    ImportOptions options;
    options.sampleTimes = {0, 1};
    import = files.import(options);
    CHECK(import->keyframes.keyCount() == 2);
    CHECK(import->project.empty());
  }
  SUBCASE("the still is never shown") {
    ImportOptions options;
    options.sampleTimes = {0, 0.125, 1};
    import = files.import(options);
    CHECK(distance(import->keyframes.keys[1].positions, boxPose(0.05)) < 1e-6);
    CHECK(distance(import->keyframes.keys[2].positions, boxPose(0.4)) < 1e-6);
  }
  SUBCASE("keys may be given by their seconds") {
    source.project = R"({"keys": {"times": [10, 20], "names": ["a", "b"], "seconds": [0.25, 1]}})";
    import = Files().add("m.glb", *writeAnimatedGlb(source)).import();
    REQUIRE(import->keyframes.keyCount() == 2);
    CHECK(import->keyframes.keys[1].time == 20);
    CHECK(distance(import->keyframes.keys[0].positions, boxPose(0.1)) < 1e-6);
  }
}

TEST_CASE("a broken project is ignored with a warning") {
  const Scene scene;
  AnimationSource source = bending({0, 1}, scene);
  for (const char* project :
       {R"({"keys": 7})", R"({"keys": {"times": [0, 1], "frames": [0, 9]}})",
        R"({"keys": {"times": [0], "frames": [0]}})", R"({"keys": {"times": [1, 1], "frames": [0, 1]}})",
        R"({"keys": {"times": [0, "x"], "frames": [0, 1]}})", R"({"keys": {"times": [0, 1]}})",
        R"({"keys": {"times": [0, 1], "frames": [0, -1]}})", R"({"keys": [1, 2]})"}) {
    CAPTURE(project);
    source.project = project;
    const auto import = Files().add("m.glb", *writeAnimatedGlb(source)).import();
    REQUIRE(import.ok());
    CHECK(import->keyframes.keyCount() == 2);
    CHECK(import->project.empty());
    REQUIRE(import->warnings.size() == 1);
    CHECK(import->warnings[0].code == "project-ignored");
  }
}

TEST_CASE("materials, coordinates, colours and images are restored") {
  Scene scene;
  for (int i = 0; i < 8; ++i) {
    scene.uvs.insert(scene.uvs.end(), {i / 8.0f, 1 - i / 8.0f});
    scene.colors.insert(scene.colors.end(), {1, i / 8.0f, 0, 1});
  }
  scene.images = {{"image/png", bytesOf("\x89PNG\r\n\x1a\n 1")}, {"image/webp", bytesOf("RIFF....WEBP 2")}};
  Material skin;
  skin.name = "skin";
  skin.baseColor = {0.5f, 0.1f, 0.25f, 0.75f};
  skin.metallic = 0.3f;
  skin.alphaMode = Material::Alpha::Mask;
  skin.alphaCutoff = 0.25f;
  skin.emissive = {0, 0.5f, 0};
  skin.baseColorImage = 0;
  skin.normalImage = 1;
  skin.normalScale = 0.5f;
  skin.wrapS = Material::Wrap::Mirror;
  skin.magFilter = 9728;
  Material glass;
  glass.alphaMode = Material::Alpha::Blend;
  glass.unlit = true;
  scene.materials = {glass, skin};
  scene.groups = {{0, 4, 1}, {6, 6, 0}};  // faces 4 and 5 have no material
  const auto bytes = writeAnimatedGlb(bending({0, 1}, scene));
  REQUIRE(bytes.ok());
  auto import = Files().add("m.glb", *bytes).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->keyframes.vertexCount() == 8);
  CHECK(import->keyframes.faces == boxFaces());
  const Scene& again = import->scene;
  CHECK(again.uvs == scene.uvs);
  CHECK(again.colors == scene.colors);
  REQUIRE(again.groups.size() == 3);
  CHECK(again.groups[1].start == 4);
  CHECK(again.groups[1].count == 2);
  const Material& m = again.materials[again.groups[0].material];
  CHECK(m.name == "skin");
  CHECK(m.baseColor == skin.baseColor);
  CHECK(m.metallic == skin.metallic);
  CHECK(m.alphaCutoff == skin.alphaCutoff);
  CHECK(m.emissive == skin.emissive);
  CHECK(m.normalScale == skin.normalScale);
  CHECK(m.wrapS == skin.wrapS);
  CHECK(m.magFilter == 9728);
  CHECK(m.minFilter == 0);
  CHECK(again.images[m.baseColorImage].bytes == scene.images[0].bytes);
  CHECK(again.images[m.normalImage].mimeType == "image/webp");
  CHECK(again.materials[again.groups[2].material].unlit);
  CHECK(again.materials[again.groups[2].material].alphaMode == Material::Alpha::Blend);
}

TEST_CASE("tangents of a normal map: unit, perpendicular, right-handed with the image's up") {
  // A square in the plane z = 0, seen from +z; u runs along x, v (downwards in the image) along -y.
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<Triangle> faces{{0, 1, 2}, {0, 2, 3}};
  Scene scene;
  scene.uvs = {0, 1, 1, 1, 1, 0, 0, 0};
  scene.images = {{"image/png", bytesOf("\x89PNG\r\n\x1a\n 1")}};
  scene.materials.resize(1);
  scene.materials[0].normalImage = 0;
  scene.groups = {{0, 2, 0}};
  for (bool mirrored : {false, true}) {
    if (mirrored) scene.uvs = {1, 1, 0, 1, 0, 0, 1, 0};
    const Exported file = exported(writePoseGlb(positions, normals, faces, scene));
    const int index = file.doc["meshes"][0]["primitives"][0]["attributes"]["TANGENT"].get<int>();
    const std::size_t start =
        file.doc["bufferViews"][file.doc["accessors"][index]["bufferView"].get<int>()]["byteOffset"].get<std::size_t>();
    float tangent[4];
    std::memcpy(tangent, &file.bin[start], 16);
    CHECK(tangent[0] == doctest::Approx(mirrored ? -1 : 1));
    CHECK(tangent[3] == (mirrored ? -1 : 1));  // cross(normal, tangent) * w = +y, up in the image
  }
}

TEST_CASE("thousands of frames keep the weights small") {
  const Scene scene;
  std::vector<double> seconds(3000);
  for (std::size_t k = 0; k < seconds.size(); ++k) seconds[k] = 0.01 * static_cast<double>(k);
  AnimationSource source = bending(seconds, scene);
  const auto bytes = writeAnimatedGlb(source);
  REQUIRE(bytes.ok());
  CHECK(bytes->size() < 4'000'000);  // dense weights alone would take 36 MB
  ImportOptions options;
  options.sampleTimes = {0, 14.995, 29.99};
  const auto import = Files().add("m.glb", *bytes).import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(distance(import->keyframes.keys[1].positions, boxPose(149.95)) < 1e-4);
  CHECK(distance(import->keyframes.keys[2].positions, boxPose(299.9)) < 1e-4);
}

TEST_CASE("the size is known beforehand to a few percent") {
  const Scene scene;
  for (int frames : {2, 60, 600}) {
    std::vector<double> seconds(frames);
    for (int k = 0; k < frames; ++k) seconds[k] = 0.01 * k;
    // A mesh large enough that the JSON size is insignificant.
    const int side = 60;
    std::vector<Triangle> faces;
    for (int i = 0; i + 1 < side; ++i)
      for (int j = 0; j + 1 < side; ++j) faces.push_back({i * side + j, i * side + j + 1, (i + 1) * side + j});
    AnimationSource source = bending(seconds, scene);
    source.faces = &faces;
    source.project = R"({"version": 1, "keys": {"times": [0, 1], "frames": [0, 1]}})";
    source.frame = [](int k, std::vector<float>& p, std::vector<float>& n) {
      p.assign(3 * side * side, 0.01f * static_cast<float>(k));
      n.assign(3 * side * side, 1);
      return Status();
    };
    const auto bytes = writeAnimatedGlb(source);
    REQUIRE(bytes.ok());
    CHECK(static_cast<double>(animatedGlbSize(faces, side * side, frames, scene).bytes) ==
          doctest::Approx(static_cast<double>(bytes->size())).epsilon(0.03));
  }
}

TEST_CASE("the number of frames is limited to what opens again") {
  const Scene scene;
  std::vector<double> seconds(4000);
  for (std::size_t k = 0; k < seconds.size(); ++k) seconds[k] = static_cast<double>(k);
  const auto bytes = writeAnimatedGlb(bending(seconds, scene));
  REQUIRE(bytes.ok());
  ImportOptions options;
  options.sampleTimes = {0, 3999};
  const auto import = Files().add("m.glb", *bytes).import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(distance(import->keyframes.keys[1].positions, boxPose(399.9)) < 1e-3);

  const auto refusal = [&](const AnimationSource& source) {
    const auto refused = writeAnimatedGlb(source);
    REQUIRE(!refused.ok());
    CHECK(refused.error().code == ErrorCode::TooLarge);
    return refused.error().message;
  };
  CHECK(refusal(bending(seconds, scene, 2)).find("4,001 morph targets needs 16,004,000 weights") != std::string::npos);
  seconds.push_back(4000);
  CHECK(refusal(bending(seconds, scene)).find("16,004,000 weights") != std::string::npos);
}

TEST_CASE("invalid exports are refused") {
  const Scene scene;
  const auto code = [&](const AnimationSource& source) {
    const auto written = writeAnimatedGlb(source);
    return std::string(written.ok() ? "ok" : errorCodeName(written.error().code));
  };
  CHECK(code(bending({0, 1}, scene)) == "ok");
  CHECK(code(bending({}, scene)) == "invalid-option");
  CHECK(code(bending({1, 2}, scene)) == "invalid-option");
  CHECK(code(bending({0, 0}, scene)) == "invalid-option");
  CHECK(code(bending({0, 1, 1 + 1e-12}, scene)) == "invalid-option");  // equal in float32
  AnimationSource source = bending({0, 1}, scene);
  source.project = "[1]";
  CHECK(code(source) == "invalid-option");
  source = bending({0, 1}, scene);
  source.frame = [](int k, std::vector<float>& p, std::vector<float>&) {
    p = floats(boxPose());
    if (k == 1) p[4] = NAN;
    return Status();
  };
  CHECK(code(source) == "not-finite");
  source.frame = [](int, std::vector<float>&, std::vector<float>&) {
    return Status(Error{ErrorCode::Internal, "stop"});
  };
  CHECK(code(source) == "internal");
}

TEST_CASE("a shape without a normal somewhere still gets unit normals") {
  const std::vector<float> positions = floats(boxPose());
  std::vector<float> normals = floats(outward(boxPose()));
  normals[3] = normals[4] = normals[5] = 0;
  normals[6] = NAN;
  const auto bytes = writePoseGlb(positions, normals, boxFaces(), Scene());
  REQUIRE(bytes.ok());
  const auto import = Files().add("a.glb", *bytes).add("b.glb", *bytes).import();
  REQUIRE(import.ok());
  for (const Vec3& n : import->keyframes.normals) CHECK(n.norm() == doctest::Approx(1));
}

// The box with a texture seam: its first four faces have coordinates in another region.
Scene seamScene() {
  Scene scene;
  std::vector<int> copy(8, -1);
  scene.seams.faces = boxFaces();
  for (int f = 0; f < 4; ++f)
    for (int& v : scene.seams.faces[f]) {
      if (copy[v] < 0) copy[v] = 8 + static_cast<int>(scene.seams.copyOf.size()), scene.seams.copyOf.push_back(v);
      v = copy[v];
    }
  const std::size_t drawn = 8 + scene.seams.copyOf.size();
  for (std::size_t i = 0; i < drawn; ++i)
    scene.uvs.insert(scene.uvs.end(), {static_cast<float>(i) / 16, i < 8 ? 0.25f : 0.75f});
  for (int i = 0; i < 8; ++i) scene.colors.insert(scene.colors.end(), {1, i / 8.0f, 0, 1});
  scene.groups = {{0, 12, 0}};
  scene.images = {{"image/png", bytesOf("\x89PNG\r\n\x1a\n 1")}};
  scene.materials.resize(1);
  scene.materials[0].baseColorImage = 0;
  return scene;
}

void checkSeams(const Import& import, const Scene& scene) {
  CHECK(import.keyframes.faces == boxFaces());
  CHECK(import.keyframes.vertexCount() == 8);
  CHECK(import.keyframes.normals.size() == 8);
  CHECK(import.scene.uvs == scene.uvs);
  CHECK(import.scene.colors == scene.colors);
  CHECK(import.scene.seams.copyOf == scene.seams.copyOf);
  CHECK(import.scene.seams.faces == scene.seams.faces);
  CHECK(import.warnings.empty());
}

TEST_CASE("a texture's seams are split open in the file, and closed when it opens again") {
  const Scene scene = seamScene();
  AnimationSource source = bending({0, 0.5, 2}, scene, 1);
  source.project = R"({"version": 1, "keys": {"times": [0, 1, 2], "frames": [0, 2, 3]}})";
  const Exported file = exported(writeAnimatedGlb(source));
  const json& primitive = file.doc["meshes"][0]["primitives"][0];
  const std::size_t drawn = 8 + scene.seams.copyOf.size();
  for (const auto& [name, accessor] : primitive["attributes"].items())
    CHECK(file.doc["accessors"][accessor.get<int>()]["count"] == drawn);
  for (const json& target : primitive["targets"])
    CHECK(file.doc["accessors"][target["POSITION"].get<int>()]["count"] == drawn);
  CHECK(static_cast<double>(animatedGlbSize(boxFaces(), 8, 4, scene).bytes) ==
        doctest::Approx(file.bytes.size()).epsilon(0.4));

  const auto import = Files().add("m.glb", file.bytes).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  checkSeams(*import, scene);
  for (int k = 0; k < 3; ++k)
    CHECK(distance(import->keyframes.keys[k].positions, boxPose(std::array{0.0, 0.2, 0.3}[k])) < 1e-6);
  SUBCASE("other programs that split vertices get what every GLB gives them") {
    json doc = file.doc;
    for (json& p : doc["meshes"][0]["primitives"]) p["attributes"].erase("_SHAPESPLINE_VERTEX");
    const auto split = Files().add("m.glb", glbFrom(doc.dump(), {file.bin.begin(), file.bin.end()})).import();
    REQUIRE(split.ok());
    CHECK(split->keyframes.vertexCount() == static_cast<int>(drawn));
    CHECK(split->scene.uvs == scene.uvs);
  }
  SUBCASE("vertex numbers that are invalid, or whose copies have different positions, are ignored") {
    const json& accessor = file.doc["accessors"][primitive["attributes"]["_SHAPESPLINE_VERTEX"].get<int>()];
    const std::size_t at =
        file.doc["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"].get<std::size_t>() + 4 * (drawn - 1);
    for (float wrong : {-1.0f, 0.5f, 1e30f, NAN, scene.seams.copyOf.back() == 0 ? 1.0f : 0.0f}) {
      CAPTURE(wrong);
      Bytes bin(file.bin.begin(), file.bin.end());
      std::memcpy(&bin[at], &wrong, 4);
      const auto other = Files().add("m.glb", glbFrom(file.doc.dump(), bin)).import();
      REQUIRE(other.ok());
      CHECK(other->keyframes.vertexCount() == static_cast<int>(drawn));
    }
  }
}

TEST_CASE("every primitive has separate vertices, and the mesh opens again with its vertices in their order") {
  Scene scene;
  SUBCASE("with seams") { scene = seamScene(); }
  SUBCASE("without") {}
  scene.materials.resize(3);
  scene.groups = {{0, 2, 2}, {2, 7, 0}, {9, 3, 1}};
  AnimationSource source = bending({0, 0.5, 2}, scene);
  source.name = "box";
  source.targetNames = {"half", "whole"};
  source.project = R"({"version": 1, "keys": {"times": [0, 1], "frames": [0, 2]}})";
  const Exported file = exported(writeAnimatedGlb(source));
  const json& mesh = file.doc["meshes"][0];
  REQUIRE(mesh["primitives"].size() == 3);
  CHECK(mesh["name"] == "box");
  CHECK(file.doc["nodes"][0]["name"] == "box");
  CHECK(mesh["extras"]["targetNames"] == source.targetNames);
  for (const json& material : file.doc["materials"]) CHECK(material["name"].get<std::string>() != "");
  std::uint64_t vertices = 0;
  for (const json& primitive : mesh["primitives"]) {
    const json& first = file.doc["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    vertices += first["count"].get<std::uint64_t>();
    CHECK(first["count"] <= 8 + scene.seams.copyOf.size());
    // The primitive's data must not overlap with another primitive's.
    const json& view = file.doc["bufferViews"][first["bufferView"].get<int>()];
    CHECK(view["byteLength"] == 3 * 24 * first["count"].get<int>());
    for (const json& target : primitive["targets"])
      CHECK(file.doc["accessors"][target["POSITION"].get<int>()]["bufferView"] == first["bufferView"]);
  }
  CHECK(vertices < 3 * (8 + scene.seams.copyOf.size()));
  CHECK(animatedGlbSize(boxFaces(), 8, 3, scene).vertices == vertices);
  const auto import = Files().add("m.glb", file.bytes).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->keyframes.faces == boxFaces());
  CHECK(import->keyframes.normals.size() == 8);
  CHECK(import->scene.uvs == scene.uvs);
  CHECK(import->scene.colors == scene.colors);
  CHECK(import->scene.seams.copyOf == scene.seams.copyOf);
  CHECK(import->scene.seams.faces == scene.seams.faces);
  REQUIRE(import->scene.groups.size() == 3);
  CHECK(import->scene.groups[1].material == 0);
  for (int k = 0; k < 2; ++k) CHECK(distance(import->keyframes.keys[k].positions, boxPose(0.2 * k)) < 1e-6);
}

TEST_CASE("vertices without faces are kept, also with several materials") {
  Scene scene;
  scene.materials.resize(2);
  scene.groups = {{0, 1, 0}, {1, 1, 1}};
  const std::vector<float> positions{5, 5, 5, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 9, 9, 9};
  const auto glb = writePoseGlb(positions, {}, {{1, 2, 3}, {1, 3, 4}}, scene);
  REQUIRE(glb.ok());
  const auto import = Files().add("a.glb", *glb).add("b.glb", *glb).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(floats(import->keyframes.keys[0].positions) == positions);
  CHECK(import->keyframes.faces == std::vector<Triangle>{{1, 2, 3}, {1, 3, 4}});
}

TEST_CASE("given weights: every target at every time") {
  const Scene scene;
  AnimationSource source = bending({0, 1, 2, 3}, scene);
  source.weights = {0, 0, 0.5f, 0, 1, 0.25f, 0, 1};  // for frames 1 and 2, bent by 0.1 and 0.2
  const auto bytes = writeAnimatedGlb(source);
  REQUIRE(bytes.ok());
  ImportOptions options;
  options.sampleTimes = {0, 1, 2, 3};
  const auto import = Files().add("m.glb", *bytes).import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  const auto at = [&](int k, int v) { return import->keyframes.keys[k].positions[v]; };
  for (int v = 0; v < 8; ++v) {
    const Vec3 base = boxPose(0)[v], one = boxPose(0.1)[v] - base, two = boxPose(0.2)[v] - base;
    CHECK((at(1, v) - base - 0.5 * one).norm() < 1e-6);
    CHECK((at(2, v) - base - one - 0.25 * two).norm() < 1e-6);
    CHECK((at(3, v) - base - two).norm() < 1e-6);
  }
  source.weights.pop_back();
  CHECK(!writeAnimatedGlb(source).ok());
}

TEST_CASE("texture coordinates are kept without a texture, with their seams, and the mesh with its own vertices") {
  Scene scene = seamScene();
  scene.images.clear();
  scene.materials[0].baseColorImage = -1;
  const auto bytes = writeAnimatedGlb(bending({0, 0.5}, scene));
  const Exported file = exported(bytes);
  const json& attributes = file.doc["meshes"][0]["primitives"][0]["attributes"];
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0", "TEXCOORD_0"})
    CHECK(file.doc["accessors"][attributes[name].get<int>()]["count"] == 8 + scene.seams.copyOf.size());
  const auto import = Files().add("m.glb", *bytes).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->keyframes.vertexCount() == 8);
  checkSeams(*import, scene);
  CHECK(static_cast<double>(animatedGlbSize(boxFaces(), 8, 2, scene).bytes) ==
        doctest::Approx(file.bytes.size()).epsilon(0.5));
}

TEST_CASE("single poses with seams are restored from GLB and OBJ, with the same vertices and faces") {
  const Scene scene = seamScene();
  const std::vector<float> positions = floats(boxPose(0.1)), normals = floats(outward(boxPose(0.1)));
  const auto glb = writePoseGlb(positions, normals, boxFaces(), scene);
  const auto other = writePoseGlb(floats(boxPose(0.2)), normals, boxFaces(), scene);
  REQUIRE((glb.ok() && other.ok()));
  const auto import = Files().add("a.glb", *glb).add("b.glb", *other).import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  checkSeams(*import, scene);

  const Bytes obj = *writeObj(positions, boxFaces(), scene);
  const auto polygons = Files().add("a.obj", obj).add("b.obj", obj).import();
  REQUIRE(polygons.ok());
  CHECK(polygons->keyframes.vertexCount() == 8);
  CHECK(polygons->keyframes.faces == boxFaces());
  CHECK(polygons->scene.seams.copyOf.size() == scene.seams.copyOf.size());
  const auto coordinates = [](const Scene& s, const Triangle& own, std::size_t f, int c) {
    const int v = s.seams.faces.empty() ? own[c] : s.seams.faces[f][c];
    return std::pair(s.uvs[2 * v], s.uvs[2 * v + 1]);
  };
  for (std::size_t f = 0; f < 12; ++f)
    for (int c = 0; c < 3; ++c)
      CHECK(coordinates(polygons->scene, boxFaces()[f], f, c) == coordinates(scene, boxFaces()[f], f, c));
}

TEST_CASE("an OBJ has names without control characters, also those above 127, and keeps other letters") {
  const std::string letters = "d\xc3\xa9\xe6\x9f\x93", controls = "\x7f\xc2\x9b\xc2\x85\x1b\xe2\x80\xa8\xff";
  Scene scene;
  scene.groups = {{0, 4, -1, letters + controls + "."}};
  scene.objects = {{controls + letters, 0, 12, "node"}};
  const Bytes written = *writeObj(floats(boxPose(0.1)), boxFaces(), scene);
  const std::string out(written.begin(), written.end());
  CHECK(out.find("usemtl " + letters + "      .\n") != std::string::npos);
  CHECK(out.find("o       " + letters + "\n") != std::string::npos);
}

TEST_CASE("an OBJ keeps its polygons, coordinates, materials and normals") {
  const std::string text =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0.5 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nusemtl red\nf 1/1 2/2 3/3 4/4\nusemtl blue\n"
      "f 2/5 5/2 7/3 6/4 3/1\nf 4/4 3/3 6/5\n";
  const std::string library = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";
  const auto files = Files().add("a.obj", bytesOf(text)).add("b.obj", bytesOf(text)).add("a.mtl", bytesOf(library));
  const auto import = files.import();
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->scene.polygons == std::vector<int>{2, 3, 1});
  const std::vector<float> positions = floats(import->keyframes.keys[0].positions), normals(positions.size(), 1);
  const Bytes written =
      *writeObj(positions, import->keyframes.faces, import->scene, normals, {"m.mtl", {"red", "blue"}});
  const std::string out(written.begin(), written.end());
  CAPTURE(out);
  CHECK(out.starts_with("mtllib m.mtl\n"));
  CHECK(out.find("usemtl red\n") < out.find("usemtl blue\n"));
  const auto again = Files().add("a.obj", written).add("b.obj", written).import();
  REQUIRE_MESSAGE(again.ok(), (again.ok() ? "" : again.error().message));
  CHECK(again->scene.polygons == import->scene.polygons);
  CHECK(again->scene.seams.copyOf == import->scene.seams.copyOf);
  CHECK(again->keyframes.normals.size() == 7);
  CHECK(out.find("vn 1 1 1\n") != std::string::npos);
}

TEST_CASE("single poses are restored from GLB, OBJ and PLY, bit for bit") {
  std::vector<float> positions = floats(boxPose(1 / 3.0));
  positions[0] = 1.17549435e-38f;
  positions[1] = -9.9e17f;
  positions[2] = 0.1f;
  const auto glb = writePoseGlb(positions, {}, boxFaces(), Scene());
  REQUIRE(glb.ok());
  const std::vector<std::pair<std::string, Bytes>> files{{"a.glb", *glb},
                                                         {"a.obj", *writeObj(positions, boxFaces(), Scene())},
                                                         {"a.ply", *writePly(positions, boxFaces())}};
  for (const auto& [name, bytes] : files) {
    CAPTURE(name);
    const auto import = Files().add(name, bytes).add("b" + name.substr(1), bytes).import();
    REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
    CHECK(import->keyframes.faces == boxFaces());
    CHECK(floats(import->keyframes.keys[1].positions) == positions);
  }
}

}  // namespace shapespline::test::gltf_writer_test
