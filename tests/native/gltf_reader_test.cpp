// Vertices, faces and keys from glTF files of every kind.
#include <doctest/doctest.h>

#include <numbers>

#include "gltf_maker.h"

namespace shapespline::test::gltf_reader_test {

namespace {

// Rounding of float32 for numbers of size one.
constexpr double floatError = 1e-6;

Import imported(const Files& files, const ImportOptions& options = {}) {
  auto result = files.import(options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(*result);
}

Files two(const GltfMaker& first, const GltfMaker& second) {
  return Files().add("a.glb", first.glb()).add("b.glb", second.glb());
}

}  // namespace

TEST_CASE("several GLB files are keys in the order given") {
  const Import import =
      imported(Files().add("b.glb", boxFile(0).glb()).add("a.glb", boxFile(0.5).glb()).add("c.glb", boxFile(1).glb()));
  REQUIRE(import.keyframes.keyCount() == 3);
  CHECK(import.keyframes.faces == boxFaces());
  CHECK(import.keyframes.keys[1].name == "a");
  CHECK(import.keyframes.keys[1].time == 1);  // poses are one second apart
  for (int j = 0; j < 3; ++j) CHECK(distance(import.keyframes.keys[j].positions, boxPose(0.5 * j)) < floatError);
  CHECK(import.keyframes.normals.empty());
  CHECK(import.animation == -1);
}

TEST_CASE("a .gltf finds its buffer inside, beside it and in folders") {
  const GltfMaker a = boxFile(0), b = boxFile(1);
  CHECK(imported(Files().add("a.gltf", a.gltf()).add("b.gltf", b.gltf())).keyframes.keyCount() == 2);
  const Import beside = imported(Files()
                                     .add("a.gltf", a.gltfBeside("a.bin"))
                                     .add("b.gltf", b.gltfBeside("b.bin"))
                                     .add("a.bin", a.bin)
                                     .add("b.bin", b.bin));
  CHECK(distance(beside.keyframes.keys[1].positions, boxPose(1)) < floatError);
  const Import folders = imported(Files()
                                      .add("one/m.gltf", a.gltfBeside("data/m%20x.bin"))
                                      .add("one/data/m x.bin", a.bin)
                                      .add("two/m.gltf", b.gltfBeside("./data/../data/m%20x.bin"))
                                      .add("two/data/m x.bin", b.bin));
  CHECK(distance(folders.keyframes.keys[1].positions, boxPose(1)) < floatError);
  SUBCASE("white space and escapes in a data URI are ignored") {
    json doc = a.withBuffer();
    std::string uri = dataUri(a.bin);
    uri.insert(60, "\r\n  ");
    while (uri.ends_with('=')) uri.pop_back();
    doc["buffers"][0]["uri"] = uri + "%3D\n";
    const Import inside = imported(Files().add("a.gltf", bytesOf(doc.dump())).add("b.glb", b.glb()));
    CHECK(distance(inside.keyframes.keys[0].positions, boxPose(0)) < floatError);
  }
  SUBCASE("also if the files are given without their folders") {
    CHECK(imported(Files().add("a.gltf", a.gltfBeside("buffers/a.bin")).add("a.bin", a.bin).add("b.glb", b.glb()))
              .keyframes.keyCount() == 2);
  }
  SUBCASE("and in a parent folder, if the name says so") {
    CHECK(imported(Files().add("m/a.gltf", a.gltfBeside("../a.bin")).add("a.bin", a.bin).add("b.glb", b.glb()))
              .keyframes.keyCount() == 2);
  }
}

TEST_CASE("a buffer may be longer than it declares") {
  GltfMaker a = boxFile();
  Bytes longer = a.bin;
  longer.resize(longer.size() + 5);
  CHECK(imported(Files().add("a.gltf", a.gltfBeside("a.bin")).add("a.bin", longer).add("b.glb", boxFile(1).glb()))
            .keyframes.keyCount() == 2);
}

TEST_CASE("morph targets without animation: base and targets are the keys") {
  GltfMaker maker = morphFile({0, 1, 3});
  Import import = imported(Files().add("m.glb", maker.glb()));
  REQUIRE(import.keyframes.keyCount() == 3);
  CHECK(import.keyframes.keys[0].name == "base");
  CHECK(import.keyframes.keys[2].name == "target 2");
  CHECK(distance(import.keyframes.keys[0].positions, boxPose(0)) < floatError);
  CHECK(distance(import.keyframes.keys[1].positions, boxPose(1)) < floatError);
  CHECK(distance(import.keyframes.keys[2].positions, boxPose(3)) < floatError);
  SUBCASE("names come from the mesh's extras, weights in the file do not matter") {
    maker.doc["meshes"][0]["extras"]["targetNames"] = {"smile", "frown"};
    maker.doc["meshes"][0]["weights"] = {0.5, 0.5};
    import = imported(Files().add("m.glb", maker.glb()));
    CHECK(import.keyframes.keys[2].name == "frown");
    CHECK(distance(import.keyframes.keys[0].positions, boxPose(0)) < floatError);
  }
}

TEST_CASE("a pose file is posed by its own morph weights") {
  GltfMaker maker = morphFile({0, 2});
  maker.doc["meshes"][0]["weights"] = {0.25};
  CHECK(distance(imported(two(maker, boxFile())).keyframes.keys[0].positions, boxPose(0.5)) < floatError);
  maker.doc["nodes"][0]["weights"] = {0.75};  // the node's weights take precedence
  CHECK(distance(imported(two(maker, boxFile())).keyframes.keys[0].positions, boxPose(1.5)) < floatError);
}

TEST_CASE("morph targets with one weight animation: its key times are the keys") {
  GltfMaker maker = morphFile({0, 1, 3});
  maker.animation("bend", 0, "weights", maker.scalars({0, 0.25f, 2}), maker.scalars({0, 0, 1, 0, 0, 1}));
  const Import import = imported(Files().add("m.glb", maker.glb()));
  REQUIRE(import.keyframes.keyCount() == 3);
  CHECK(import.animation == 0);
  REQUIRE(import.animations.size() == 1);
  CHECK(import.animations[0].name == "bend");
  CHECK(import.animations[0].end == 2);
  CHECK(import.animations[0].keys == 3);
  CHECK(import.keyframes.keys[1].time == 0.25);
  CHECK(distance(import.keyframes.keys[2].positions, boxPose(3)) < floatError);
  SUBCASE("unless times are requested") {
    ImportOptions options;
    options.sampleTimes = {0, 1.125};
    const Import sampled = imported(Files().add("m.glb", maker.glb()), options);
    REQUIRE(sampled.keyframes.keyCount() == 2);
    CHECK(distance(sampled.keyframes.keys[1].positions, boxPose(2)) < floatError);  // halfway between targets 1 and 2
  }
  SUBCASE("or a number of times") {
    ImportOptions options;
    options.sampleCount = 5;
    options.sampleAsked = true;
    const Import sampled = imported(Files().add("m.glb", maker.glb()), options);
    REQUIRE(sampled.keyframes.keyCount() == 5);
    CHECK(sampled.keyframes.keys[4].time == 2);
  }
  SUBCASE("given key times replace them") {
    ImportOptions options;
    options.keyTimes = {0, 1, 5};
    CHECK(imported(Files().add("m.glb", maker.glb()), options).keyframes.keys[2].time == 5);
  }
}

TEST_CASE("more than 32 key times, or several animations: 8 evenly spaced keys of the first") {
  GltfMaker many = morphFile({0, 1});
  std::vector<float> times(33), weights(33);
  for (int i = 0; i < 33; ++i) times[i] = 0.1f * i, weights[i] = i / 32.0f;
  many.animation("long", 0, "weights", many.scalars(times), many.scalars(weights));
  Import import = imported(Files().add("m.glb", many.glb()));
  REQUIRE(import.keyframes.keyCount() == 8);
  CHECK(distance(import.keyframes.keys[7].positions, boxPose(1)) < floatError);

  GltfMaker several = morphFile({0, 1});
  several.animation("up", 0, "weights", several.scalars({0, 7}), several.scalars({0, 1}));
  several.animation("down", 0, "weights", several.scalars({0, 1}), several.scalars({1, 0}));
  import = imported(Files().add("m.glb", several.glb()));
  REQUIRE(import.keyframes.keyCount() == 8);
  CHECK(import.animations.size() == 2);
  CHECK(import.keyframes.keys[1].time == doctest::Approx(1));
  ImportOptions options;
  options.animation = std::string("down");
  import = imported(Files().add("m.glb", several.glb()), options);
  CHECK(import.animation == 1);
  CHECK(distance(import.keyframes.keys[0].positions, boxPose(1)) < floatError);
  options.animation = 2;
  const auto unknown = Files().add("m.glb", several.glb()).import(options);
  REQUIRE(!unknown.ok());
  CHECK(unknown.error().code == ErrorCode::UnknownAnimation);
  CHECK(unknown.error().message.find("\"down\"") != std::string::npos);
}

TEST_CASE("every primitive of every node, transforms applied, in depth-first order") {
  GltfMaker maker;
  const int mesh = maker.mesh({{"POSITION", maker.vectors(boxPose())}}, maker.indices(boxFaces()));
  const int other = maker.mesh({{"POSITION", maker.vectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}});
  const double half = std::sqrt(0.5);
  const int child = maker.add("nodes", {{"mesh", other}, {"scale", {2, 2, 2}}});
  const int parent = maker.node(
      {{"mesh", mesh}, {"translation", {10, 0, 0}}, {"rotation", {0, 0, half, half}}, {"children", {child}}});
  maker.node({{"mesh", mesh}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1}}});
  maker.add("nodes", {{"mesh", mesh}});  // outside the scene
  CHECK(parent == 1);
  const Import import = imported(two(maker, maker));
  REQUIRE(import.keyframes.vertexCount() == 8 + 3 + 8);
  REQUIRE(import.keyframes.faceCount() == 12 + 1 + 12);
  const Positions& p = import.keyframes.keys[0].positions;
  CHECK((p[1] - Vec3(10, 1, 0)).norm() < floatError);      // (1, 0, 0) rotated to y, moved by 10
  CHECK((p[8 + 1] - Vec3(10, 2, 0)).norm() < floatError);  // scaled first
  CHECK((p[11 + 1] - Vec3(1, 5, 0)).norm() < floatError);
  CHECK(import.keyframes.faces[12] == Triangle{8, 9, 10});
  CHECK(import.scene.groups.size() == 3);
}

TEST_CASE("a mirroring node reverses its faces") {
  GltfMaker maker = boxFile();
  maker.doc["nodes"][0]["scale"] = {-1, 1, 1};
  const Import import = imported(two(maker, maker));
  const Triangle f = boxFaces()[0];
  CHECK(import.keyframes.faces[0] == Triangle{f[0], f[2], f[1]});
}

namespace {

// Whether the normals of the first key point to the same side as the faces.
bool normalsFitFaces(const Import& import) {
  const Keyframes& keys = import.keyframes;
  REQUIRE(keys.normals.size() == keys.keys[0].positions.size());
  return std::all_of(keys.faces.begin(), keys.faces.end(), [&](const Triangle& f) {
    const Positions& p = keys.keys[0].positions;
    const Vec3 outwards = (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]);
    return std::all_of(f.begin(), f.end(), [&](int v) { return keys.normals[v].dot(outwards) > 0; });
  });
}

// The box with normals that point away from its centre.
GltfMaker boxWithNormals() {
  GltfMaker maker = boxFile();
  Positions normals;
  for (const Vec3& p : boxPose()) normals.push_back((p - Vec3(0.5, 0.5, 1)).normalized());
  maker.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = maker.vectors(normals);
  return maker;
}

}  // namespace

TEST_CASE("normals of mirrored nodes, copies and skins point outwards, like the faces") {
  const GltfMaker box = boxWithNormals();
  CHECK(normalsFitFaces(imported(two(box, box))));
  GltfMaker node = box;
  node.doc["nodes"][0]["scale"] = {-1, 2, 1};
  CHECK(normalsFitFaces(imported(two(node, node))));
  GltfMaker matrix = box;
  matrix.doc["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, -1, 0, 0, 0, 0, 1};
  CHECK(normalsFitFaces(imported(two(matrix, matrix))));
  GltfMaker copies = box;
  copies.doc["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
      copies.vectors({{1, 1, 1}, {1, -1, 1}, {-1, -1, -1}});
  CHECK(normalsFitFaces(imported(two(copies, copies))));
  GltfMaker skin = box;
  json& attributes = skin.doc["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = skin.accessor(std::vector<std::uint8_t>(32, 0), "VEC4", 4, glUInt8);
  attributes["WEIGHTS_0"] = skin.accessor(std::vector<float>(32, 0.25f), "VEC4", 4, glFloat32);
  skin.add("skins", {{"joints", {skin.node({{"name", "bone"}, {"scale", {1, 1, -3}}})}}});
  skin.doc["nodes"][0]["skin"] = 0;
  CHECK(normalsFitFaces(imported(two(skin, skin))));
}

TEST_CASE("materials of specular colour and glossiness become metallic and rough") {
  GltfMaker maker = boxFile();
  maker.doc["meshes"][0]["primitives"][0]["material"] = 0;
  maker.doc["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] =
      maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1}, "VEC2", 2, glFloat32);
  maker.doc["images"] = {{{"uri", dataUri({0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 1, 2, 3, 4})}}};
  maker.doc["textures"] = {{{"source", 0}}};
  const json old = {{"diffuseFactor", {0.1, 0.3, 0.8, 0.5}},
                    {"diffuseTexture", {{"index", 0}, {"texCoord", 1}}},
                    {"glossinessFactor", 0.25},
                    {"specularGlossinessTexture", {{"index", 0}}}};
  maker.doc["materials"] = {{{"extensions", {{"KHR_materials_pbrSpecularGlossiness", old}}},
                             {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}, {"metallicFactor", 1}}}}};
  const Import import = imported(two(maker, maker));
  const Material& material = import.scene.materials[0];
  CHECK(material.baseColor[2] == doctest::Approx(0.8));
  CHECK(material.baseColor[3] == doctest::Approx(0.5));
  CHECK(material.roughness == doctest::Approx(0.75));
  CHECK(material.metallic == 0);
  CHECK(material.baseColorImage == 0);
  CHECK(import.scene.uvs.size() == 16);
  CHECK(import.warnings[0].code == "missing-texture");
}

TEST_CASE("primitives that share their vertices share them here too") {
  GltfMaker maker;
  const int positions = maker.vectors(boxPose());
  const std::vector<Triangle> a(boxFaces().begin(), boxFaces().begin() + 5),
      b(boxFaces().begin() + 5, boxFaces().end());
  json primitives = {{{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices(a)}, {"material", 1}},
                     {{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices(b)}, {"material", 0}}};
  maker.doc["materials"] = {{{"name", "red"}}, {{"name", "blue"}}};
  maker.node({{"mesh", maker.add("meshes", {{"primitives", primitives}})}});
  const Import import = imported(two(maker, maker));
  CHECK(import.keyframes.vertexCount() == 8);
  CHECK(import.keyframes.faces == boxFaces());
  REQUIRE(import.scene.groups.size() == 2);
  CHECK(import.scene.groups[1].start == 5);
  CHECK(import.scene.groups[1].count == 7);
  CHECK(import.scene.materials[import.scene.groups[0].material].name == "blue");
}

TEST_CASE("strips and fans") {
  GltfMaker maker;
  const Positions points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  maker.node({{"mesh", maker.mesh({{"POSITION", maker.vectors(points)}})}});
  auto& primitive = maker.doc["meshes"][0]["primitives"][0];
  primitive["mode"] = 5;
  Import import = imported(two(maker, maker));
  CHECK(import.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  primitive["mode"] = 6;
  import = imported(two(maker, maker));
  CHECK(import.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  SUBCASE("degenerate triangles that join strips are no faces") {
    primitive["mode"] = 5;
    primitive["indices"] = maker.accessor(std::vector<std::uint8_t>{0, 1, 2, 2, 3, 3, 4, 1}, "SCALAR", 1, glUInt8);
    import = imported(two(maker, maker));
    CHECK(import.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {3, 1, 4}});  // every second face is reversed
  }
}

TEST_CASE("lines and points are omitted with a warning") {
  GltfMaker maker = boxFile();
  json line = maker.doc["meshes"][0]["primitives"][0];
  line["mode"] = 1;
  maker.doc["meshes"][0]["primitives"].push_back(line);
  const Import import = imported(two(maker, maker));
  CHECK(import.keyframes.vertexCount() == 8);
  REQUIRE(import.warnings.size() >= 1);
  CHECK(import.warnings[0].code == "skipped-primitives");
}

TEST_CASE("quantised and normalised positions") {
  GltfMaker maker;
  std::vector<std::uint16_t> shorts;
  std::vector<std::int8_t> chars;
  for (const Vec3& p : boxPose()) {
    for (int c = 0; c < 3; ++c)
      shorts.push_back(static_cast<std::uint16_t>(p[c] * 32767.5)),
          chars.push_back(static_cast<std::int8_t>(p[c] * 50));
    shorts.push_back(0), chars.push_back(0);  // padding to strides of 8 and 4
  }
  const auto build = [&](int view, int type, bool normalised, double scale) {
    GltfMaker out = maker;
    const int positions = out.add(
        "accessors",
        {{"bufferView", view}, {"componentType", type}, {"count", 8}, {"type", "VEC3"}, {"normalized", normalised}});
    out.node(
        {{"mesh", out.mesh({{"POSITION", positions}}, out.indices(boxFaces()))}, {"scale", {scale, scale, scale}}});
    out.doc["extensionsRequired"] = out.doc["extensionsUsed"] = {"KHR_mesh_quantization"};
    return out;
  };
  const int shortView = maker.view(shorts, 8), charView = maker.view(chars, 4);
  CHECK(distance(imported(two(build(shortView, glUInt16, true, 2), boxFile())).keyframes.keys[0].positions, boxPose()) <
        2.0 / 65535);
  CHECK(distance(imported(two(build(charView, glInt8, false, 1 / 50.0), boxFile())).keyframes.keys[0].positions,
                 boxPose()) < 1e-6);
  CHECK(distance(imported(two(build(charView, glInt8, true, 127 / 50.0), boxFile())).keyframes.keys[0].positions,
                 boxPose()) < 1e-6);
}

TEST_CASE("sparse accessors replace elements, of a buffer view or of zeros") {
  const auto sparse = [](bool onZeros) {
    GltfMaker maker = boxFile();
    const int places = maker.view(std::vector<std::uint8_t>{4, 5}),
              values = maker.view(std::vector<float>{9, 8, 7, 6, 5, 4});
    json& accessor = maker.doc["accessors"][0];
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", places}, {"componentType", glUInt8}}},
                          {"values", {{"bufferView", values}}}};
    if (onZeros) accessor.erase("bufferView");
    return maker;
  };
  Positions expected = boxPose();
  expected[4] = {9, 8, 7};
  expected[5] = {6, 5, 4};
  CHECK(distance(imported(two(sparse(false), boxFile())).keyframes.keys[0].positions, expected) < floatError);
  for (int v : {0, 1, 2, 3, 6, 7}) expected[v] = Vec3::Zero();
  CHECK(distance(imported(two(sparse(true), boxFile())).keyframes.keys[0].positions, expected) < floatError);
}

TEST_CASE("interleaved attributes, and normals of the first key") {
  GltfMaker maker;
  std::vector<float> both;
  for (const Vec3& p : boxPose())
    for (const Vec3& v : {p, Vec3(0, 0, 2)})
      for (int c = 0; c < 3; ++c) both.push_back(static_cast<float>(v[c]));
  const int view = maker.view(both, 24);
  json attributes;
  attributes["POSITION"] =
      maker.add("accessors", {{"bufferView", view}, {"componentType", glFloat32}, {"count", 8}, {"type", "VEC3"}});
  attributes["NORMAL"] = maker.add(
      "accessors",
      {{"bufferView", view}, {"byteOffset", 12}, {"componentType", glFloat32}, {"count", 8}, {"type", "VEC3"}});
  const double half = std::sqrt(0.5);
  maker.node({{"mesh", maker.mesh(attributes, maker.indices(boxFaces()))},
              {"rotation", {half, 0, 0, half}},
              {"scale", {1, 1, 3}}});
  const Import import = imported(two(maker, maker));
  REQUIRE(import.keyframes.normals.size() == 8);
  CHECK((import.keyframes.normals[5] - Vec3(0, -1, 0)).norm() < floatError);  // z rotated about x
}

TEST_CASE("materials, coordinates, colours and images are unchanged") {
  GltfMaker maker = boxFile();
  const Bytes png = bytesOf("\x89PNG\r\n\x1a\n and so on");
  const int image = maker.add("images", {{"bufferView", maker.view(png)}, {"mimeType", "image/png"}});
  maker.add("images", {{"uri", "skin.jpg"}});
  maker.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9987}, {"minFilter", 9987}});
  maker.add("textures", {{"source", image}, {"sampler", 0}});
  maker.add("textures", {{"source", 1}});
  maker.add(
      "materials",
      {{"name", "skin"},
       {"alphaMode", "MASK"},
       {"alphaCutoff", 0.25},
       {"doubleSided", true},
       {"emissiveFactor", {0, 0.5, 0}},
       {"normalTexture", {{"index", 1}, {"scale", 0.5}}},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 0.25, 1, 0.75}},
         {"metallicFactor", 0.125},
         {"roughnessFactor", 0.375},
         {"baseColorTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"scale", {2, 4}}}}}}}}}}});
  auto& primitive = maker.doc["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  std::vector<std::uint16_t> uvs;
  for (int i = 0; i < 8; ++i) uvs.push_back(static_cast<std::uint16_t>(i * 8191)), uvs.push_back(65535);
  primitive["attributes"]["TEXCOORD_0"] = maker.accessor(uvs, "VEC2", 2, glUInt16, true);
  primitive["attributes"]["COLOR_0"] = maker.accessor(std::vector<std::uint8_t>(32, 51), "VEC4", 4, glUInt8, true);
  const Bytes jpeg = bytesOf("\xff\xd8\xff\xe0 and so on");
  const Files files = Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).add("skin.jpg", jpeg);
  const Scene scene = imported(files).scene;
  REQUIRE(scene.materials.size() == 1);
  const Material& m = scene.materials[0];
  CHECK(m.name == "skin");
  CHECK(m.baseColor == std::array<float, 4>{0.5f, 0.25f, 1, 0.75f});
  CHECK(m.metallic == 0.125f);
  CHECK(m.roughness == 0.375f);
  CHECK(m.doubleSided);
  CHECK(m.alphaMode == Material::Alpha::Mask);
  CHECK(m.alphaCutoff == 0.25f);
  CHECK(m.emissive[1] == 0.5f);
  CHECK(m.normalScale == 0.5f);
  CHECK(m.wrapS == Material::Wrap::Clamp);
  CHECK(m.magFilter == 0);  // invalid as a magnification filter
  CHECK(m.minFilter == 9987);
  CHECK(m.wrapT == Material::Wrap::Mirror);
  REQUIRE(scene.images.size() == 2);
  CHECK(scene.images[m.baseColorImage].bytes == png);
  CHECK(scene.images[m.baseColorImage].mimeType == "image/png");
  CHECK(scene.images[m.normalImage].bytes == jpeg);
  CHECK(scene.images[m.normalImage].mimeType == "image/jpeg");
  REQUIRE(scene.uvs.size() == 16);
  CHECK(scene.uvs[6] == doctest::Approx(2 * 3 * 8191 / 65535.0 + 0.5));
  CHECK(scene.uvs[7] == doctest::Approx(4));
  REQUIRE(scene.colors.size() == 32);
  CHECK(scene.colors[0] == doctest::Approx(0.2));
  SUBCASE("a missing or unreadable image costs the texture, not the shape") {
    const Import without = imported(Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()));
    CHECK(without.scene.images.size() == 1);
    CHECK(without.scene.materials[0].normalImage == -1);
    bool warned = false;
    for (const Warning& w : without.warnings)
      warned = warned || (w.code == "missing-texture" && w.message.find("skin.jpg") != std::string::npos);
    CHECK(warned);
    const Import broken =
        imported(Files().add("a.glb", maker.glb()).add("b.glb", maker.glb()).add("skin.jpg", bytesOf("<html>")));
    CHECK(broken.scene.images.size() == 1);
  }
}

TEST_CASE("integers written as 3.0 are integers") {
  GltfMaker maker = boxFile();
  maker.doc["accessors"][0]["count"] = 8.0;
  maker.doc["nodes"][0]["mesh"] = 0.0;
  CHECK(imported(two(maker, boxFile(1))).keyframes.keyCount() == 2);
}

TEST_CASE("unread extensions and extras do not matter") {
  GltfMaker maker = boxFile();
  maker.doc["extensionsUsed"] = {"KHR_lights_punctual", "ACME_thing"};
  maker.doc["nodes"][0]["extensions"] = {{"KHR_lights_punctual", json::object()}, {"ACME_thing", 7}};
  maker.doc["nodes"][0]["extras"] = {{"index", -4}};
  maker.doc["extras"] = "text";
  CHECK(imported(two(maker, boxFile(1))).keyframes.keyCount() == 2);
}

TEST_CASE("files that only accompany meshes are not keys") {
  const Import import = imported(Files()
                                     .add("a.glb", boxFile().glb())
                                     .add("README.md", bytesOf("hello"))
                                     .add(".DS_Store", {0})
                                     .add("b.glb", boxFile(1).glb()));
  CHECK(import.keyframes.keyCount() == 2);
}

}  // namespace shapespline::test::gltf_reader_test
