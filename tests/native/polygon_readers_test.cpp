// OBJ, PLY and OFF: contents, polygon cuts, and rejected files.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gltf_maker.h"
#include "io/polygon/polygon_mesh.h"

namespace shapespline::test::polygon_readers_test {

namespace {

// Keeps only warnings from the files, because all keys here are one pose.
Import imported(const Files& files, const ImportOptions& options = {}) {
  auto result = files.import(options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  std::erase_if(result->warnings, [](const Warning& warning) { return warning.code == "same-poses"; });
  return std::move(*result);
}

Import twice(const std::string& name, const Bytes& bytes) {
  return imported(Files().add(name, bytes).add("second-" + name, bytes));
}
Import twice(const std::string& name, const std::string& text) { return twice(name, bytesOf(text)); }

const std::string squareObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const std::string squarePly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
const std::string squareOff = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

std::string goodTwin(const std::string& name) {
  return name.ends_with("obj") ? squareObj : name.ends_with("ply") ? squarePly : squareOff;
}

void checkRefused(const std::string& name, const Bytes& bytes, ErrorCode code, const std::string& says) {
  CAPTURE(std::string(bytes.begin(), bytes.end()));
  const auto alone = Files().add(name, bytes).import();
  REQUIRE(!alone.ok());
  CAPTURE(alone.error().message);
  CHECK(std::string(errorCodeName(alone.error().code)) == errorCodeName(code));
  CHECK(alone.error().message.find(says) != std::string::npos);
  CHECK(alone.error().message.find(name) != std::string::npos);
  const auto second = Files().add("good-" + name, bytesOf(goodTwin(name))).add(name, bytes).import();
  REQUIRE(!second.ok());
  CHECK(std::string(errorCodeName(second.error().code)) == errorCodeName(code));
  CHECK(second.error().key == 1);
}

void checkRefused(const std::string& name, const std::string& text, ErrorCode code, const std::string& says) {
  checkRefused(name, bytesOf(text), code, says);
}

double area(const Positions& p, const Triangle& f) { return 0.5 * (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).norm(); }

}  // namespace

TEST_CASE("the square is equal in all three formats") {
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"a.obj", squareObj}, {"a.ply", squarePly}, {"a.off", squareOff}}) {
    const Import import = twice(name, text);
    CHECK(import.keyframes.vertexCount() == 4);
    REQUIRE(import.keyframes.faceCount() == 2);
    CHECK((import.keyframes.keys[0].positions[2] - Vec3(1, 1, 0)).norm() == 0);
    REQUIRE(import.scene.groups.size() == 1);
    CHECK(import.scene.groups[0].count == 2);
  }
}

TEST_CASE("OBJ: comments, negative indices, all kinds of corners, continued lines, ignored statements") {
  const Import import = twice("a.obj",
                              "# a comment\r\no thing\r\ns 1\r\nv 0 0 0 1\r\nv 1 0 0 # here\r\nv 1 1 0\r\nv 0 1 "
                              "0\r\nvt 0 0\r\nvt 1 0\r\nvt 1 1\r\nvt 0 1\r\nvn 0 0 1\r\n"
                              "f -4/1/1 -3/2/1 \\\r\n -2/3/1\r\nf 1//1 3//1 4//1\r\nl 1 2\r\np 1\r\nf 1 2\r\n");
  CHECK(import.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  REQUIRE(import.keyframes.normals.size() == 4);
  CHECK((import.keyframes.normals[3] - Vec3::UnitZ()).norm() == 0);
  CHECK(import.scene.uvs == std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0});  // vertex 3 has no coordinates
  CHECK(import.scene.seams.copyOf.empty());
  CHECK(import.warnings.at(0).code == "skipped-primitives");
  CHECK(import.warnings.at(0).count == 3);
}

TEST_CASE("a byte order mark is skipped") {
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"a.obj", squareObj}, {"a.ply", squarePly}, {"a.off", squareOff}}) {
    CAPTURE(name);
    CHECK(twice(name, "\xef\xbb\xbf" + text).keyframes.keys[0].positions ==
          twice(name, text).keyframes.keys[0].positions);
  }
}

TEST_CASE("OBJ: texture coordinates with the origin at the top, and copies of vertices with several of them") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.25\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\n";
  const Import kept = twice("a.obj", vertices + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  REQUIRE(kept.scene.uvs.size() == 8);
  CHECK(kept.scene.uvs[1] == 0.75f);
  CHECK(kept.scene.seams.copyOf.empty());
  CHECK(kept.scene.seams.faces.empty());
  const Import seam = twice("a.obj", vertices + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n");
  CHECK(seam.warnings.empty());
  CHECK(seam.keyframes.vertexCount() == 4);
  CHECK(seam.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  CHECK(seam.scene.seams.copyOf == std::vector<int>{0});
  CHECK(seam.scene.seams.faces == std::vector<Triangle>{{0, 1, 2}, {4, 2, 3}});
  CHECK(seam.scene.uvs == std::vector<float>{0, 0.75f, 1, 1, 1, 0, 0, 0, 0.5f, 0.5f});
}

TEST_CASE("OBJ: one copy for all corners of a vertex with the same texture region") {
  // A fan around vertex 1. Its sectors alternate between two regions of the texture, and vertices in several regions
  // are duplicated.
  std::string text = "v 0 0 0\n", faces;
  for (int i = 0; i <= 6; ++i) text += "v " + std::to_string(i) + " 1 0\nvt " + std::to_string(i % 2) + " 0.5\n";
  for (int i = 0; i < 6; ++i)
    faces += "f 1/" + std::to_string(i + 1) + " " + std::to_string(i + 2) + "/1 " + std::to_string(i + 3) + "/1\n";
  const Import import = twice("a.obj", text + faces);
  CHECK(import.scene.seams.copyOf == std::vector<int>{0});
  for (int f = 0; f < 6; ++f) CHECK(import.scene.seams.faces[f][0] == (f % 2 ? 8 : 0));
}

TEST_CASE("polygons of further poses are split like those of the mesh") {
  const std::string faces = "f 1 2 3 4\nf 5 6 7 8 9\nf 1 2 6\n";
  // x determines the shorter diagonal of the first polygon and the reflex corner of the second
  const auto pose = [&](double x) {
    return bytesOf("v 0 0 0\nv 1 0 0\nv " + std::to_string(1 + x) + " 1 0\nv " + std::to_string(x) +
                   " 1 0\nv 0 5 0\nv 2 5 0\nv " + std::to_string(2 - x) + " 6 0\nv 1 7 0\nv 0 7 0\n" + faces);
  };
  const std::vector<Triangle> mine = imported(Files().add("a.obj", pose(0.5)).add("b.obj", pose(-0.5))).keyframes.faces;
  const std::vector<Triangle> others =
      imported(Files().add("a.obj", pose(-0.5)).add("b.obj", pose(0.5))).keyframes.faces;
  REQUIRE(mine != others);
  ImportOptions options;
  options.like = mine;
  CHECK(imported(Files().add("a.obj", pose(-0.5)).add("b.obj", pose(-0.5)), options).keyframes.faces == mine);
  options.like[1][1] = 8;  // a different mesh, so the poses get their own cuts
  CHECK(imported(Files().add("a.obj", pose(-0.5)).add("b.obj", pose(-0.5)), options).keyframes.faces == others);
  options.like = {{0, 1, 2}};
  CHECK(imported(Files().add("a.obj", pose(-0.5)).add("b.obj", pose(-0.5)), options).keyframes.faces == others);
}

TEST_CASE("OBJ: polygons with seams are split like their faces; later keys can have other coordinates") {
  const std::string house =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.5 1.5 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\nvt 0 "
      "1\nvt 0.25 0.25\n";
  const auto obj = [&](const std::string& faces) { return bytesOf(house + faces); };
  const auto first = obj("f 1/1 2/2 3/3 4/4 5/5\nf 2/6 6/2 7/3 3/1\n"),
             second = obj("f 1/1 2/1 3/1 4/1 5/1\nf 2/2 6/2 7/2 3/2\n");
  const Import import =
      imported(Files().add("a.obj", first).add("b.obj", second).add("c.obj", obj("f 1 2 3 4 5\nf 2 6 7 3\n")));
  const Seams& seams = import.scene.seams;
  CHECK(seams.copyOf == std::vector<int>{1, 2});
  REQUIRE(seams.faces.size() == 5);
  for (int f = 0; f < 5; ++f)
    for (int c = 0; c < 3; ++c) {
      const int drawn = seams.faces[f][c];
      CHECK(import.keyframes.faces[f][c] == (drawn < 7 ? drawn : seams.copyOf[drawn - 7]));
      if (f >= 3) CHECK((drawn >= 5));  // no vertex of the second polygon has the first polygon's coordinates
    }
}

TEST_CASE("OBJ: missing or invalid coordinates are omitted with a warning") {
  const Import import = twice("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.5\nvt nan 0\nf 1/1 2/2 3/7\n");
  CHECK(import.scene.uvs == std::vector<float>{0.5f, 0.5f, 0, 0, 0, 0});
  REQUIRE(import.warnings.size() == 1);
  CHECK(import.warnings[0].code == "texture-coordinates");
  CHECK(import.warnings[0].count == 2);
}

TEST_CASE("OBJ: a vertex with a hundred thousand texture coordinates takes no longer than as many vertices") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", faces;
  for (int i = 1; i <= 100'000; ++i) {
    text += "vt 0." + std::to_string(100'000 + i) + " 0\n";
    faces += "f 1/" + std::to_string(i) + " 2/1 3/1\n";
  }
  CHECK(twice("a.obj", text + faces).scene.seams.copyOf.size() == 99'999);
}

TEST_CASE("OBJ: materials of its MTL, and its texture") {
  const std::string obj =
      "mtllib my skin.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 1 3 4\nusemtl none\nf 1 2 4\n";
  const std::string mtl = "newmtl blue\nKd 0 0 1\nnewmtl red\nKd 1 0.5 0\nd 0.5\nmap_Kd -s 1 1 1 tex/my red.png\n";
  const Bytes png = bytesOf("\x89PNG\r\n\x1a\n and so on");
  const Scene scene = imported(Files()
                                   .add("a.obj", bytesOf(obj))
                                   .add("b.obj", bytesOf(obj))
                                   .add("my skin.mtl", bytesOf(mtl))
                                   .add("tex/my red.png", png))
                          .scene;
  REQUIRE(scene.materials.size() == 2);
  CHECK(scene.materials[1].name == "red");
  CHECK(scene.materials[1].baseColor[1] == doctest::Approx(std::pow((0.5 + 0.055) / 1.055, 2.4)));
  CHECK(scene.materials[1].baseColor[3] == 0.5f);
  REQUIRE(scene.materials[1].baseColorImage == 0);
  CHECK(scene.images[0].bytes == png);
  REQUIRE(scene.groups.size() == 3);
  CHECK(scene.groups[0].material == -1);
  CHECK(scene.groups[1].material == 1);
  CHECK(scene.groups[1].start == 1);
  CHECK(scene.groups[2].material == -1);
  const Import without = twice("a.obj", obj);
  CHECK(without.warnings.at(0).code == "missing-materials");
}

TEST_CASE("OBJ: images are relative to their library, and clamped if it says so") {
  const Bytes red = bytesOf("\x89PNG\r\n\x1a\n red"), blue = bytesOf("\x89PNG\r\n\x1a\n blue");
  const Bytes obj = bytesOf("mtllib paint/a.mtl\n" + squareObj),
              mtl = bytesOf(
                  "newmtl a\nmap_Kd -clamp on -s 1 1 1 images/skin.png\nnewmtl b\nmap_Kd -clamp off ../on top.png\n");
  const Import import = imported(Files()
                                     .add("x/a.obj", obj)
                                     .add("x/b.obj", obj)
                                     .add("x/paint/a.mtl", mtl)
                                     .add("x/images/skin.png", blue)
                                     .add("x/paint/images/skin.png", red)
                                     .add("x/on top.png", blue));
  REQUIRE(import.scene.images.size() == 2);
  const auto& materials = import.scene.materials;
  CHECK(import.scene.images[materials.at(0).baseColorImage].bytes == red);
  CHECK(materials[0].wrapS == Material::Wrap::Clamp);
  CHECK(import.scene.images[materials.at(1).baseColorImage].bytes == blue);
  CHECK(materials[1].wrapT == Material::Wrap::Repeat);
  CHECK(import.warnings.empty());
}

TEST_CASE("OBJ: a library and an image are read once, even if named several times") {
  std::string obj, mtl;
  for (int i = 0; i < 3'000; ++i)
    obj += "mtllib a.mtl\n", mtl += "newmtl m" + std::to_string(i) + "\nmap_Kd a.png\nmap_Kd none.png\nmap_Kd a.png\n";
  for (std::string way = "./"; way.size() < 2'000; way += "./")
    obj += "mtllib " + way + "a.mtl\n", mtl += "map_Kd " + way + "a.png\n";
  Bytes png(1'000'000, 0);
  const Bytes magic{0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  std::copy(magic.begin(), magic.end(), png.begin());
  const Import import = imported(Files()
                                     .add("a.obj", bytesOf(obj + squareObj))
                                     .add("b.obj", bytesOf(squareObj))
                                     .add("a.mtl", bytesOf(mtl))
                                     .add("a.png", png));
  CHECK(import.scene.materials.size() == 3'000);
  CHECK(import.scene.images.size() == 1);
  CHECK(import.scene.materials.back().baseColorImage == 0);
  CHECK(import.warnings.size() == 1);
}

TEST_CASE("OBJ and PLY: vertex colours") {
  const Import obj = twice("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 0.5\nf 1 2 3\n");
  REQUIRE(obj.scene.colors.size() == 12);
  CHECK(obj.scene.colors[5] == 1);
  CHECK(obj.scene.colors[10] == doctest::Approx(0.21404));
  const Import ply =
      twice("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int "
            "vertex_index\nend_header\n"
            "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 0\n3 0 1 2\n");
  CHECK(ply.scene.colors[0] == 1);
  CHECK(ply.scene.colors[4] == 0);
}

TEST_CASE("vertex colours with any names and ranges") {
  const auto ply = [](const std::string& types, const std::string& numbers) {
    return twice("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                     types + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 " + numbers +
                     "\n1 0 0 " + numbers + "\n0 1 0 " + numbers + "\n3 0 1 2\n")
        .scene.colors;
  };
  const auto properties = [](const std::string& type, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += "property " + type + " " + name + "\n";
    return text;
  };
  const auto check = [](const std::vector<float>& colors, float alpha = 1) {
    REQUIRE(colors.size() == 12);
    CHECK(colors[0] == 0);
    CHECK(colors[1] == doctest::Approx(0.0512695));  // 64 of 255
    CHECK(colors[2] == 1);
    CHECK(colors[11] == doctest::Approx(alpha));
  };
  const std::vector<std::string> rgb{"red", "green", "blue"};
  for (const char* type : {"uchar", "float", "double", "int", "uint", "ushort"})
    check(ply(properties(type, rgb), "0 64 255"));
  check(ply(properties("float", rgb), "0 0.25098 1"));
  check(ply(properties("ushort", rgb), "0 16448 65535"));
  check(ply(properties("uchar", {"r", "g", "b", "a"}), "0 64 255 51"), 0.2f);
  check(ply(properties("float", {"diffuse_red", "diffuse_green", "diffuse_blue", "alpha"}), "0 64 255 0.2"), 0.2f);
  check(ply(properties("uchar", {"Red", "Green", "Blue"}), "0 64 255"));

  for (const char* head : {"COFF", "OFF"})
    for (const char* color : {"0 64 255", "0 64 255 255", "0 0.25098 1 1"}) {
      const std::string c = color;
      check(twice("a.off", std::string(head) + "\n3 1 0\n0 0 0 " + c + "\n1 0 0 " + c + "\n0 1 0 " + c + "\n3 0 1 2\n")
                .scene.colors);
    }
  const Import both = twice(
      "a.off",
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 0 64 255 .5 .5\n1 0 0 0 0 1 0 64 255 0 0\n0 1 0 0 0 1 0 64 255 1 0\n3 0 1 2\n");
  check(both.scene.colors);
  CHECK(both.keyframes.normals.at(2) == Vec3::UnitZ());

  check(twice("a.obj", "v 0 0 0 0 64 255\nv 1 0 0 0 64 255\nv 0 1 0 \nf 1 2 3\n").scene.colors);
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check(twice("a.obj", vertices + "#MRGB ff0040ffff0040FF\n#mrgb 000040ff\nf 1 2 3\n").scene.colors);
}

TEST_CASE("colours of faces are left out with a warning, unless vertices have colours") {
  const auto warned = [](const Import& import) {
    return import.warnings.size() == 1 && import.warnings[0].code == "face-colors";
  };
  const auto ply = [](const std::string& ofVertices, const std::string& number) {
    return twice("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                     ofVertices +
                     "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                     "property uchar green\nproperty uchar blue\nend_header\n0 0 0" +
                     number + "\n1 0 0" + number + "\n0 1 0" + number + "\n3 0 1 2 9 9 9\n");
  };
  CHECK(warned(ply("", "")));
  CHECK(ply("property uchar red\nproperty uchar green\nproperty uchar blue\n", " 1 2 3").warnings.empty());
  CHECK(warned(twice("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n")));
  CHECK(twice("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n").warnings.empty());
}

TEST_CASE("a vertex without faces does not need finite coordinates") {
  const auto check = [](const std::string& name, const std::string& text) {
    CAPTURE(text);
    const Import import = twice(name, text);
    CHECK(import.keyframes.vertexCount() == 4);
    for (const Vec3& p : import.keyframes.keys[1].positions) CHECK(p.norm() < 2);
  };
  for (const std::string number : {"nan", "-nan(ind)", "inf", "1.#QNAN", "-1.#IND"}) {
    check("a.obj", "v 0 0 0\nv " + number + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\n");
    if (number.find('#') == std::string::npos)  // starts a comment in OFF
      check("a.off", "OFF\n4 1 0\n0 0 0\n0 " + number + " 0\n1 0 0\n0 1 0\n3 0 2 3\n");
    check("a.ply",
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n0 0 " +
              number + "\n1 0 0\n0 1 0\n3 0 2 3\n");
  }
}

TEST_CASE("PLY: binary in both orders, other elements and properties, every type") {
  for (bool big : {false, true}) {
    std::string head = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                       " 1.0\ncomment made by a test\nobj_info x\n"
                       "element camera 2\nproperty short a\nproperty list ushort double b\nelement vertex 3\nproperty "
                       "double x\nproperty uchar flag\nproperty float y\n"
                       "property float nx\nproperty float ny\nproperty float nz\nproperty int z\nelement face "
                       "2\nproperty uchar flags\nproperty list int uint vertex_indices\n"
                       "property list uchar float texcoord\nend_header\n";
    Bytes bytes = bytesOf(head);
    const auto put = [&](auto value) {
      std::uint8_t raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      if (big) std::reverse(raw, raw + sizeof value);
      bytes.insert(bytes.end(), raw, raw + sizeof value);
    };
    for (int i = 0; i < 2; ++i) {
      put(std::int16_t(7)), put(std::uint16_t(i));
      if (i) put(1.5);
    }
    for (int i = 0; i < 3; ++i)
      put(i * 0.5), put(std::uint8_t(1)), put(i == 1 ? 2.0f : 0.0f), put(0.0f), put(3.0f), put(0.0f),
          put(std::int32_t(-i));
    for (int f = 0; f < 2; ++f) {
      put(std::uint8_t(0)), put(std::int32_t(3));
      for (std::uint32_t v : {0u, 1u, 2u}) put(f ? 2 - v : v);
      put(std::uint8_t(1)), put(1.0f);
    }
    const Import import = twice("a.ply", bytes);
    REQUIRE(import.keyframes.vertexCount() == 3);
    CHECK(import.keyframes.keys[0].positions[1] == Vec3(0.5, 2, -1));
    CHECK(import.keyframes.faces == std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}});
    CHECK(import.keyframes.normals.at(2) == Vec3(0, 1, 0));
    bytes.pop_back();
    checkRefused("a.ply", bytes, ErrorCode::TruncatedFile, "\"face\" elements");
  }
}

TEST_CASE("OFF: comments, counts on the first line, normals, colours, ignored lines") {
  CHECK(twice("a.off", "OFF 3 1 0 # counts\n# a comment\n\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n")
            .keyframes.faceCount() == 1);
  const Import normals = twice("a.off", "NOFF\n3 1 0\n0 0 0 0 0 2\n1 0 0 0 0 2\n0 1 0 0 0 2\n3 0 1 2\n");
  CHECK(normals.keyframes.normals.at(0) == Vec3::UnitZ());
  const Import line = twice("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n");
  CHECK(line.keyframes.faceCount() == 1);
  REQUIRE(line.warnings.size() == 1);
  CHECK(line.warnings[0].message.find("fewer than three corners") != std::string::npos);
  CHECK(twice("a.off", "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n").keyframes.vertexCount() ==
        3);
}

TEST_CASE("polygons are split as in the first key, for any shape in the others") {
  // A dart with its inner corner at vertex 4 in the first key and at vertex 1 in the second. Each key alone would be
  // cut differently.
  const std::string face = "f 1 2 3 4\n";
  const std::string first = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\n" + face,
                    second = "v 0 0 0\nv 1 1 0\nv 4 0 0\nv 0 -4 0\n" + face;
  const auto faces = [&](const std::string& a, const std::string& b) {
    return imported(Files().add("a.obj", bytesOf(a)).add("b.obj", bytesOf(b))).keyframes.faces;
  };
  CHECK(faces(first, second) == faces(first, first));
  CHECK(faces(second, first) == faces(second, second));
  CHECK(faces(first, second) != faces(second, first));
}

TEST_CASE("concave polygons are covered without overlap") {
  // A comb with 16 corners. Its area is 7 (the back, 7 x 1) plus 4 (four teeth of 1 each).
  std::string text;
  int n = 0;
  const auto corner = [&](double x, double y) {
    text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n", ++n;
  };
  corner(0, -1), corner(7, -1);
  for (int tooth = 3; tooth >= 0; --tooth)
    corner(2 * tooth + 1, 1), corner(2 * tooth, 1), tooth ? (corner(2 * tooth, 0), corner(2 * tooth - 1, 0)) : void();
  text += "f";
  for (int i = 1; i <= n; ++i) text += " " + std::to_string(i);
  const Import import = twice("a.obj", text + "\n");
  REQUIRE(import.keyframes.faceCount() == n - 2);
  double sum = 0;
  for (const Triangle& f : import.keyframes.faces) {
    const Positions& p = import.keyframes.keys[0].positions;
    CHECK((p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).z() > 0);
    sum += area(p, f);
  }
  CHECK(sum == doctest::Approx(7 + 4));
}

TEST_CASE("a hole joined to its polygon by a bridge stays open") {
  // A square with holes of `sides` corners each, which bridges join to corners of the square, from any first corner.
  const auto check = [](int holes, int sides, int start, bool ownVertices) {
    CAPTURE(holes);
    CAPTURE(sides);
    CAPTURE(start);
    std::vector<Vec3> points{{0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}};
    std::vector<int> outline;
    double hole = 0;
    for (int h = 0; h < 4; ++h) {
      outline.push_back(h);
      if (h >= holes) continue;
      const Vec3 middle = Vec3(6, 6, 0) + 0.5 * (points[h] - Vec3(6, 6, 0));
      const int first = static_cast<int>(points.size());
      const double outwards = std::atan2(points[h].y() - 6, points[h].x() - 6);
      for (int i = 0; i <= sides; ++i) {
        const double angle = outwards - 2 * std::numbers::pi * i / sides;
        if (i < sides || ownVertices) points.push_back(middle + Vec3(std::cos(angle), std::sin(angle), 0));
        outline.push_back(ownVertices || i < sides ? first + i : first);
      }
      if (ownVertices) points.back() = points[first];
      if (ownVertices) points.push_back(points[h]);
      outline.push_back(ownVertices ? static_cast<int>(points.size()) - 1 : h);
      hole += 0.5 * sides * std::sin(2 * std::numbers::pi / sides);
    }
    std::rotate(outline.begin(), outline.begin() + start % outline.size(), outline.end());
    const auto pose = [&](double bend) {
      std::string text;
      for (const Vec3& p : points)
        text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                std::to_string(bend * p.x() * p.x()) + "\n";
      text += "f";
      for (int v : outline) text += " " + std::to_string(v + 1);
      return bytesOf(text + "\n");
    };
    ImportOptions options;
    const Import import = imported(Files().add("a.obj", pose(0)).add("b.obj", pose(0.1)));
    const Positions& p = import.keyframes.keys[0].positions;
    double covered = 0;
    for (const Triangle& f : import.keyframes.faces) {
      CHECK((p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).z() > -1e-5);
      covered += area(p, f);
    }
    CHECK(covered == doctest::Approx(144 - hole).epsilon(1e-5));
    // Added poses get the same triangles.
    options.like = import.keyframes.faces;
    CHECK(imported(Files().add("a.obj", pose(0.2)).add("b.obj", pose(0.1)), options).keyframes.faces == options.like);
  };
  for (int holes = 1; holes <= 4; ++holes)
    for (int sides : {3, 4, 5, 6})
      for (int start = 0; start < 12; ++start) check(holes, sides, start, false), check(holes, sides, start, true);
  check(1, 64, 0, false);
  check(4, 100, 3, true);
}

TEST_CASE("up axis and unit have no effect on glTF, with a warning") {
  ImportOptions options;
  options.zUp = true;
  const Import import = imported(Files().add("a.glb", boxFile().glb()).add("b.glb", boxFile(1).glb()), options);
  CHECK(import.keyframes.keys[0].positions == boxPose());
  REQUIRE(import.warnings.size() == 1);
  CHECK(import.warnings[0].code == "orientation-ignored");
}

TEST_CASE("keys with other polygons do not fit together") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 1\n";
  const auto error = [&](const std::string& second) {
    const auto import =
        Files().add("a.obj", bytesOf(vertices + "f 1 2 5 4\nf 2 3 6 5\n")).add("b.obj", bytesOf(second)).import();
    REQUIRE(!import.ok());
    return import.error();
  };
  CHECK(error(vertices + "f 1 2 5 4\nf 2 3 6\n").code == ErrorCode::FaceCountMismatch);
  CHECK(error(vertices + "f 1 2 5 4\nf 5 6 3 2\n").code == ErrorCode::FaceMismatch);
  CHECK(error("v 5 0 0\n" + vertices + "f 1 2 5 4\nf 3 6 7 1\n").code == ErrorCode::VertexCountMismatch);
}

TEST_CASE("up axis and unit") {
  ImportOptions options;
  options.zUp = true;
  options.unit = 0.01;
  const Import import = imported(Files()
                                     .add("a.obj", bytesOf("v 1 2 3\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"))
                                     .add("b.off", bytesOf("OFF\n3 1 0\n1 2 3\n1 0 0\n0 1 0\n3 0 1 2\n")),
                                 options);
  CHECK((import.keyframes.keys[0].positions[0] - Vec3(0.01, 0.03, -0.02)).norm() < 1e-15);
  CHECK((import.keyframes.keys[1].positions[0] - Vec3(0.01, 0.03, -0.02)).norm() < 1e-15);
  CHECK((import.keyframes.normals[0] - Vec3::UnitY()).norm() < 1e-15);
  const Files glb = Files().add("a.glb", boxFile().glb()).add("b.glb", boxFile(1).glb());
  CHECK(distance(imported(glb, options).keyframes.keys[0].positions, boxPose()) < 1e-6);  // glTF defines axes and unit
  options.unit = 0;
  CHECK(glb.import(options).error().code == ErrorCode::InvalidOption);
}

TEST_CASE("broken OBJ files") {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  checkRefused("bad.obj", v + "f 1 2 4\n", ErrorCode::IndexOutOfRange, "vertex 3 (counted from 0)");
  checkRefused("bad.obj", v + "f 1 2 -4\n", ErrorCode::IndexOutOfRange, "line 4");
  checkRefused("bad.obj", v + "f 1 2 99999999999\n", ErrorCode::IndexOutOfRange, "line 4");
  checkRefused("bad.obj", v + "f 1 2 -9223372036854775808\n", ErrorCode::IndexOutOfRange,
               "index -9,223,372,036,854,775,808,");
  checkRefused("bad.obj", v + "f 1 2 99999999999999999999\n", ErrorCode::MalformedFile, "line 4");
  checkRefused("bad.obj", v + "f 0 1 2\n", ErrorCode::MalformedFile, "line 4");
  checkRefused("bad.obj", v + "f a b c\n", ErrorCode::MalformedFile, "line 4");
  checkRefused("bad.obj", v + "f 1/2/3/4 2 3\n", ErrorCode::MalformedFile, "v/vt/vn");
  checkRefused("bad.obj", "v 0 0\n", ErrorCode::MalformedFile, "three numbers");
  checkRefused("bad.obj", "v 0 0 x\n", ErrorCode::MalformedFile, "line 1");
  checkRefused("bad.obj", v, ErrorCode::NoTriangles, "no faces");
  checkRefused("bad.obj", v + "f 1 2\nl 1 2 3\n", ErrorCode::NoTriangles, "no faces");
  checkRefused("bad.obj", "hello", ErrorCode::NoTriangles, "no faces");
  checkRefused("bad.obj", "", ErrorCode::EmptyFile, "empty");
  checkRefused("bad.obj", "<!DOCTYPE html>", ErrorCode::NotRecognised, "web page");
  const auto notFinite = Files()
                             .add("a.obj", bytesOf(squareObj))
                             .add("b.obj", bytesOf("v 0 0 0\nv 1 nan 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"))
                             .import();
  REQUIRE(!notFinite.ok());
  CHECK(notFinite.error().code == ErrorCode::NotFinite);
  CHECK(notFinite.error().vertex == 1);
}

TEST_CASE("broken PLY files") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = squarePly;
    return text.replace(text.find(from), from.size(), to);
  };
  checkRefused("bad.ply", "ply\n", ErrorCode::TruncatedFile, "header");
  checkRefused("bad.ply", with("end_header\n", ""), ErrorCode::MalformedFile, "header has");
  checkRefused("bad.ply", with("format ascii 1.0\n", ""), ErrorCode::MalformedFile, "not state a format");
  checkRefused("bad.ply", with("ascii", "morse"), ErrorCode::MalformedFile, "\"morse\"");
  checkRefused("bad.ply", with("float x", "quad x"), ErrorCode::MalformedFile, "\"quad\"");
  checkRefused("bad.ply", with("list uchar", "list float"), ErrorCode::MalformedFile, "length of a list");
  checkRefused("bad.ply", with("property float x", "property float q"), ErrorCode::MalformedFile, "x, y and z");
  checkRefused("bad.ply", with("vertex 4", "vertex -4"), ErrorCode::MalformedFile, "whole number");
  checkRefused("bad.ply", with("vertex 4", "vertex many"), ErrorCode::MalformedFile, "whole number");
  checkRefused("bad.ply", with("vertex 4", "vertex 4000000000"), ErrorCode::TooLarge, "4,000,000,000");
  checkRefused("bad.ply", with("vertex 4", "vertex 12000000"), ErrorCode::TruncatedFile, "12,000,000");
  checkRefused("bad.ply", with("4 0 1 2 3", "4 0 1 2"), ErrorCode::TruncatedFile, "\"face\"");
  checkRefused("bad.ply", with("4 0 1 2 3", "-4 0 1 2 3"), ErrorCode::TruncatedFile, "\"face\"");
  checkRefused("bad.ply", with("4 0 1 2 3", "4000000 0 1 2 3"), ErrorCode::TruncatedFile, "\"face\"");
  checkRefused("bad.ply", with("4 0 1 2 3", "4 0 1 2 4"), ErrorCode::IndexOutOfRange, "vertex 4");
  checkRefused("bad.ply", with("4 0 1 2 3", "4 0 1 2 -1"), ErrorCode::IndexOutOfRange, "face 0");
  checkRefused("bad.ply", with("1 1 0", "1 one 0"), ErrorCode::TruncatedFile, "\"vertex\"");
  checkRefused("bad.ply", with("face 1", "face 0"), ErrorCode::NoTriangles, "no faces");
  checkRefused("bad.ply", with("element face 1\nproperty list uchar int vertex_indices\n", ""), ErrorCode::NoTriangles,
               "no faces");
  checkRefused("bad.ply", "element", ErrorCode::NotRecognised, "extension .ply");
  // Only the vertices of the second element lack normals.
  checkRefused("bad.ply",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
               "z\nproperty float nx\n"
               "property float ny\nproperty float nz\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
               "float z\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0\n3 0 1 2\n",
               ErrorCode::MalformedFile, "twice");
  // Elements without properties take no bytes, whatever their count.
  CHECK(twice("a.ply", with("element face 1", "element nothing 60000000\nelement face 1")).keyframes.faceCount() == 2);
  std::string faces;
  for (int i = 0; i < 10'000; ++i) faces += "element face 60000000\n";
  CHECK(twice("a.ply", with("element face 1", faces + "element face 1")).keyframes.faceCount() == 2);
}

TEST_CASE("broken OFF files") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = squareOff;
    return text.replace(text.find(from), from.size(), to);
  };
  checkRefused("bad.off", "OFF", ErrorCode::MalformedFile, "numbers of vertices");
  checkRefused("bad.off", "# a comment\n3 1 0\n", ErrorCode::MalformedFile, "the header is missing");
  checkRefused("bad.off", "# a comment\n", ErrorCode::MalformedFile, "the header is missing");
  checkRefused("bad.off", "OFF\n4", ErrorCode::MalformedFile, "numbers of vertices");
  checkRefused("bad.off", "OFF BINARY\n", ErrorCode::Unsupported, "binary");
  checkRefused("bad.off", "4OFF\n1 1 0\n", ErrorCode::Unsupported, "three dimensions");
  checkRefused("bad.off", with("4 1 0", "-4 1 0"), ErrorCode::MalformedFile, "numbers of vertices");
  checkRefused("bad.off", with("4 1 0", "nan 1 0"), ErrorCode::MalformedFile, "numbers of vertices");
  checkRefused("bad.off", with("4 1 0", "4e18 1 0"), ErrorCode::TooLarge, "more than is supported");
  checkRefused("bad.off", with("4 1 0", "9 1 0"), ErrorCode::TruncatedFile, "9 vertices");
  checkRefused("bad.off", with("4 1 0", "4 3 0"), ErrorCode::TruncatedFile, "3 faces");
  checkRefused("bad.off", with("1 1 0\n", "1 1\n"), ErrorCode::MalformedFile, "line 5");
  checkRefused("bad.off", with("4 0 1 2 3", "4 0 1 2"), ErrorCode::MalformedFile, "fewer corners");
  checkRefused("bad.off", with("4 0 1 2 3", "4 0 1 2 4"), ErrorCode::IndexOutOfRange, "vertex 4");
  checkRefused("bad.off", with("4 0 1 2 3", "4 0 1 2 -1"), ErrorCode::IndexOutOfRange, "vertex -1");
  checkRefused("bad.off", with("4 0 1 2 3", "4000000000 0 1 2 3"), ErrorCode::MalformedFile, "number of corners");
  checkRefused("bad.off", with("4 1 0", "4 0 0"), ErrorCode::NoTriangles, "no faces");
  checkRefused("bad.off", "not", ErrorCode::NotRecognised, "extension .off");
}

TEST_CASE("every truncated file is refused") {
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.ply", squarePly}, {"a.off", squareOff}})
    for (std::size_t size = 0; size + 2 < text.size(); ++size) {
      // A text file cut inside its last number may still be complete. All earlier numbers must be present.
      CAPTURE(size);
      CHECK(!Files().add(name, bytesOf(text)).add("b" + name, bytesOf(text.substr(0, size))).import().ok());
    }
}

}  // namespace shapespline::test::polygon_readers_test
