// PC2 and MDD with their OBJ, and numbered files, as animations with sampled keys.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "files.h"
#include "io/import_hints.h"

namespace shapespline::test::point_cache_test {

namespace {

constexpr int frameCount = 40;

const Positions squareText = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};

std::string objOf(const Positions& positions) {
  std::string text;
  for (const Vec3& p : positions)
    text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  return text + "f 1 2 3 4\n";
}

// The square rises by a quarter per frame.
Positions frameAt(double frame) {
  Positions out = squareText;
  out[2].z() += frame / 4;
  return out;
}

struct Writer {
  bool bigEndian;
  Bytes bytes{};

  void word(std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * (bigEndian ? 3 - i : i)));
  }
  void number(double value) { word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void frames(const Mat3& axes) {
    for (int f = 0; f < frameCount; ++f)
      for (const Vec3& p : frameAt(f))
        for (int c = 0; c < 3; ++c) number((axes * p)[c]);
  }
};

Bytes pc2(std::uint32_t points = 4, std::uint32_t frames = frameCount, const Mat3& axes = Mat3::Identity()) {
  Writer out{false, bytesOf(std::string_view("POINTCACHE2\0", 12))};
  out.word(1), out.word(points), out.number(10), out.number(2), out.word(frames);
  out.frames(axes);
  return out.bytes;
}

Bytes mdd(std::uint32_t points = 4, std::uint32_t frames = frameCount, double step = 0.1) {
  Writer out{true};
  out.word(frames), out.word(points);
  for (int f = 0; f < frameCount; ++f) out.number(step * f);
  out.frames(Mat3::Identity());
  return out.bytes;
}

Result<Import> moved(const std::string& name, const Bytes& cache, const ImportOptions& options = {}) {
  return Files().add("square.obj", bytesOf(objOf(squareText))).add(name, cache).import(options);
}

void checkKey(const Import& import, int key, double frame) {
  const Positions wanted = frameAt(frame);
  for (std::size_t v = 0; v < wanted.size(); ++v)
    CHECK((import.keyframes.keys[key].positions[v] - wanted[v]).norm() < 1e-5);
}

}  // namespace

TEST_CASE("PC2 and MDD with their OBJ are sampled at given times, also between frames") {
  ImportOptions options;
  options.sampleTimes = {1, 1.025, 1.5};  // PC2: frame 10 + 2 f at 24 per second
  const auto a = moved("cache.pc2", pc2(), options);
  REQUIRE_MESSAGE(a.ok(), (a.ok() ? "" : a.error().message));
  for (int key = 0; key < 3; ++key) checkKey(*a, key, (24 * options.sampleTimes[key] - 10) / 2);
  CHECK(a->animations.at(0).name == "cache");
  CHECK(a->animations.at(0).keys == frameCount);
  CHECK(a->animations.at(0).start == doctest::Approx(10.0 / 24));
  const auto b = moved("cache.mdd", mdd(), options);
  REQUIRE_MESSAGE(b.ok(), (b.ok() ? "" : b.error().message));
  for (int key = 0; key < 3; ++key) checkKey(*b, key, 10 * options.sampleTimes[key]);
  const auto even = moved("cache.mdd", mdd());
  REQUIRE(even.ok());
  CHECK(even->keyframes.keyCount() == 8);
  for (const Key& key : even->keyframes.keys) CHECK(10 * key.time == doctest::Approx(std::round(10 * key.time)));
  checkKey(*even, 7, frameCount - 1);
}

TEST_CASE("a cache with other axes than its OBJ is rotated") {
  Mat3 zUp;
  zUp << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const auto import = moved("cache.pc2", pc2(4, frameCount, zUp));
  REQUIRE(import.ok());
  checkKey(*import, 0, 0);
  checkKey(*import, 7, frameCount - 1);
}

TEST_CASE("equal times are replaced by frame numbers") {
  const auto import = moved("cache.mdd", mdd(4, frameCount, 0));
  REQUIRE(import.ok());
  CHECK(import->animations.at(0).end == doctest::Approx((frameCount - 1) / 24.0));
}

TEST_CASE("invalid caches are refused before allocating memory") {
  const auto refused = [](const Result<Import>& import, ErrorCode code, const std::string& says) {
    REQUIRE(!import.ok());
    CAPTURE(import.error().message);
    CHECK(std::string(errorCodeName(import.error().code)) == errorCodeName(code));
    CHECK(import.error().message.find(says) != std::string::npos);
  };
  refused(moved("a.pc2", pc2(5, 4)), ErrorCode::VertexCountMismatch, "has 5 points");
  refused(moved("a.pc2", pc2(0xffffffff, 0xffffffff)), ErrorCode::TruncatedFile, "4,294,967,295");
  refused(moved("a.mdd", mdd(0xffffffff, 0xffffffff)), ErrorCode::TruncatedFile, "a.mdd is cut off");
  refused(moved("a.mdd", mdd(4, frameCount + 1)), ErrorCode::TruncatedFile, "a.mdd");
  refused(moved("a.pc2", pc2(0, 0xffffffff)), ErrorCode::MalformedFile, "no points");
  refused(moved("a.mdd", mdd(4, 0)), ErrorCode::MalformedFile, "no points");
  refused(moved("a.mdd", {0, 0, 0}), ErrorCode::TruncatedFile, "header");
  Bytes cut = pc2();
  cut.resize(30);
  refused(moved("a.pc2", cut), ErrorCode::TruncatedFile, "header");
  refused(Files().add("a.pc2", pc2()).import(), ErrorCode::TooFewKeys, "Give its OBJ");
  refused(Files().add("a.pc2", pc2()).add("b.mdd", mdd()).import(), ErrorCode::InvalidOption, "one OBJ");
  Bytes nan = mdd();
  for (std::size_t i = nan.size() - 48; i < nan.size(); ++i) nan[i] = 0xff;
  refused(moved("a.mdd", nan), ErrorCode::NotFinite, "not a finite number");
  ImportOptions options;
  options.animation = 3;
  refused(moved("a.mdd", mdd(), options), ErrorCode::UnknownAnimation, "no animation 3");
}

TEST_CASE("numbered files are frames of an animation if samples are requested, or if there are many") {
  const auto series = [](int count) {
    Files files;
    for (int f = 0; f < count; ++f)
      files.add("run/walk_" + std::to_string(100 + f) + ".obj", bytesOf(objOf(frameAt(f))));
    return files;
  };
  ImportOptions options;
  options.sampleTimes = {0, 0.25, 0.3};
  const auto sampled = series(12).import(options);
  REQUIRE_MESSAGE(sampled.ok(), (sampled.ok() ? "" : sampled.error().message));
  for (int key = 0; key < 3; ++key) checkKey(*sampled, key, 24 * options.sampleTimes[key]);
  CHECK(sampled->animations.at(0).name == "walk");
  const auto keys = series(12).import();
  REQUIRE(keys.ok());
  CHECK(keys->keyframes.keyCount() == 12);
  CHECK(keys->animations.size() == 1);
  CHECK(keys->animation == -1);
  CHECK(series(3).import()->animations.empty());
  const auto many = series(60).import();
  REQUIRE(many.ok());
  CHECK(many->keyframes.keyCount() == 8);
  checkKey(*many, 7, 59);
  CHECK(many->warnings.at(0).code == "numbered-files");
  Files broken = series(60);
  broken.bytes[59] = bytesOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto refused = broken.import();
  REQUIRE(!refused.ok());
  CHECK(refused.error().message.starts_with("walk_159.obj (key 60)"));
}

TEST_CASE("files without an up axis give a hint if they stand on z") {
  const std::string header =
      "element vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 5\n"
      "property list uchar int vertex_indices\nend_header\n";
  // A frustum with its wide end down.
  const std::string stump =
      "-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n-1 -1 3\n1 -1 3.5\n1 1 3\n-1 1 3.5\n4 3 2 1 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n"
      "4 3 0 4 7\n";
  const auto codes = [](const std::string& name, const std::string& text, bool zUp = false) {
    ImportOptions options;
    options.zUp = zUp;
    const auto import = Files().add(name, bytesOf(text)).add("b" + name, bytesOf(text)).import(options);
    std::vector<std::string> out;
    if (import.ok())
      for (const Warning& warning : import->warnings) out.push_back(warning.code);
    return out;
  };
  const auto has = [](const std::vector<std::string>& list, const char* code = "z-up") {
    return std::find(list.begin(), list.end(), code) != list.end();
  };
  const std::string plain = "ply\nformat ascii 1.0\n" + header + stump;
  const std::string blender = "ply\nformat ascii 1.0\ncomment Created in Blender version 4.5.4\n" + header + stump;
  CHECK(has(codes("a.ply", plain)));
  CHECK(has(codes("a.ply", blender)));
  CHECK(!has(codes("a.ply", blender, true)));
  CHECK(has(codes("a.off", "OFF\n8 5 0\n" + stump)));
  std::string upright =
      "OFF\n8 5 0\n-2 0 -2\n2 0 -2\n2 0 2\n-2 0 2\n-1 3 -1\n1 3.5 -1\n1 3 1\n-1 3.5 1\n4 3 2 1 0\n4 0 1 5 4\n"
      "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  CHECK(!has(codes("a.off", upright)));
  CHECK(!has(codes("a.off", "# Blender v4.5\n" + upright)));
  CHECK(has(codes("a.off", "# Blender v4.5\n" + upright), "z-up-unclear"));
  // Four pointed feet under a leaning body: no flat base, but it would tip over along y.
  const auto onFeet = [](bool zUp) {
    const std::vector<Vec3> points = {{-1, -2, 0}, {1, -2, 0}, {1, 2, 0}, {-1, 2, 0}, {0, -3, 2}, {0, 3, 3.5}};
    std::string text = "OFF\n6 8 0\n";
    for (const Vec3& p : points)
      text += std::to_string(p.x()) + ' ' + std::to_string(zUp ? p.y() : p.z()) + ' ' +
              std::to_string(zUp ? p.z() : -p.y()) + '\n';
    return text + "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 0 1 5\n3 1 2 5\n3 2 3 5\n3 3 0 5\n";
  };
  CHECK(has(codes("a.off", onFeet(true))));
  CHECK(!has(codes("a.off", onFeet(false))));
}

TEST_CASE("keys too far apart in an animation are named, as long as they are evenly spaced") {
  const auto isNamed = [](const std::vector<double>& places, const std::vector<double>& times, int animation = 0) {
    Import import;
    import.animation = animation;
    for (std::size_t k = 0; k < places.size(); ++k)
      import.keyframes.keys.push_back({"", times[k], {Vec3(places[k], 0, 0), Vec3(0, 1, 0)}});
    warnOfDistantKeys(import);
    return import.warnings.size() == 1 && import.warnings[0].code == "keys-far-apart";
  };
  const std::vector<double> even = {0, 1, 2, 3}, uneven = {0, 1, 2, 4}, swinging = {0, 1, 0, 1}, going = {0, 1, 2, 2};
  CHECK(isNamed(swinging, even));
  CHECK(!isNamed(going, even));
  CHECK(!isNamed(swinging, uneven));
  CHECK(!isNamed({0, 1, 0}, {0, 1, 2}));
  CHECK(!isNamed(swinging, even, -1));
}

}  // namespace shapespline::test::point_cache_test
