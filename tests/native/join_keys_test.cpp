// Poses of one mesh with different splits, cuts and orders in each file, and errors for other meshes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "gltf_maker.h"
#include "real_data.h"

namespace shapespline::test::join_keys_test {

namespace {

// A strip of quads, bent upwards by `bend` per quad. Quads have 4 vertices each, or share them.
constexpr int quadText = 6;

Vec3 point(int column, int row, double bend) {
  Vec3 p(0, row, 0);
  for (int i = 0; i < column; ++i) p += Vec3(std::cos(bend * i), 0, std::sin(bend * i));
  return p.cast<float>().cast<double>();
}

struct Strip {
  Positions positions;
  std::vector<Triangle> faces;
};

// Vertices by column and row: 2 c and 2 c + 1.
Strip shared(double bend, bool otherDiagonal = false) {
  Strip out;
  for (int c = 0; c <= quadText; ++c)
    out.positions.push_back(point(c, 0, bend)), out.positions.push_back(point(c, 1, bend));
  for (int c = 0; c < quadText; ++c) {
    const int a = 2 * c, b = a + 2, d = a + 1, e = a + 3;  // in cyclic order a b e d
    if (otherDiagonal && c % 2 == 0) out.faces.insert(out.faces.end(), {{a, b, d}, {b, e, d}});
    else out.faces.insert(out.faces.end(), {{a, b, e}, {a, e, d}});
  }
  return out;
}

// Every quad has its own vertices, as flat shading splits them, sorted by vertex or in face order.
Strip flat(double bend, bool sorted, bool otherDiagonal = false) {
  const Strip whole = shared(bend, otherDiagonal);
  std::vector<std::pair<int, int>> copies;  // vertex, quad
  for (std::size_t f = 0; f < whole.faces.size(); ++f)
    for (int v : whole.faces[f])
      if (std::find(copies.begin(), copies.end(), std::pair(v, int(f / 2))) == copies.end())
        copies.push_back({v, int(f / 2)});
  if (sorted) std::sort(copies.begin(), copies.end());
  Strip out;
  for (const auto& [v, quad] : copies) out.positions.push_back(whole.positions[v]);
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    Triangle face;
    for (int c = 0; c < 3; ++c)
      face[c] = int(std::find(copies.begin(), copies.end(), std::pair(whole.faces[f][c], int(f / 2))) - copies.begin());
    out.faces.push_back(face);
  }
  return out;
}

Bytes glbOf(const Strip& strip, json extra = json::object()) {
  GltfMaker maker;
  json attributes = {{"POSITION", maker.vectors(strip.positions)}};
  attributes.update(extra);
  maker.node({{"name", "Strip"}, {"mesh", maker.mesh(attributes, maker.indices(strip.faces))}});
  return maker.glb();
}

Result<Import> joined(const std::vector<Strip>& strips) {
  Files files;
  for (std::size_t j = 0; j < strips.size(); ++j)
    files.add("pose" + std::string(1, char('a' + j)) + ".glb", glbOf(strips[j]));
  return files.import();
}

// Every corner of every key must have the position in its file.
void checkCorners(const Import& import, const std::vector<double>& bends) {
  const Strip mesh = shared(0);
  const Keyframes& k = import.keyframes;
  REQUIRE(k.keyCount() == int(bends.size()));
  const Strip first = shared(bends[0]);
  for (int v = 0; v < k.vertexCount(); ++v) {
    const auto at = std::find(first.positions.begin(), first.positions.end(), k.keys[0].positions[v]);
    REQUIRE(at != first.positions.end());
    for (int j = 1; j < k.keyCount(); ++j)
      CHECK(k.keys[j].positions[v] == shared(bends[j]).positions[at - first.positions.begin()]);
  }
}

// A bent sheet of quads with several kinds of cuts, and with shared vertices or three per triangle.
constexpr int columns = 7, rows = 5;

enum class Split { None, Quads, Triangles };

Vec3 sheetPoint(int v, double bend) {
  Vec3 p = point(v % (columns + 1), 0, bend);
  return Vec3(p.x(), v / (columns + 1), p.z() + 0.1 * (v / (columns + 1)));
}

// The order in which two triangles refer to the corners of a quad.
using Cut = std::array<int, 6>;
constexpr Cut firstPose{0, 1, 2, 0, 2, 3}, secondPose{0, 1, 3, 1, 2, 3}, turnedPose{1, 2, 3, 1, 3, 0},
    ended{3, 0, 1, 2, 3, 1};

Strip sheet(double bend, const std::vector<Cut>& cuts, Split split, bool sorted) {
  std::vector<std::array<int, 2>> corners;  // vertex and copy
  for (int quad = 0; quad < columns * rows; ++quad) {
    const int a = quad / columns * (columns + 1) + quad % columns;
    const int around[] = {a, a + 1, a + columns + 2, a + columns + 1};
    // Avoids a repeating pattern: neighbours in both directions have equal and different cuts.
    const Cut& cut = cuts[(quad * quad + quad / 3) % cuts.size()];
    for (int i = 0; i < 6; ++i)
      corners.push_back({around[cut[i]], split == Split::None ? 0 : split == Split::Quads ? quad : 2 * quad + i / 3});
  }
  std::vector<std::array<int, 2>> vertices;
  for (const auto& corner : corners)
    if (std::find(vertices.begin(), vertices.end(), corner) == vertices.end()) vertices.push_back(corner);
  if (sorted) std::sort(vertices.begin(), vertices.end());
  Strip out;
  for (const auto& [v, copy] : vertices) out.positions.push_back(sheetPoint(v, bend).cast<float>().cast<double>());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (c % 3 == 0) out.faces.emplace_back();
    out.faces.back()[c % 3] = int(std::find(vertices.begin(), vertices.end(), corners[c]) - vertices.begin());
  }
  return out;
}

// Every vertex of the second key must be where the first key's vertex moves.
void checkSheet(const Import& import, double from, double to) {
  const Keyframes& k = import.keyframes;
  for (int v = 0; v < k.vertexCount(); ++v) {
    bool found = false;
    for (int w = 0; w < (columns + 1) * (rows + 1) && !found; ++w)
      found = k.keys[0].positions[v] == sheetPoint(w, from).cast<float>().cast<double>() &&
              k.keys[1].positions[v] == sheetPoint(w, to).cast<float>().cast<double>();
    CHECK(found);
  }
}

}  // namespace

TEST_CASE("poses split by flat shading are one mesh, in any order") {
  for (const bool sorted : {true, false}) {
    CAPTURE(sorted);
    for (const auto& [first, second] : {std::pair{shared(0), flat(0.4, sorted)},
                                        {flat(0, sorted), shared(0.4)},
                                        {flat(0, sorted), flat(0.4, !sorted)}}) {
      const auto import = joined({first, second});
      REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
      CHECK(import->keyframes.vertexCount() == int(first.positions.size()));
      CHECK(import->keyframes.faces == first.faces);
      CHECK(import->warnings.empty());
      checkCorners(*import, {0, 0.4});
    }
  }
}

TEST_CASE("quads cut along the other diagonal get that of the first key, with shared or split vertices") {
  for (const Strip& second : {shared(0.4, true), flat(0.4, true, true), flat(0.4, false, true)}) {
    const auto import = joined({shared(0), second});
    REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
    CHECK(import->keyframes.faces == shared(0).faces);
    checkCorners(*import, {0, 0.4});
    const auto back = joined({second, shared(0)});
    REQUIRE_MESSAGE(back.ok(), (back.ok() ? "" : back.error().message));
    checkCorners(*back, {0.4, 0});
  }
}

TEST_CASE("quads with different splits and diagonals are matched, in any order") {
  const std::vector<Cut> plain{firstPose};
  const std::vector<Cut> mixes[] = {{firstPose, secondPose},
                                    {firstPose, turnedPose},
                                    {secondPose},
                                    {firstPose, firstPose, ended},
                                    {firstPose, secondPose, turnedPose, ended},
                                    {firstPose, firstPose, turnedPose}};
  for (const auto& mix : mixes)
    for (const Split one : {Split::None, Split::Quads, Split::Triangles})
      for (const Split other : {Split::None, Split::Quads, Split::Triangles})
        for (const bool sorted : {true, false}) {
          CAPTURE(&mix - mixes);
          CAPTURE(int(one));
          CAPTURE(int(other));
          CAPTURE(sorted);
          const Strip a = sheet(0, plain, one, sorted), b = sheet(0.2, mix, other, sorted);
          const auto import = joined({a, b});
          CHECK_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
          if (import.ok()) {
            CHECK(import->warnings.empty());
            checkSheet(*import, 0, 0.2);
          }
          const auto back = joined({b, a});
          CHECK_MESSAGE(back.ok(), (back.ok() ? "" : back.error().message));
          if (back.ok()) checkSheet(*back, 0.2, 0);
        }
}

TEST_CASE("triangles that fly apart are still the same mesh") {
  Strip whole = sheet(0, {firstPose}, Split::Triangles, false), apart = whole;
  for (std::size_t f = 0; f < apart.faces.size(); ++f)
    for (const int v : apart.faces[f]) apart.positions[v].y() += double(f) * f;
  const auto import = joined({whole, apart}), back = joined({apart, whole});
  REQUIRE(import.ok());
  REQUIRE(back.ok());
  CHECK(import->keyframes.keys[1].positions == apart.positions);
  CHECK(back->keyframes.keys[1].positions == whole.positions);
}

TEST_CASE("faces in another order are matched") {
  Strip second = shared(0.4);
  std::reverse(second.faces.begin(), second.faces.end());
  const auto import = joined({shared(0), second});
  REQUIRE(import.ok());
  checkCorners(*import, {0, 0.4});
}

TEST_CASE("vertices that coincide in the first key and separate in another are split, with a warning") {
  // The strip as a ring, closed by one vertex pair in the first key and open in the second.
  Strip closed = shared(0), open = shared(0.4);
  for (Triangle& f : closed.faces)
    for (int& v : f) v = v >= 2 * quadText ? v - 2 * quadText : v;
  closed.positions.resize(2 * quadText);
  const auto import = joined({closed, open});
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->keyframes.vertexCount() == 2 * quadText + 2);
  REQUIRE(import->warnings.size() == 1);
  CHECK(import->warnings[0].code == "split-vertices");
  CHECK(import->warnings[0].count == 2);
  const Keyframes& k = import->keyframes;
  for (int f = 0; f < k.faceCount(); ++f)
    for (int c = 0; c < 3; ++c) {
      CHECK(k.keys[0].positions[k.faces[f][c]] == closed.positions[closed.faces[f][c]]);
      CHECK(k.keys[1].positions[k.faces[f][c]] == open.positions[open.faces[f][c]]);
    }
}

TEST_CASE("other meshes are refused with advice") {
  Strip shuffled = flat(0.4, false), fewer = shared(0.4);
  std::rotate(shuffled.faces.begin(), shuffled.faces.begin() + 5, shuffled.faces.end());
  fewer.faces.pop_back();
  const auto counts = joined({shared(0), shuffled}), faces = joined({shared(0), fewer});
  REQUIRE(!counts.ok());
  CHECK(counts.error().code == ErrorCode::VertexCountMismatch);
  REQUIRE(!faces.ok());
  CHECK(faces.error().code == ErrorCode::FaceCountMismatch);
  for (const Error& error : {counts.error(), faces.error()}) {
    CAPTURE(error.message);
    CHECK(error.key == 1);
    CHECK(error.message.starts_with("poseb.glb (key 2) has "));
    CHECK(error.message.find("modifiers applied") != std::string::npos);
    CHECK(error.message.find("OBJ") != std::string::npos);
  }
}

TEST_CASE("one different face makes a different mesh, for any number of faces") {
  Strip other = shared(0.4), more = flat(0.4, false);
  other.faces[3][0] = 13;
  more.faces[3][0] = more.faces[9][0];
  CHECK(joined({shared(0), other}).error().code == ErrorCode::FaceMismatch);
  CHECK(joined({shared(0), more}).error().code == ErrorCode::VertexCountMismatch);
}

TEST_CASE("faces with wrong vertices are refused, but not a mesh with another numbering") {
  const int n = 2 * quadText + 2;
  const Strip mesh = shared(0);
  // Indices from 0 instead of 1, the reverse, and shifts that wrap around at the last vertex.
  for (const int by : {1, n - 1, 2, 5}) {
    CAPTURE(by);
    Strip wrong = shared(0.4), renumbered = shared(0.4);
    for (Triangle& face : wrong.faces)
      for (int& v : face) v = (v + by) % n;
    renumbered.faces = wrong.faces;
    std::rotate(renumbered.positions.begin(), renumbered.positions.begin() + (n - by), renumbered.positions.end());
    const auto import = joined({mesh, wrong});
    REQUIRE(!import.ok());
    CAPTURE(import.error().message);
    CHECK(import.error().code == ErrorCode::FaceMismatch);
    CHECK(import.error().key == 1);
    CHECK(import.error().message.starts_with("poseb.glb (key 2): face 0 is (" + std::to_string(wrong.faces[0][0])));
    const auto good = joined({mesh, renumbered});
    REQUIRE_MESSAGE(good.ok(), (good.ok() ? "" : good.error().message));
    checkCorners(*good, {0, 0.4});
  }
}

TEST_CASE("an OBJ whose faces count its vertices from 0 is refused") {
  const auto obj = [](double bend, int first) {
    const Strip strip = shared(bend);
    std::string text = "v 9 9 9\n";  // an unused vertex
    for (const Vec3& p : strip.positions)
      text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
    for (const Triangle& f : strip.faces)
      text += "f " + std::to_string(f[0] + first) + " " + std::to_string(f[1] + first) + " " +
              std::to_string(f[2] + first) + "\n";
    return bytesOf(text);
  };
  const auto import = Files().add("a.obj", obj(0, 2)).add("b.obj", obj(0.4, 1)).import();
  REQUIRE(!import.ok());
  CHECK(import.error().code == ErrorCode::FaceMismatch);
  CHECK(import.error().message.starts_with(
      "b.obj (key 2): face 0 is (0, 2, 3), but in key 1 it is (1, 3, 4), all counted from 0."));
  CHECK(Files().add("a.obj", obj(0, 2)).add("b.obj", obj(0.4, 2)).import().ok());
}

TEST_CASE("equal keys are named, with the reason and advice") {
  const auto all = joined({shared(0.2), shared(0.2), shared(0.2)});
  REQUIRE(all.ok());
  REQUIRE(all->warnings.size() == 1);
  CHECK(all->warnings[0].code == "same-poses");
  CHECK(all->warnings[0].count == 3);
  CHECK(all->warnings[0].about == "Keys");
  CHECK(all->warnings[0].key == 2);
  CHECK(all->warnings[0].message.starts_with("are the same pose, so nothing moves."));
  CHECK(all->warnings[0].message.find("Apply the modifiers") != std::string::npos);
  const auto some = joined({shared(0), shared(0.2), shared(0.2)});
  REQUIRE(some.ok());
  REQUIRE(some->warnings.size() == 1);
  CHECK(some->warnings[0].count == 2);
  CHECK(some->warnings[0].message.starts_with("are the same pose, so nothing moves between them."));
  // A loop may end as it began.
  CHECK(joined({shared(0), shared(0.2), shared(0)})->warnings.empty());
}

TEST_CASE("poses get the vertices of the given mesh") {
  const Strip mesh = shared(0), split = flat(0.4, false);
  ImportOptions options;
  options.like = mesh.faces;
  options.likePose = mesh.positions;
  const auto import = Files().add("a.glb", glbOf(split)).add("b.glb", glbOf(flat(0.2, true))).import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  CHECK(import->keyframes.faces == mesh.faces);
  CHECK(import->keyframes.keys[0].positions == shared(0.4).positions);
  CHECK(import->keyframes.keys[1].positions == shared(0.2).positions);
  options.like[0][0] = 999;
  CHECK(Files().add("a.glb", glbOf(split)).add("b.glb", glbOf(split)).import(options).error().code ==
        ErrorCode::InvalidOption);
}

TEST_CASE("vertex colours that are all zero are ignored") {
  const Strip strip = shared(0);
  const auto withColours = [&](float green) {
    GltfMaker maker;
    std::vector<float> colours(4 * strip.positions.size(), 0);
    colours[5] = green;
    json attributes = {{"POSITION", maker.vectors(strip.positions)},
                       {"COLOR_0", maker.accessor(colours, "VEC4", 4, glFloat32)}};
    maker.node({{"mesh", maker.mesh(attributes, maker.indices(strip.faces))}});
    return Files().add("a.glb", maker.glb()).add("b.glb", glbOf(shared(0.4))).import()->scene.colors;
  };
  CHECK(withColours(0).empty());
  CHECK(withColours(0.5f).size() == 4 * strip.positions.size());
}

TEST_CASE("objects of a glTF and of an OBJ can be excluded") {
  const auto scene = [](double bend) {
    GltfMaker maker;
    const Strip strip = shared(bend), floor = shared(0);
    maker.node({{"name", "Strip"},
                {"mesh", maker.mesh({{"POSITION", maker.vectors(strip.positions)}}, maker.indices(strip.faces))}});
    maker.node({{"name", "Floor"},
                {"mesh", maker.mesh({{"POSITION", maker.vectors(floor.positions)}}, maker.indices(floor.faces))}});
    return maker.glb();
  };
  const std::string obj =
      "o Floor\nv 0 0 0\nv 9 0 0\nv 9 9 0\nf 1 2 3\no Thing\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 2\nusemtl none\nf 4 5 6 "
      "7\n";
  ImportOptions options;
  const auto check = [&](const Files& files, std::vector<std::string> names, const std::string& one, int vertices) {
    options.objects = {};
    const auto all = files.import(options);
    REQUIRE_MESSAGE(all.ok(), (all.ok() ? "" : all.error().message));
    CHECK(all->objects == names);
    options.objects = {one};
    const auto some = files.import(options);
    REQUIRE_MESSAGE(some.ok(), (some.ok() ? "" : some.error().message));
    CHECK(some->objects == names);
    CHECK(some->keyframes.vertexCount() == vertices);
    options.objects = {"Roof"};
    const auto none = files.import(options);
    REQUIRE(!none.ok());
    CHECK(none.error().code == ErrorCode::UnknownObject);
    CHECK(none.error().message.find(names[0]) != std::string::npos);
  };
  check(Files().add("a.glb", scene(0)).add("b.glb", scene(0.4)), {"Strip", "Floor"}, "Strip", 2 * quadText + 2);
  check(Files().add("a.obj", bytesOf(obj)).add("b.obj", bytesOf(obj + "o Empty\n")), {"Floor", "Thing"}, "Thing", 4);
}

TEST_CASE("objects that some files do not have are excluded, with a warning") {
  const auto scene = [](double bend, const std::vector<std::string>& names) {
    GltfMaker maker;
    for (const std::string& name : names) {
      const Strip strip = name == "Strip" ? shared(bend) : sheet(0, {firstPose}, Split::None, true);
      maker.node({{"name", name},
                  {"mesh", maker.mesh({{"POSITION", maker.vectors(strip.positions)}}, maker.indices(strip.faces))}});
    }
    return maker.glb();
  };
  const auto poses = [&](const std::vector<std::vector<std::string>>& names) {
    Files files;
    for (std::size_t j = 0; j < names.size(); ++j)
      files.add("pose" + std::string(1, char('a' + j)) + ".glb", scene(0.1 * double(j), names[j]));
    return files.import();
  };
  const std::vector<std::string> one{"Strip"}, floor{"Strip", "Floor"}, lamp{"Lamp", "Strip"};
  for (const auto& names : {std::vector{floor, one, floor}, {one, floor, one}, {floor, lamp, one}}) {
    const auto import = poses(names);
    REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
    checkCorners(*import, {0, 0.1, 0.2});
    CHECK(import->objects == one);
    REQUIRE(import->warnings.size() == 1);
    CHECK(import->warnings[0].code == "left-out-objects");
    CHECK(import->warnings[0].message.find("\"Strip\"") != std::string::npos);
  }
  // An equal object with a new name has been renamed.
  const auto renamed = poses({floor, lamp, floor});
  REQUIRE(renamed.ok());
  CHECK(renamed->objects == floor);
  CHECK(renamed->warnings.empty());
  const auto none = poses({{"Floor", "Lamp"}, {"Strip", "Roof"}});
  REQUIRE(!none.ok());
  CHECK(none.error().message.find("Its objects are \"Strip\", \"Roof\"") != std::string::npos);
  // All objects are present in another order.
  const auto turned = poses({{"Strip", "Floor"}, {"Floor", "Strip"}});
  CHECK(turned.ok());
}

TEST_CASE("Blender's poses: flat shading, other diagonals, modifiers that are not applied") {
  if (!hasData({"blender"})) return;
  const auto blender = [](const std::string& name) {
    return realFiles({"blender/" + name + "_0.glb", "blender/" + name + "_1.glb", "blender/" + name + "_2.glb"})
        .import();
  };
  const auto split = blender("baked_flat"), cut = blender("suzsm"), still = blender("apply");
  REQUIRE_MESSAGE(split.ok(), (split.ok() ? "" : split.error().message));
  CHECK(split->keyframes.vertexCount() == 1584);
  CHECK(split->warnings.empty());
  REQUIRE_MESSAGE(cut.ok(), (cut.ok() ? "" : cut.error().message));
  CHECK(cut->keyframes.vertexCount() == 555);
  REQUIRE(still.ok());
  REQUIRE(still->warnings.size() == 1);
  CHECK(still->warnings[0].code == "same-poses");
  CHECK(still->warnings[0].message.find("bones are at rest") != std::string::npos);
}

}  // namespace shapespline::test::join_keys_test
