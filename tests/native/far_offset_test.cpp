// Shapes far from the origin: read in double, computed near the origin, and written at their original position.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "files.h"
#include "gltf_maker.h"
#include "io/export.h"
#include "shapes.h"

namespace shapespline::test::far_offset_test {

namespace {

const Vec3 utm(432'100, 5, 5'412'345);
const Shape farBar = box(0.6, 2, 0.6, 1, 4, 1);

Positions poseAt(const Vec3& where, double angle) {
  return mapped(farBar.positions, [&](const Vec3& p) -> Vec3 { return where + bend(angle, 2)(p); });
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string row(const Vec3& p) { return number(p.x()) + " " + number(p.y()) + " " + number(p.z()) + "\n"; }

Bytes objOf(const Positions& positions) {
  std::string text;
  for (const Vec3& p : positions) text += "v " + row(p);
  for (const Triangle& f : farBar.faces)
    text += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1) + "\n";
  return bytesOf(text);
}

Bytes offOf(const Positions& positions) {
  std::string text = "OFF\n" + std::to_string(positions.size()) + " " + std::to_string(farBar.faces.size()) + " 0\n";
  for (const Vec3& p : positions) text += row(p);
  for (const Triangle& f : farBar.faces)
    text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
  return bytesOf(text);
}

template <class T>
void appendNumber(Bytes& out, T value, bool bigEndian) {
  std::uint8_t bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (bigEndian) std::reverse(bytes, bytes + sizeof value);
  out.insert(out.end(), bytes, bytes + sizeof value);
}

template <class T>
Bytes plyOf(const Positions& positions, bool bigEndian) {
  const std::string type = sizeof(T) == 8 ? "double" : "float";
  Bytes out = bytesOf(std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                      "_endian 1.0\nelement vertex " + std::to_string(positions.size()) + "\nproperty " + type +
                      " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " +
                      std::to_string(farBar.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Vec3& p : positions)
    for (double x : p) appendNumber(out, static_cast<T>(x), bigEndian);
  for (const Triangle& f : farBar.faces) {
    out.push_back(3);
    for (int v : f) appendNumber(out, v, bigEndian);
  }
  return out;
}

Bytes asciiPlyOf(const Positions& positions) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(positions.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(farBar.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : positions) text += row(p);
  for (const Triangle& f : farBar.faces)
    text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
  return bytesOf(text);
}

Import imported(const Files& files, const ImportOptions& options = {}) {
  auto import = files.import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  return std::move(*import);
}

// Positions as seen by the engine, in single precision.
Positions asComputed(const Import& import, int key) {
  Positions out = import.keyframes.keys[key].positions;
  for (Vec3& p : out) p = p.cast<float>().cast<double>() + import.offset;
  return out;
}

double diagonalOf(const Positions& positions) {
  const Positions* one = &positions;
  return boundingDiagonal({&one, 1});
}

bool warns(const Import& import, const std::string& code) {
  return std::any_of(import.warnings.begin(), import.warnings.end(), [&](const Warning& w) { return w.code == code; });
}

std::vector<float> floats(const Positions& positions) {
  std::vector<float> out;
  for (const Vec3& p : positions)
    for (double x : p) out.push_back(static_cast<float>(x));
  return out;
}

struct Format {
  const char* name;
  Bytes (*write)(const Positions&);
};

const Format formats[] = {{"obj", objOf},
                          {"off", offOf},
                          {"ply", asciiPlyOf},
                          {"ply", [](const Positions& p) { return plyOf<double>(p, false); }},
                          {"ply", [](const Positions& p) { return plyOf<double>(p, true); }}};

Bytes glbAt(const Vec3& local, const Vec3& offset, const std::vector<double>& angles) {
  AnimationSource source;
  const Scene scene;
  source.faces = &farBar.faces;
  source.scene = &scene;
  source.offset = offset;
  for (std::size_t k = 0; k < angles.size(); ++k) source.seconds.push_back(static_cast<double>(k));
  source.frame = [&](int k, std::vector<float>& p, std::vector<float>& n) {
    p = floats(poseAt(local, angles[k]));
    n.clear();
    return Status();
  };
  auto glb = writeAnimatedGlb(source);
  REQUIRE(glb.ok());
  return std::move(*glb);
}

}  // namespace

TEST_CASE("keys of survey coordinates are as exact as at the origin, for any format, axis and unit") {
  for (const Format& format : formats)
    for (bool zUp : {false, true})
      for (double unit : {1.0, 0.001, 0.3048}) {
        const Positions first = poseAt(utm, 0), second = poseAt(utm + Vec3(0.5, 0, 0.25), 0.7);
        const std::string name = std::string(".") + format.name;
        ImportOptions options;
        options.zUp = zUp;
        options.unit = unit;
        const Import import =
            imported(Files().add("a" + name, format.write(first)).add("b" + name, format.write(second)), options);
        CHECK(import.offset != Vec3::Zero());
        CHECK(!warns(import, "distant-keys"));
        CHECK(!warns(import, "rounded-positions"));
        for (int key = 0; key < 2; ++key) {
          Positions expected = key == 0 ? first : second;
          for (Vec3& p : expected) p = unit * (zUp ? Vec3(p.x(), p.z(), -p.y()) : p);
          CHECK(largestDistance(asComputed(import, key), expected) < 3e-7 * diagonalOf(expected));
        }
      }
}

TEST_CASE("shapes near the origin have no offset and keep every bit") {
  for (double distance : {0.0, 1.0, 10.0, 30.0}) {
    const Positions first = poseAt(Vec3(distance, 0, 0), 0), second = poseAt(Vec3(distance, 0, 0), 0.7);
    const Import import = imported(Files().add("a.obj", objOf(first)).add("b.obj", objOf(second)));
    CHECK(import.offset == Vec3::Zero());
    CHECK(import.keyframes.keys[0].positions == first);
    CHECK(import.keyframes.keys[1].positions == second);
  }
}

TEST_CASE("the offset is a power of two times a whole number: subtracting and adding it is exact") {
  for (double scale : {1e-4, 1.0, 37.0, 1e5})
    for (double distance : {50.0, 1118.0, 455'000.0}) {
      Positions first = poseAt(Vec3(distance, 1, -distance), 0), second = poseAt(Vec3(distance, 1, -distance), 0.7);
      for (Positions* pose : {&first, &second})
        for (Vec3& p : *pose) p *= scale;
      const Import import = imported(Files().add("a.obj", objOf(first)).add("b.obj", objOf(second)));
      const double step = std::exp2(std::floor(std::log2(diagonalOf(first))));
      for (double x : import.offset) CHECK(std::fmod(x, step) == 0);
      for (std::size_t v = 0; v < first.size(); ++v)
        CHECK(import.keyframes.keys[0].positions[v] + import.offset == first[v]);
    }
}

TEST_CASE("a further pose uses the offset of the open shape") {
  const Import open = imported(Files().add("a.obj", objOf(poseAt(utm, 0))).add("b.obj", objOf(poseAt(utm, 0.7))));
  const Positions far = poseAt(utm + Vec3(30, 0, 9), 0.3);
  ImportOptions options;
  options.like = open.keyframes.faces;
  options.likePose = open.keyframes.keys[0].positions;
  options.offset = open.offset;
  const Import further =
      imported(Files().add("c.ply", plyOf<double>(far, true)).add("d.ply", plyOf<double>(far, true)), options);
  CHECK(further.offset == open.offset);
  for (std::size_t v = 0; v < far.size(); ++v)
    CHECK((further.keyframes.keys[0].positions[v] + open.offset - far[v]).norm() < 1e-8);
  options.offset = Vec3::Zero();  // offset of a shape opened near the origin
  CHECK(imported(Files().add("c.obj", objOf(far)).add("d.obj", objOf(far)), options).offset == Vec3::Zero());
}

TEST_CASE("exported shapes are at their original position: OBJ, PLY and the node of a GLB") {
  const Positions first = poseAt(utm, 0), second = poseAt(utm, 0.7);
  const Import import = imported(Files().add("a.obj", objOf(first)).add("b.obj", objOf(second)));
  const std::vector<float> a = floats(import.keyframes.keys[0].positions),
                           b = floats(import.keyframes.keys[1].positions);
  const MeshOffset offset{import.offset};
  const auto check = [&](const Files& files) {
    const Import again = imported(files);
    CHECK(again.offset == import.offset);
    CHECK(largestDistance(asComputed(again, 0), first) < 3e-7);
    CHECK(largestDistance(asComputed(again, 1), second) < 3e-7);
  };
  check(Files()
            .add("a.obj", *writeObj(a, farBar.faces, {}, {}, {}, offset))
            .add("b.obj", *writeObj(b, farBar.faces, {}, {}, {}, offset)));
  check(Files().add("a.ply", *writePly(a, farBar.faces, offset)).add("b.ply", *writePly(b, farBar.faces, offset)));
  check(Files()
            .add("a.glb", *writePoseGlb(a, {}, farBar.faces, {}, import.offset))
            .add("b.glb", *writePoseGlb(b, {}, farBar.faces, {}, import.offset)));
}

TEST_CASE("numbers of an OBJ are as long as single precision needs") {
  Positions pose = poseAt(Vec3::Zero(), 0);
  pose[0] = {0.1, 0.2, -0.3};
  const auto text = [&](const Vec3& offset) {
    const Bytes bytes = *writeObj(floats(pose), farBar.faces, {}, {}, {}, {offset});
    const std::string all(bytes.begin(), bytes.end());
    return all.substr(0, all.find('\n'));
  };
  CHECK(text({500'000, 0, -5'000'000}) == "v 500000.1 0.2 -5000000.30000001");
  CHECK(text({-0.0625, 1e15, 0}) == "v 0.0375 1000000000000000 -0.3");
}

TEST_CASE("the OBJ of a point cache is near the origin and states the offset for both") {
  const Positions first = poseAt(utm, 0), second = poseAt(utm, 0.7);
  const Import import = imported(Files().add("a.obj", objOf(first)).add("b.obj", objOf(second)));
  const std::vector<float> a = floats(import.keyframes.keys[0].positions),
                           b = floats(import.keyframes.keys[1].positions);
  const Bytes obj = *writeObj(a, farBar.faces, {}, {}, {}, {import.offset, false});
  CHECK(std::string(obj.begin(), obj.end()).find("# shapespline offset 432100 4 5412344\n") != std::string::npos);
  Bytes cache = bytesOf(std::string_view("POINTCACHE2\0", 12));
  for (std::uint32_t word : {1u, static_cast<std::uint32_t>(first.size())}) appendNumber(cache, word, false);
  appendNumber(cache, 0.f, false), appendNumber(cache, 1.f, false), appendNumber(cache, 2u, false);
  for (float x : a) appendNumber(cache, x, false);
  for (float x : b) appendNumber(cache, x, false);
  const Import again = imported(Files().add("a.obj", obj).add("a.pc2", cache));
  CHECK(again.offset == import.offset);
  CHECK(largestDistance(asComputed(again, 0), first) < 3e-7);
  CHECK(largestDistance(asComputed(again, 1), second) < 3e-7);
}

TEST_CASE("a GLB with a distant node loses no precision; distant positions in single precision give a warning") {
  const Vec3 far(500'000, 0, 5'000'000);
  const Import exact = imported(Files().add("a.glb", glbAt(Vec3::Zero(), far, {0, 0.5, 0.9})));
  CHECK(exact.offset != Vec3::Zero());
  CHECK(!warns(exact, "rounded-positions"));
  CHECK(largestDistance(asComputed(exact, 2), poseAt(far, 0.9)) < 4e-7);
  const Import rounded = imported(Files().add("a.glb", glbAt(far, Vec3::Zero(), {0, 0.5, 0.9})));
  CHECK(warns(rounded, "rounded-positions"));
  const Positions pose = poseAt(far, 0);
  const Import single =
      imported(Files().add("a.ply", plyOf<float>(pose, true)).add("b.ply", plyOf<float>(poseAt(far, 0.7), true)));
  CHECK(warns(single, "rounded-positions"));
  CHECK(!warns(imported(Files().add("a.glb", glbAt(Vec3(300, 0, 0), Vec3::Zero(), {0, 1}))), "rounded-positions"));
}

TEST_CASE("parts of a GLB are distant by parent nodes, and a skin by its joints") {
  const Vec3 far(-500'000.25, 3, 5'000'000.5);
  const auto at = [](const Vec3& p) { return json{p.x(), p.y(), p.z()}; };
  for (bool skinned : {false, true}) {
    GltfMaker maker;
    const Positions kept = poseAt(Vec3::Zero(), 0), offsets = difference(poseAt(Vec3::Zero(), 0.7), kept);
    json attributes = {{"POSITION", maker.vectors(kept)}};
    json node = {{"mesh", 0}};
    if (skinned) {
      attributes["JOINTS_0"] = maker.accessor(std::vector<std::uint8_t>(4 * kept.size(), 0), "VEC4", 4, glUInt8);
      std::vector<float> weights(4 * kept.size(), 0);
      for (std::size_t v = 0; v < kept.size(); ++v) weights[4 * v] = 1;
      attributes["WEIGHTS_0"] = maker.accessor(weights, "VEC4", 4, glFloat32);
      node["skin"] = 0;
    }
    maker.mesh(attributes, maker.indices(farBar.faces), json::array({{{"POSITION", maker.vectors(offsets)}}}));
    const int child = maker.add("nodes", {{"translation", at({1, 2, 3})}});
    maker.node({{"translation", at(far - Vec3(1, 2, 3))}, {"children", {child}}});
    if (skinned) {
      maker.node(node);
      maker.add("skins", {{"joints", {child}}});
    } else {
      maker.doc["nodes"][child]["mesh"] = 0;
    }
    const Import import = imported(Files().add("a.glb", maker.glb()));
    CAPTURE(skinned);
    CHECK(!warns(import, "rounded-positions"));
    REQUIRE(import.keyframes.keyCount() == 2);
    CHECK(largestDistance(asComputed(import, 0), poseAt(far, 0)) < 4e-7);
    CHECK(largestDistance(asComputed(import, 1), poseAt(far, 0.7)) < 6e-7);
  }
}

TEST_CASE("frames of a numbered series share one offset") {
  Files files;
  for (int i = 0; i < 40; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "f_%02d.obj", i);
    files.add(name, objOf(poseAt(utm, 0.02 * i)));
  }
  ImportOptions options;
  options.sampleTimes = {0, 13 / 24.0, 39 / 24.0};
  const Import import = imported(files, options);
  const int frames[] = {0, 13, 39};
  for (int key = 0; key < 3; ++key)
    CHECK(largestDistance(asComputed(import, key), poseAt(utm, 0.02 * frames[key])) < 4e-7);
}

TEST_CASE("the offset of a saved project is restored, unless its keys have moved") {
  const auto project = [&](const Vec3& saved) {
    AnimationSource source;
    const Scene scene;
    source.faces = &farBar.faces;
    source.scene = &scene;
    source.offset = utm;
    source.seconds = {0, 1};
    source.project = R"({"version": 1, "keys": {"times": [0, 1], "names": ["a", "b"], "frames": [0, 1]}, "offset": [)" +
                     number(saved.x()) + "," + number(saved.y()) + "," + number(saved.z()) + "]}";
    source.frame = [&](int k, std::vector<float>& p, std::vector<float>&) {
      p = floats(poseAt(Vec3::Zero(), 0.5 * k));
      return Status();
    };
    return imported(Files().add("a.glb", *writeAnimatedGlb(source))).offset;
  };
  const Vec3 odd = utm + Vec3(3, 1, -2);
  CHECK(project(odd) == odd);
  CHECK((project(Vec3(9e5, 0, 0)) - utm).norm() < 4);
  CHECK((project(Vec3::Zero()) - utm).norm() < 4);
}

TEST_CASE("distant keys give a warning with the key") {
  const Import import = imported(
      Files().add("a.obj", objOf(poseAt(Vec3::Zero(), 0))).add("b.obj", objOf(poseAt(Vec3(455'000.37, 0, 0), 0.7))));
  CHECK(import.offset == Vec3::Zero());
  CHECK(import.keyframes.keys[0].positions == poseAt(Vec3::Zero(), 0));
  REQUIRE(warns(import, "distant-keys"));
  CHECK(import.warnings.back().key == 1);
}

TEST_CASE("coordinates that are too large are refused with one message") {
  for (double large : {1.5e18, 3e38, 1e39, 1e308}) {
    Positions first = poseAt(Vec3::Zero(), 0);
    first[3].x() = large;
    for (const Format& format : formats) {
      const std::string name = std::string(".") + format.name;
      const auto import = Files().add("a" + name, format.write(first)).add("b" + name, format.write(first)).import();
      REQUIRE(!import.ok());
      CHECK(import.error().code == ErrorCode::TooLarge);
      CHECK(import.error().vertex == 3);
      CHECK(import.error().message.find("Coordinates may be at most") != std::string::npos);
    }
  }
  ImportOptions options;
  options.unit = 1e9;
  Positions pose = poseAt(Vec3::Zero(), 0);
  for (Vec3& p : pose) p *= 1e300;
  CHECK(!Files().add("a.obj", objOf(pose)).add("b.obj", objOf(pose)).import(options).ok());
}

TEST_CASE("shapes that are not finite are not written") {
  std::vector<float> positions = floats(poseAt(Vec3::Zero(), 0));
  positions[4] = std::numeric_limits<float>::infinity();
  CHECK(writeObj(positions, farBar.faces, {}).error().code == ErrorCode::NotFinite);
  CHECK(writePly(positions, farBar.faces).error().code == ErrorCode::NotFinite);
  CHECK(writePoseGlb(positions, {}, farBar.faces, {}).error().code == ErrorCode::NotFinite);
}

}  // namespace shapespline::test::far_offset_test
