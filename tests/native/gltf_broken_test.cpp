// Every kind of broken glTF is rejected, alone and as the second of two keys. The error has the right code and names
// the file. The repaired file imports.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "gltf_maker.h"
#include "io/file_kind.h"

namespace shapespline::test::gltf_broken_test {

namespace {

// Checks rejection alone and as key 2, with the same code.
void checkRefused(const Bytes& broken, ErrorCode code, const std::string& says = "", const Files& beside = {},
                  const char* name = "bad.glb") {
  Files alone = Files().add(name, broken);
  Files second = Files().add("good.glb", boxFile().glb()).add(name, broken);
  for (std::size_t i = 0; i < beside.names.size(); ++i) {
    alone.add(beside.names[i], beside.bytes[i]);
    second.add(beside.names[i], beside.bytes[i]);
  }
  const auto first = alone.import();
  REQUIRE(!first.ok());
  CAPTURE(first.error().message);
  CHECK(std::string(errorCodeName(first.error().code)) == errorCodeName(code));
  CHECK(first.error().message.find(name) != std::string::npos);
  CHECK(first.error().message.find(says) != std::string::npos);
  CHECK(first.error().message.ends_with("."));
  const auto both = second.import();
  REQUIRE(!both.ok());
  CAPTURE(both.error().message);
  CHECK(std::string(errorCodeName(both.error().code)) == errorCodeName(code));
  CHECK(both.error().key == 1);
  // A file whose name does not suggest a mesh is not a key.
  CHECK(both.error().message.find(name + std::string(isMeshName(name) ? " (key 2)" : "")) != std::string::npos);
}

void checkRefused(const GltfMaker& broken, ErrorCode code, const std::string& says = "") {
  checkRefused(broken.glb(), code, says);
}

void checkMended(const GltfMaker& mended) {
  const auto result = Files().add("a.glb", boxFile().glb()).add("b.glb", mended.glb()).import();
  CHECK_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
}

}  // namespace

TEST_CASE("the unchanged version of every broken file below is valid") { checkMended(boxFile(1)); }

TEST_CASE("broken GLB containers") {
  const Bytes good = boxFile().glb();
  checkRefused(Bytes{}, ErrorCode::EmptyFile, "is empty");
  for (std::size_t size : {1, 4, 11, 12, 19, 20, 100}) {
    CAPTURE(size);
    const Bytes cut(good.begin(), good.begin() + static_cast<long>(size));
    if (size < 4) checkRefused(cut, ErrorCode::NotRecognised);
    else checkRefused(cut, ErrorCode::TruncatedFile, "cut off");
  }
  Bytes noEnd(good.begin(), good.end() - 1);
  checkRefused(noEnd, ErrorCode::TruncatedFile, "declares");
  Bytes version1 = good;
  version1[4] = 1;
  checkRefused(version1, ErrorCode::Unsupported, "version 1");
  Bytes chunk = good;
  chunk[15] = 0x7f;  // declares a JSON chunk of 2 GB
  checkRefused(chunk, ErrorCode::MalformedFile, "chunk 0");
  Bytes kind = good;
  kind[16] = 'X';
  checkRefused(kind, ErrorCode::MalformedFile, "first chunk is not JSON");
  Bytes small = good;
  small[8] = 12, small[9] = small[10] = small[11] = 0;
  checkRefused(small, ErrorCode::MalformedFile, "no JSON chunk");
  Bytes trailing = good;  // bytes after the declared length are ignored
  trailing.resize(good.size() + 7);
  CHECK(Files().add("a.glb", good).add("b.glb", trailing).import().ok());
}

TEST_CASE("files of another type are named") {
  checkRefused(bytesOf("<!DOCTYPE html>\n<html>"), ErrorCode::NotRecognised, "web page");
  checkRefused(bytesOf("\n  <HTML lang=en>"), ErrorCode::NotRecognised, "web page");
  checkRefused(bytesOf("version https://git-lfs.github.com/spec/v1\noid"), ErrorCode::NotRecognised, "Git LFS");
  checkRefused(bytesOf("PK\x03\x04 zip"), ErrorCode::NotRecognised, "ZIP");
  checkRefused(bytesOf("Kaydara FBX Binary  "), ErrorCode::NotRecognised, "FBX");
  checkRefused(bytesOf("just some text"), ErrorCode::NotRecognised, "but different content");
  checkRefused(bytesOf("just some text"), ErrorCode::NotRecognised, "not a supported 3D file", {}, "notes.doc");
}

TEST_CASE("broken JSON") {
  const auto json = [](const std::string& text) { return glbFrom(text, {}); };
  checkRefused(json("{\"asset\": {\"version\": \"2.0\"}, }"), ErrorCode::MalformedFile, "JSON is broken at byte");
  checkRefused(json("{\"asset\": {\"version\": \"2.0\"}, \"nodes\": ["), ErrorCode::TruncatedFile, "JSON ends");
  checkRefused(json("[]  "), ErrorCode::MalformedFile, "not glTF");
  checkRefused(json("{\"a\": 1}"), ErrorCode::NotRecognised, "asset.version");
  checkRefused(json("{\"asset\": {\"version\": \"1.0\"}}"), ErrorCode::Unsupported, "1.0");
  checkRefused(json("{\"asset\": {\"version\": \"2.0\", \"minVersion\": \"2.1\"}}"), ErrorCode::Unsupported, "2.1");
  checkRefused(json("{\"asset\": {\"version\": \"2.0\"}, \"x\": 1e999}"), ErrorCode::MalformedFile, "out of range");
  checkRefused(json(std::string("{\"asset\": {\"version\": \"2.0\"}, \"x\": \"") + "\xff\"}"),
               ErrorCode::MalformedFile);
  checkRefused(json("{\"asset\": {\"version\": \"2.0\"}}"), ErrorCode::NoTriangles, "no mesh");
  std::string deep = "{\"asset\": {\"version\": \"2.0\"}, \"extras\": ";
  for (int i = 0; i < 200000; ++i) deep += "[";
  checkRefused(json(deep), ErrorCode::MalformedFile, "nested");
  checkRefused(bytesOf(deep), ErrorCode::MalformedFile, "nested", {}, "bad.gltf");
  checkRefused(json(std::string(200, '[')), ErrorCode::MalformedFile, "nested");
  const auto many = [&](const std::string& item, int count) {
    std::string list = item;
    for (int i = 1; i < count; ++i) list += "," + item;
    return "{\"asset\": {\"version\": \"2.0\"}, \"x\": [" + list + "]}";
  };
  checkRefused(json(many("{}", 250'000)), ErrorCode::TooLarge, "limit of 250,000 objects");
  checkRefused(json(many("1", 4'000'000)), ErrorCode::TooLarge, "limit of 4,000,000 values");
  checkRefused(json(many("{}", 249'000)), ErrorCode::NoTriangles, "no mesh");
  std::string materials = many("{}", 16'385);
  checkRefused(json(materials.replace(materials.find("\"x\""), 3, "\"materials\"")), ErrorCode::TooLarge,
               "limit of 16,384 materials");
}

TEST_CASE("wrong types and values in the JSON") {
  const auto with = [](const char* pointer, const json& value) {
    GltfMaker maker = boxFile();
    maker.doc[json::json_pointer(pointer)] = value;
    return maker;
  };
  checkRefused(with("/accessors", 7), ErrorCode::MalformedFile, "accessors is not a list");
  checkRefused(with("/accessors/0", "x"), ErrorCode::MalformedFile, "accessors[0]");
  checkRefused(with("/accessors/0/count", -1), ErrorCode::MalformedFile, "negative");
  checkRefused(with("/accessors/0/count", "8"), ErrorCode::MalformedFile, "whole number");
  checkRefused(with("/accessors/0/count", 8.5), ErrorCode::MalformedFile, "whole number");
  checkRefused(with("/accessors/0/count", 4294967304ull), ErrorCode::MalformedFile, "more than is supported");
  checkRefused(with("/accessors/0/byteOffset", 18446744073709551604ull), ErrorCode::MalformedFile,
               "more than is supported");
  checkRefused(with("/accessors/0/componentType", 5124), ErrorCode::MalformedFile, "component type");
  checkRefused(with("/accessors/0/type", "VEC2"), ErrorCode::MalformedFile, "3 components");
  checkRefused(with("/accessors/0/type", "VEC9"), ErrorCode::MalformedFile);
  checkRefused(with("/accessors/0/bufferView", 9), ErrorCode::MalformedFile, "buffer view that does not exist");
  checkRefused(with("/bufferViews/0/buffer", 3), ErrorCode::MalformedFile, "buffer that does not exist");
  checkRefused(with("/bufferViews/0/byteStride", 8), ErrorCode::MalformedFile, "stride");
  checkRefused(with("/meshes/0/primitives/0/attributes/POSITION", 5), ErrorCode::MalformedFile,
               "accessor that does not exist");
  checkRefused(with("/meshes/0/primitives/0/attributes/POSITION", "0"), ErrorCode::MalformedFile, "whole number");
  checkRefused(with("/meshes/0/primitives/0/attributes", json::object()), ErrorCode::MalformedFile, "no positions");
  checkRefused(with("/meshes/0/primitives/0/attributes", 3), ErrorCode::MalformedFile);
  checkRefused(with("/meshes/0/primitives/0/indices", 17), ErrorCode::MalformedFile);
  checkRefused(with("/meshes/0/primitives/0/indices", 0), ErrorCode::MalformedFile);
  checkRefused(with("/meshes/0/primitives/0/mode", 1), ErrorCode::NoTriangles, "no triangles");
  checkRefused(with("/meshes/0/primitives", json::array()), ErrorCode::NoTriangles, "no triangles");
  checkRefused(with("/nodes/0/mesh", 4), ErrorCode::MalformedFile, "mesh 4");
  checkRefused(with("/nodes/0/skin", 4), ErrorCode::MalformedFile, "skin 4");
  checkRefused(with("/nodes/0/matrix", {1, 2, 3}), ErrorCode::MalformedFile, "transform");
  checkRefused(with("/scenes/0/nodes", {8}), ErrorCode::MalformedFile, "node 8");
  checkRefused(with("/scenes/0/nodes", {-1}), ErrorCode::MalformedFile, "\"nodes\" is negative");
  checkRefused(with("/scene", 3), ErrorCode::MalformedFile, "scene 3");
  checkRefused(with("/scenes/0/nodes", json::array()), ErrorCode::NoTriangles);
}

TEST_CASE("accessors and buffers past their end") {
  GltfMaker maker = boxFile();
  maker.doc["accessors"][0]["count"] = 9;
  checkRefused(maker, ErrorCode::MalformedFile, "needs 108 bytes");
  maker = boxFile();
  maker.doc["accessors"][0]["byteOffset"] = 4;
  checkRefused(maker, ErrorCode::MalformedFile, "needs 100 bytes");
  maker = boxFile();
  maker.doc["bufferViews"][1]["byteLength"] = 5000;
  checkRefused(maker, ErrorCode::MalformedFile, "ends at byte");
  maker = boxFile();
  maker.doc["buffers"] = {{{"byteLength", 2000000000}}};
  checkRefused(maker, ErrorCode::TruncatedFile, "declares 2.0 GB");
  maker = boxFile();
  maker.doc["buffers"] = {{{"uri", "data:application/octet-stream;base64,AAAA"}, {"byteLength", 168}}};
  checkRefused(maker, ErrorCode::TruncatedFile, "declares 168 bytes");
  maker.doc["buffers"][0]["uri"] = "data:application/octet-stream;base64,A?AA";
  checkRefused(maker, ErrorCode::MalformedFile, "base64");
  maker.doc["buffers"][0]["uri"] = "data:application/octet-stream";
  checkRefused(maker, ErrorCode::MalformedFile, "without content");
  maker.doc["buffers"][0] = {{"byteLength", 168}, {"uri", 5}};
  checkRefused(maker, ErrorCode::MalformedFile, "not text");
  maker.doc["buffers"] = json::array();
  checkRefused(maker, ErrorCode::MalformedFile, "buffer that does not exist");
}

TEST_CASE("declared sizes of gigabytes are refused at once") {
  GltfMaker maker = boxFile();
  maker.doc["accessors"][0].erase("bufferView");  // declared zeros without bytes
  maker.doc["accessors"][0]["count"] = 2000000000;
  checkRefused(maker, ErrorCode::TooLarge, "limit of 16,000,000");
  maker = boxFile();
  json children = json::array();  // one mesh with four million instances
  for (int i = 0; i < 3000; ++i) children.push_back(maker.add("nodes", {{"mesh", 1}}));
  maker.doc["nodes"][0]["children"] = children;
  std::vector<std::uint16_t> many(60000, 1);
  const int indices = maker.accessor(many, "SCALAR", 1, glUInt16);
  maker.mesh({{"POSITION", maker.doc["meshes"][0]["primitives"][0]["attributes"]["POSITION"]}}, indices);
  checkRefused(maker, ErrorCode::TooLarge, "faces");
}

// A file may use its parts many times. Their total is limited too, and checked before the work starts.
TEST_CASE("small files that require gigabytes or hours are refused at once") {
  const auto checkTooLarge = [](const GltfMaker& file, const std::string& says, const ImportOptions& options = {}) {
    const Files files = Files().add("bomb.glb", file.glb());
    const std::clock_t start = std::clock();
    const auto result = files.import(options);
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC <
          20);  // seconds; allows for WebAssembly on a busy machine
    REQUIRE(!result.ok());
    CAPTURE(result.error().message);
    CHECK(std::string(errorCodeName(result.error().code)) == errorCodeName(ErrorCode::TooLarge));
    CHECK(result.error().message.starts_with("bomb.glb"));
    CHECK(result.error().message.find(says) != std::string::npos);
  };
  const json zero = {{"componentType", glFloat32}, {"count", 4}, {"type", "VEC3"}};

  GltfMaker empty = boxFile();  // fifteen million vertices without bytes
  json nothing = zero;
  nothing["count"] = 15'000'000;
  empty.doc["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = empty.add("accessors", nothing);
  checkTooLarge(empty, "15,000,000 vertices");

  GltfMaker targets = boxFile();  // as many keys as targets
  const std::size_t vertices = targets.doc["accessors"][0]["count"];
  json flat = zero;
  flat["count"] = vertices;
  const int still = targets.add("accessors", flat);
  targets.doc["meshes"][0]["primitives"][0]["targets"] = std::vector<json>(20'000, {{"POSITION", still}});
  checkTooLarge(targets, "20,001 keys");

  GltfMaker weighted = targets;  // every target in every key
  const int seconds = weighted.scalars({0, 1});
  std::vector<float> weights(40'000, 1);
  weights.back() = 0.5f;
  const int on = weighted.scalars(weights);
  weighted.animation("all", 0, "weights", seconds, on);
  ImportOptions many;
  many.sampleAsked = true;
  many.sampleCount = 9'000;
  checkTooLarge(weighted, "too long", many);

  GltfMaker curves = targets;  // many channels without effect, in every key
  std::vector<float> none(40'000, 0);
  none.back() = 1e-3f;
  const int off = curves.scalars(none);
  curves.animation("all", 0, "weights", curves.scalars({0, 1}), off);
  json& channelsOfOne = curves.doc["animations"][0]["channels"];
  channelsOfOne = std::vector<json>(30, json(channelsOfOne[0]));
  checkTooLarge(curves, "too long", many);

  GltfMaker nodes = targets;  // every node has its own weights
  for (int i = 0; i < 1'000; ++i) nodes.node({{"mesh", 0}});
  checkTooLarge(nodes, "morph weights");

  GltfMaker instances = boxFile();
  const json primitive = instances.doc["meshes"][0]["primitives"][0];
  for (const int mode : {4, 0}) {
    json one = primitive;
    one["mode"] = mode;
    instances.doc["meshes"][0]["primitives"] = std::vector<json>(2'000, one);
    if (mode == 4)
      for (int i = 0; i < 2'000; ++i) instances.node({{"mesh", 0}});
    checkTooLarge(instances, "mesh primitives");
  }

  GltfMaker strips = boxFile();  // strips of degenerate faces add no face
  const int stitches = strips.accessor(std::vector<std::uint16_t>(1'000'000, 0), "SCALAR", 1, glUInt16);
  json strip = primitive;
  strip["mode"] = 5, strip["indices"] = stitches;
  for (int i = 0; i < 200; ++i) strips.doc["meshes"][0]["primitives"].push_back(strip);
  checkTooLarge(strips, "faces");

  GltfMaker channels = boxFile();
  std::vector<float> ramp(20'000);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i);
  const int times = channels.scalars(ramp);
  const int places = channels.vectors(Positions(ramp.size(), Vec3::Zero()));
  channels.animation("all", 0, "translation", times, places);
  const json channel = channels.doc["animations"][0]["channels"][0];
  channels.doc["animations"][0]["channels"] = std::vector<json>(1'000, channel);
  checkTooLarge(channels, "numbers");
}

TEST_CASE("data used many times costs once") {
  const std::clock_t start = std::clock();
  GltfMaker file = boxFile();
  const int inverse = file.add("accessors", {{"componentType", glFloat32}, {"count", 100'000}, {"type", "MAT4"}});
  for (int i = 0; i < 2'000; ++i) file.add("skins", {{"joints", {0}}, {"inverseBindMatrices", inverse}});
  std::vector<std::uint8_t> png(100'000, 0);
  const std::uint8_t magic[] = {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  std::copy(std::begin(magic), std::end(magic), png.begin());
  const int whole = file.view(png);
  for (int i = 0; i < 2'000; ++i) {
    file.add("images", {{"bufferView", whole}, {"mimeType", "image/png"}});
    file.add("textures", {{"source", i}});
    file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
  }
  auto result = Files().add("a.glb", file.glb()).add("b.glb", boxFile(1).glb()).import();
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  CHECK(result->scene.images.size() == 1);
  CHECK(result->scene.materials.back().baseColorImage == 0);

  // Each view begins one byte later, so the bytes differ but are nearly as many.
  json view = file.doc["bufferViews"][whole];
  for (int i = 0; i < 2'000; ++i) {
    view["byteLength"] = png.size() - 8 - i;
    file.doc["images"][i]["bufferView"] = file.add("bufferViews", view);
  }
  result = Files().add("a.glb", file.glb()).add("b.glb", boxFile(1).glb()).import();
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  CHECK(result->scene.images.size() < 50);
  CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 5);
}

TEST_CASE("indices out of range name the face") {
  GltfMaker maker = boxFile();
  std::vector<Triangle> faces = boxFaces();
  faces[7][2] = 8;
  maker.doc["meshes"][0]["primitives"][0]["indices"] = maker.indices(faces);
  checkRefused(maker, ErrorCode::IndexOutOfRange, "face 7 ");
  const auto result = Files().add("bad.glb", maker.glb()).import();
  CHECK(result.error().face == 7);
  CHECK(result.error().vertex == 8);
}

TEST_CASE("sparse accessors out of bounds") {
  const auto sparse = [](const json& change) {
    GltfMaker maker = boxFile();
    const int places = maker.view(std::vector<std::uint8_t>{4, 8}), values = maker.view(std::vector<float>(6, 1));
    json description = {{"count", 1},
                        {"indices", {{"bufferView", places}, {"componentType", glUInt8}}},
                        {"values", {{"bufferView", values}}}};
    description.merge_patch(change);
    maker.doc["accessors"][0]["sparse"] = description;
    return maker;
  };
  checkMended(sparse(json::object()));
  checkRefused(sparse({{"count", 2}}), ErrorCode::MalformedFile,
               "has the sparse index 8, but only 8 elements (0 to 7)");
  checkRefused(sparse({{"count", 9}}), ErrorCode::MalformedFile, "more sparse indices than elements");
  checkRefused(sparse({{"indices", {{"bufferView", 99}}}}), ErrorCode::MalformedFile, "buffer view");
  checkRefused(sparse({{"indices", {{"byteOffset", 2}}}}), ErrorCode::MalformedFile, "needs 3 bytes");
  checkRefused(sparse({{"indices", {{"componentType", glFloat32}}}}), ErrorCode::MalformedFile, "sparse indices");
  checkRefused(sparse({{"values", {{"byteOffset", 20}}}}), ErrorCode::MalformedFile, "needs 32 bytes");
}

TEST_CASE("node graphs that are not trees") {
  GltfMaker maker = boxFile();
  maker.doc["nodes"][0]["children"] = {0};
  checkRefused(maker, ErrorCode::MalformedFile, "its own child");
  maker.doc["nodes"][0]["children"] = {1};
  maker.add("nodes", {{"children", {2}}});
  maker.add("nodes", {{"children", {1}}});
  checkRefused(maker, ErrorCode::MalformedFile, "two parents");
  maker.doc["nodes"][0].erase("children");
  maker.doc["nodes"][1]["children"] = {2};
  checkRefused(maker, ErrorCode::MalformedFile, "cycle");
  maker.doc["nodes"][2]["children"] = {77};
  checkRefused(maker, ErrorCode::MalformedFile, "child 77");
  maker.doc["nodes"][2].erase("children");
  checkMended(maker);
  SUBCASE("a chain of a hundred thousand nodes is a tree") {
    GltfMaker chain;
    const int mesh = chain.mesh({{"POSITION", chain.vectors(boxPose())}}, chain.indices(boxFaces()));
    const int length = 100000;
    for (int i = 0; i < length; ++i)
      chain.add("nodes", i + 1 < length ? json{{"children", {i + 1}}} : json{{"mesh", mesh}});
    chain.doc["scenes"][0]["nodes"] = {0};
    checkMended(chain);
  }
}

TEST_CASE("numbers that are not finite name the vertex") {
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    GltfMaker maker = boxFile();
    std::memcpy(maker.bin.data() + 5 * 12 + 4, &bad, 4);
    const auto result = Files().add("a.glb", boxFile().glb()).add("bad.glb", maker.glb()).import();
    REQUIRE(!result.ok());
    CHECK(result.error().code == ErrorCode::NotFinite);
    CHECK(result.error().key == 1);
    CHECK(result.error().vertex == 5);
    CHECK(result.error().message.starts_with("bad.glb (key 2): "));
    GltfMaker morph = morphFile({0, 1});
    std::memcpy(morph.bin.data() + 5 * 12 + 4, &bad, 4);
    CHECK(Files().add("morph.glb", morph.glb()).import().error().message.starts_with("morph.glb: base (key 1): "));
  }
}

TEST_CASE("skins that do not fit") {
  const auto skinned = [](int joint, int joints, json skin) {
    GltfMaker maker = boxFile();
    auto& attributes = maker.doc["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] =
        maker.accessor(std::vector<std::uint8_t>(32, static_cast<std::uint8_t>(joint)), "VEC4", 4, glUInt8);
    attributes["WEIGHTS_0"] =
        maker.accessor(std::vector<float>(4 * static_cast<std::size_t>(joints), 0.25f), "VEC4", 4, glFloat32);
    maker.doc["nodes"][0]["skin"] = 0;
    maker.add("skins", std::move(skin));
    return maker;
  };
  checkMended(skinned(0, 8, {{"joints", {0}}}));
  checkRefused(skinned(1, 8, {{"joints", {0}}}), ErrorCode::MalformedFile, "joint 1, but its skin has 1 joint");
  checkRefused(skinned(0, 8, {{"joints", {5}}}), ErrorCode::MalformedFile, "joint node 5");
  checkRefused(skinned(0, 8, {{"joints", {0}}, {"inverseBindMatrices", 0}}), ErrorCode::MalformedFile, "16 components");
  checkRefused(skinned(0, 7, {{"joints", {0}}}), ErrorCode::MalformedFile, "a different number of joints or weights");
  checkRefused(skinned(0, 8, {{"joints", json::array()}}), ErrorCode::MalformedFile);
}

TEST_CASE("animations that do not fit") {
  const json none = json::object();
  const auto animated = [](const std::vector<float>& times, std::size_t values, const json& change) {
    GltfMaker maker = boxFile();
    const int input = maker.scalars(times);
    std::vector<float> places(values);
    for (std::size_t i = 0; i < values; ++i) places[i] = static_cast<float>(i);
    maker.animation("a", 0, "translation", input, maker.accessor(places, "VEC3", 3, glFloat32));
    maker.doc["animations"][0].merge_patch(change);
    return maker;
  };
  const auto refused = [](const GltfMaker& maker, ErrorCode code, const std::string& says) {
    const auto result = Files().add("bad.glb", maker.glb()).import();
    REQUIRE(!result.ok());
    CAPTURE(result.error().message);
    CHECK(std::string(errorCodeName(result.error().code)) == errorCodeName(code));
    CHECK(result.error().message.find(says) != std::string::npos);
  };
  CHECK(Files().add("good.glb", animated({0, 1}, 6, none).glb()).import().ok());
  refused(animated({0, 0}, 6, none), ErrorCode::TooFewKeys, "one pose");
  refused(animated({1, 0}, 6, none), ErrorCode::MalformedFile, "do not increase");
  refused(animated({0, std::numeric_limits<float>::quiet_NaN()}, 6, none), ErrorCode::MalformedFile, "do not increase");
  refused(animated({0, 1}, 3, none), ErrorCode::MalformedFile, "fewer values than times");
  refused(animated({}, 0, none), ErrorCode::MalformedFile, "no times");
  refused(animated({0}, 3, none), ErrorCode::TooFewKeys, "only one pose");
  const auto channel = [](int sampler, int node, const char* path) {
    return json{{"channels", {{{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}}}}};
  };
  refused(animated({0, 1}, 6, channel(4, 0, "translation")), ErrorCode::MalformedFile, "sampler 4");
  refused(animated({0, 1}, 6, channel(0, 9, "translation")), ErrorCode::MalformedFile, "node 9");
  refused(animated({0, 1}, 6, channel(0, 0, "weights")), ErrorCode::TooFewKeys, "only one pose");
  refused(animated({0, 1}, 6, channel(0, 0, "rotation")), ErrorCode::MalformedFile, "4 components");
  GltfMaker maker = animated({0, 1}, 6, none);
  maker.doc["animations"][0]["samplers"][0]["interpolation"] = "BEZIER";
  refused(maker, ErrorCode::MalformedFile, "interpolation");
  GltfMaker nothing = animated({0, 1}, 6, none);
  nothing.doc.erase("meshes");
  nothing.doc["nodes"][0].erase("mesh");
  refused(nothing, ErrorCode::NoTriangles, "no mesh");
  refused(boxFile(), ErrorCode::TooFewKeys, "only one pose");
}

namespace {

// A sound animation of the box, and one of `node` with these changes: of a camera last, and of the box first.
// Accessors in the changes are 0: decreasing times, 1: times that are not finite, 2: four values.
GltfMaker withBroken(int node, json sampler, const json& channel) {
  GltfMaker maker = boxFile();
  maker.node({{"name", "camera"}});
  const int times = maker.scalars({0, 1}), values = maker.vectors({{0, 0, 0}, {1, 0, 0}});
  const int start = maker.scalars({0, 1, 0.5f, 2});
  maker.scalars({0, NAN, 1, 2});
  maker.vectors(Positions(4, Vec3::Zero()));
  for (auto& [name, value] : sampler.items())
    if (value.is_number() && value >= 0) value = start + value.get<int>();
  maker.animation("bad", node, "translation", times, values);
  maker.doc["animations"][0]["samplers"][0].merge_patch(sampler);
  maker.doc["animations"][0]["channels"][0].merge_patch(channel);
  maker.animation("good", 0, "translation", times, values);
  if (node != 0) std::swap(maker.doc["animations"][0], maker.doc["animations"][1]);
  return maker;
}

}  // namespace

TEST_CASE("an animation that is not used does not refuse the file, however broken") {
  const std::vector<std::pair<json, json>> faults = {
      {{{"input", 0}, {"output", 2}}, json::object()},        // decreasing times
      {{{"input", 1}, {"output", 2}}, json::object()},        // times that are not finite
      {{{"input", 77}}, json::object()},                      // no such accessor
      {{{"input", -1}}, json::object()},                      // a negative index
      {{{"input", nullptr}}, json::object()},                 // no times
      {{{"interpolation", "BEZIER"}}, json::object()},        // an unknown interpolation
      {json::object(), {{"sampler", 9}}},                     // no such sampler
      {json::object(), {{"target", {{"path", "weights"}}}}},  // no morph targets
  };
  for (const auto& [sampler, channel] : faults) {
    CAPTURE(sampler.dump() + channel.dump());
    // Of a camera: it is not needed.
    auto result = Files().add("a.glb", withBroken(1, sampler, channel).glb()).import();
    REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
    CHECK(result->keyframes.keys.back().positions[0].x() == doctest::Approx(1));
    if (!channel.empty() && channel.contains("target")) continue;  // weights do not move a mesh without morph targets
    // Of the mesh and first in the file: it is the default, so the other must be chosen.
    const GltfMaker first = withBroken(0, sampler, channel);
    result = Files().add("a.glb", first.glb()).import();
    REQUIRE(!result.ok());
    CHECK(result.error().message.find("\"good\"") != std::string::npos);
    ImportOptions options;
    options.animation = std::string("good");
    result = Files().add("a.glb", first.glb()).import(options);
    REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
    CHECK(std::any_of(result->warnings.begin(), result->warnings.end(),
                      [](const Warning& warning) { return warning.code == "broken-animation"; }));
    options.animation = std::string("bad");
    CHECK(Files().add("a.glb", first.glb()).import(options).error().code == ErrorCode::MalformedFile);
  }
}

TEST_CASE("broken parts that the scene does not show do not refuse the file") {
  const auto imports = [](const char* collection, const json& part) {
    GltfMaker maker = boxFile();
    maker.add(collection, part);
    const auto result = Files().add("a.glb", maker.glb()).add("b.glb", boxFile(1).glb()).import();
    CHECK_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  };
  imports("meshes", {{"primitives", {{{"attributes", 3}}}}});
  imports("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 99}}}}});
  imports("materials", {{"emissiveFactor", {1, 2}}});
  imports("materials", {{"normalTexture", {{"index", -4}}}});
  imports("accessors", {{"count", -1}});
  imports("accessors", {{"bufferView", 9}, {"count", 1}, {"componentType", 5126}, {"type", "VEC3"}});
  imports("bufferViews", {{"buffer", 0}, {"byteLength", 4}, {"byteStride", 3}});
  imports("skins", {{"joints", {70}}});
}

TEST_CASE("morph targets that do not fit") {
  GltfMaker maker = morphFile({0, 1});
  maker.doc["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = maker.vectors(Positions(7, Vec3::Zero()));
  const auto result = Files().add("bad.glb", maker.glb()).import();
  REQUIRE(!result.ok());
  CHECK(result.error().code == ErrorCode::MalformedFile);
  CHECK(result.error().message.find("as many vertices") != std::string::npos);
}

TEST_CASE("URIs lead only to the given files") {
  GltfMaker maker = boxFile();
  const auto refused = [&](const std::string& uri, ErrorCode code, const std::string& says) {
    CAPTURE(uri);
    checkRefused(maker.gltfBeside(uri), code, says, Files().add("box.bin", maker.bin), "bad.gltf");
  };
  refused("http://example.org/box.bin", ErrorCode::ExternalResource, "Only the given files are read");
  refused("https://example.org/box.bin", ErrorCode::ExternalResource, "Only the given files are read");
  refused("//example.org/box.bin", ErrorCode::ExternalResource, "Only the given files are read");
  refused("file:///etc/box.bin", ErrorCode::ExternalResource, "Only the given files are read");
  refused("../box.bin", ErrorCode::ExternalResource, "outside the given files");
  refused("a/../../box.bin", ErrorCode::ExternalResource, "outside the given files");
  refused("..\\box.bin", ErrorCode::ExternalResource, "outside the given files");
  refused("%2e%2e/box.bin", ErrorCode::ExternalResource, "outside the given files");
  refused("/etc/passwd", ErrorCode::ExternalResource, "outside the given files");
  refused("C:\\box.bin", ErrorCode::ExternalResource, "outside the given files");
  refused("other.bin", ErrorCode::MissingResource, "other.bin");
  CHECK(Files()
            .add("a.gltf", maker.gltfBeside("box.bin"))
            .add("b.glb", boxFile(1).glb())
            .add("box.bin", maker.bin)
            .import()
            .ok());
}

TEST_CASE("extensions that change the geometry are refused by name") {
  for (const char* name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "ACME_secret"}) {
    GltfMaker maker = boxFile();
    maker.doc["extensionsUsed"] = maker.doc["extensionsRequired"] = {name};
    checkRefused(maker, ErrorCode::Unsupported, name);
  }
}

TEST_CASE("keys that are not poses of one mesh") {
  const auto refused = [](const GltfMaker& second, ErrorCode code, const std::vector<std::string>& says) {
    const auto result = Files().add("first.glb", boxFile().glb()).add("second.glb", second.glb()).import();
    REQUIRE(!result.ok());
    CAPTURE(result.error().message);
    CHECK(std::string(errorCodeName(result.error().code)) == errorCodeName(code));
    CHECK(result.error().key == 1);
    for (const std::string& text : says) CHECK(result.error().message.find(text) != std::string::npos);
  };
  const auto box = [](Positions points, const std::vector<Triangle>& faces) {
    GltfMaker maker;
    const int positions = maker.vectors(points), indices = maker.indices(faces);
    maker.node({{"mesh", maker.mesh({{"POSITION", positions}}, indices)}});
    return maker;
  };
  // The same number of faces, but with other vertices, including a new one.
  Positions nine = boxPose();
  nine.push_back({0, 0, 0});
  std::vector<Triangle> faces = boxFaces();
  for (std::size_t f = 0; f < faces.size(); f += 2) faces[f][f % 3] = 8;
  std::rotate(faces.begin(), faces.begin() + 5, faces.end());
  refused(box(nine, faces), ErrorCode::VertexCountMismatch, {"second.glb (key 2)", "9", "8", "modifiers applied"});
  faces = boxFaces();
  faces.pop_back();
  refused(box(boxPose(), faces), ErrorCode::FaceCountMismatch, {"second.glb (key 2)", "11", "12"});
  faces = boxFaces();
  std::swap(faces[3][0], faces[3][1]);
  refused(box(boxPose(), faces), ErrorCode::FaceMismatch, {"face 3", "winding"});
  refused(box(Positions(8, Vec3(1, 1, 1)), boxFaces()), ErrorCode::NoArea, {"zero area"});
}

TEST_CASE("too few files, and none") {
  CHECK(Files().import().error().code == ErrorCode::TooFewKeys);
  CHECK(Files().add("a.bin", {1, 2}).import().error().code == ErrorCode::TooFewKeys);
  CHECK(Files().add("a.glb", boxFile().glb()).import().error().code == ErrorCode::TooFewKeys);
}

TEST_CASE("key times that do not fit") {
  const Files files = Files().add("a.glb", boxFile().glb()).add("b.glb", boxFile(1).glb());
  const auto code = [&](std::vector<double> times) {
    ImportOptions options;
    options.keyTimes = std::move(times);
    const auto result = files.import(options);
    return result.ok() ? "ok" : errorCodeName(result.error().code);
  };
  CHECK(code({0, 2}) == std::string("ok"));
  CHECK(code({0}) == std::string("time-count-mismatch"));
  CHECK(code({1, 1}) == std::string("times-not-increasing"));
  CHECK(code({1, 0}) == std::string("times-not-increasing"));
  CHECK(code({0, std::numeric_limits<double>::quiet_NaN()}) == std::string("not-finite"));
}

TEST_CASE("every truncated file is refused or imported, and never read past its end") {
  GltfMaker maker = morphFile({0, 1, 2});
  maker.animation("bend", 0, "weights", maker.scalars({0, 0.25f, 2}), maker.scalars({0, 0, 1, 0, 0, 1}));
  const Bytes good = maker.glb(), text = maker.gltf();
  for (std::size_t size = 0; size < good.size(); size += 1 + size / 97)
    CHECK(!Files().add("m.glb", Bytes(good.begin(), good.begin() + static_cast<long>(size))).import().ok());
  for (std::size_t size = 0; size + 1 < text.size(); size += 1 + size / 97)
    CHECK(!Files().add("m.gltf", Bytes(text.begin(), text.begin() + static_cast<long>(size))).import().ok());
}

}  // namespace shapespline::test::gltf_broken_test
