// Errors in keys name the key, the location and the remedy.
#include <doctest/doctest.h>

#include <limits>

#include "core/base/format.h"
#include "shapes.h"

namespace shapespline::test::keyframes_test {

namespace {

Keyframes good() {
  Keyframes k = keyframes(bar(), {bend(0), bend(1), bend(2)});
  k.keys[0].name = "a.glb", k.keys[1].name = "b.glb", k.keys[2].name = "c.glb";
  return k;
}

Error refused(const Keyframes& k) {
  const Status status = validate(k);
  REQUIRE(!status.ok());
  auto sequence = Sequence::create(k, {}, {});
  REQUIRE(!sequence.ok());
  CHECK(sequence.error().code == status.error().code);
  return status.error();
}

bool says(const Error& e, const char* words) { return e.message.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("valid keys are accepted") { CHECK(validate(good()).ok()); }

TEST_CASE("invalid keys are refused with the location") {
  Keyframes k = good();
  k.keys.resize(1);
  CHECK(refused(k).code == ErrorCode::TooFewKeys);

  k = good();
  k.keys[1].positions.pop_back();
  Error e = refused(k);
  CHECK(e.code == ErrorCode::VertexCountMismatch);
  CHECK(e.key == 1);
  CHECK(says(e, "b.glb"));
  CHECK(says(e, grouped(std::int64_t(k.keys[1].positions.size())).c_str()));
  CHECK(says(e, grouped(std::int64_t(k.keys[0].positions.size())).c_str()));

  k = good();
  k.keys[2].positions[17].y() = std::numeric_limits<double>::quiet_NaN();
  e = refused(k);
  CHECK(e.code == ErrorCode::NotFinite);
  CHECK(e.key == 2);
  CHECK(e.vertex == 17);

  k = good();
  k.faces[5][1] = k.vertexCount();
  e = refused(k);
  CHECK(e.code == ErrorCode::IndexOutOfRange);
  CHECK(e.face == 5);

  k = good();
  k.faces.clear();
  CHECK(refused(k).code == ErrorCode::NoTriangles);

  k = good();
  for (Vec3& p : k.keys[1].positions) p = Vec3::Ones();
  e = refused(k);
  CHECK(e.code == ErrorCode::NoArea);
  CHECK(e.key == 1);

  k = good();
  k.keys[2].time = k.keys[1].time;
  e = refused(k);
  CHECK(e.code == ErrorCode::TimesNotIncreasing);
  CHECK(e.key == 2);
}

TEST_CASE("different faces are named, with the kind of difference") {
  const std::vector<Triangle> first = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  CHECK(compareFaces(first, first, 1, "x").ok());
  CHECK(compareFaces(first, {{0, 1, 2}}, 1, "x").error().code == ErrorCode::FaceCountMismatch);
  Error e = compareFaces(first, {{0, 1, 2}, {0, 2, 4}, {0, 3, 4}}, 1, "x.glb").error();
  CHECK(e.code == ErrorCode::FaceMismatch);
  CHECK(e.face == 1);
  CHECK(says(e, "x.glb"));
  CHECK(!says(e, "The triangles are the same"));
  CHECK(says(compareFaces(first, {{0, 1, 2}, {0, 3, 4}, {0, 2, 3}}, 1, "x").error(), "a different order"));
  CHECK(says(compareFaces(first, {{0, 2, 1}, {0, 2, 3}, {0, 3, 4}}, 1, "x").error(), "opposite winding"));
}

TEST_CASE("triangles may start at another corner, but must have the same orientation and order") {
  const std::vector<Triangle> first = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  CHECK(compareFaces(first, {{1, 2, 0}, {3, 0, 2}, {0, 3, 4}}, 1, "x").ok());
  CHECK(says(compareFaces(first, {{2, 1, 0}, {3, 0, 2}, {0, 3, 4}}, 1, "x").error(), "opposite winding"));
  CHECK(says(compareFaces(first, {{3, 0, 2}, {1, 2, 0}, {0, 3, 4}}, 1, "x").error(), "a different order"));
  CHECK(compareFaces({{0, 0, 1}}, {{0, 1, 0}}, 1, "x").ok());
  CHECK(!compareFaces({{0, 0, 1}}, {{0, 1, 1}}, 1, "x").ok());
}

TEST_CASE("invalid options are refused and change nothing") {
  EncodingOptions encoding;
  encoding.reference = 3;
  CHECK(Sequence::create(good(), encoding, {}).error().code == ErrorCode::InvalidOption);
  encoding = {};
  encoding.startTangent = Positions(3, Vec3::Zero());
  CHECK(Sequence::create(good(), encoding, {}).error().code == ErrorCode::VertexCountMismatch);

  auto s = Sequence::create(good(), {}, {});
  REQUIRE(s.ok());
  Frame before, after;
  REQUIRE(s->evaluate(0.3, before).ok());
  MotionOptions bad;
  bad.turns = {{0, 1}};
  CHECK(s->update(bad, evenTimes(3)).error().code == ErrorCode::InvalidOption);
  CHECK(s->update({}, {0, 1}).error().code == ErrorCode::TimeCountMismatch);
  CHECK(s->update({}, {0, 2, 1}).error().code == ErrorCode::TimesNotIncreasing);
  CHECK(!s->evaluate(std::numeric_limits<double>::infinity(), after).ok());
  CHECK(!s->evaluateBlend({1, 1, 1}, after).ok());
  REQUIRE(s->evaluate(0.3, after).ok());
  CHECK(before.positions == after.positions);
}

}  // namespace shapespline::test::keyframes_test
