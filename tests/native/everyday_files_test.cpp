// Everyday files: read if supported, otherwise rejected with advice.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "files.h"
#include "io/numbered_files.h"

namespace shapespline::test::everyday_files_test {

namespace {

Import imported(const Files& files, const ImportOptions& options = {}) {
  auto result = files.import(options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  return std::move(*result);
}

bool says(const Import& import, const std::string& code, const std::string& text = "") {
  return std::any_of(import.warnings.begin(), import.warnings.end(), [&](const Warning& warning) {
    return warning.code == code && warning.message.find(text) != std::string::npos;
  });
}

std::string squareObj(double bend = 0) { return "v 0 0 0\nv 1 0 0\nv 1 1 " + std::to_string(bend) + "\nv 0 1 0\n"; }
const std::string faceLine = "f 1 2 3 4\n";

Files twoSquares() {
  return Files().add("a.obj", bytesOf(squareObj() + faceLine)).add("b.obj", bytesOf(squareObj(1) + faceLine));
}

std::vector<Triangle> facesOf(const std::string& name, const Bytes& bytes) {
  return imported(Files().add(name, bytes).add("second-" + name, bytes)).keyframes.faces;
}

// Encodes ASCII text as UTF-16.
Bytes utf16(const std::string& text, bool bigEndian, bool marked) {
  Bytes out;
  const auto add = [&](int high, int low) {
    out.push_back(static_cast<std::uint8_t>(bigEndian ? high : low));
    out.push_back(static_cast<std::uint8_t>(bigEndian ? low : high));
  };
  if (marked) add(0xfe, 0xff);
  for (char c : text) add(0, c);
  return out;
}

void checkRefused(const std::string& name, const Bytes& bytes, const std::string& text) {
  CAPTURE(name);
  const auto alone = Files().add(name, bytes).import();
  REQUIRE(!alone.ok());
  CAPTURE(alone.error().message);
  CHECK(alone.error().message.find(text) != std::string::npos);
  CHECK(alone.error().message.starts_with(name));
}

template <class T>
void append(Bytes& bytes, T value, bool bigEndian) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes.push_back(static_cast<std::uint8_t>(value >> 8 * (bigEndian ? sizeof value - 1 - i : i)));
}

const std::string plyVertices =
    "element vertex 6\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement tristrips 2\n";
// The first row has two strips, one of them restarted, with a repeated corner for a turn. The second row has one strip.
const std::vector<std::vector<int>> stripText{{0, 1, 2, 3, -1, 2, 3, 4, 4, 5}, {5, 4, 3}};
const std::vector<Triangle> stripFaces{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {5, 4, 3}};
const std::vector<std::vector<int>> stripPoints{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 1}};

Bytes binaryStrips(const std::string& type, int width, bool bigEndian) {
  Bytes bytes = bytesOf(std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") + "_endian 1.0\n" +
                        plyVertices + "property list uchar " + type + " vertex_indices\nend_header\n");
  for (const auto& point : stripPoints)
    for (int c : point) bytes.push_back(static_cast<std::uint8_t>(c));
  for (const auto& strip : stripText) {
    bytes.push_back(static_cast<std::uint8_t>(strip.size()));
    for (int v : strip) {
      if (width == 1) append(bytes, static_cast<std::uint8_t>(v), bigEndian);
      else if (width == 2) append(bytes, static_cast<std::uint16_t>(v), bigEndian);
      else append(bytes, static_cast<std::uint32_t>(v), bigEndian);
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("OBJ: a line continues after a backslash, with any spaces and line ends") {
  for (const std::string end : {"\\\n", "\\ \n", "\\\t\n", "\\\r\n", "\\ \t \r\n", "\\\r", "\\\r\r\n"}) {
    CAPTURE(end);
    CHECK(facesOf("a.obj", bytesOf(squareObj() + "f 1 2 " + end + "3" + end + " 4\n")) ==
          std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    CHECK(facesOf("a.obj", bytesOf("v " + end + "0 0 0\nv 1 0" + end + " 0\nv 1 1 0\nv 0 1 0\n" + faceLine)).size() ==
          2);
  }
  for (const std::string end : {"\\", "\\\n", "\\ \r\n", "\\\n\n"})
    CHECK(facesOf("a.obj", bytesOf(squareObj() + "f 1 2 3\nf 1 3 4 " + end)) ==
          std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  // A backslash at the end of a comment does not continue the line.
  CHECK(facesOf("a.obj", bytesOf("# from C:\\shapes\\\n" + squareObj() + faceLine)).size() == 2);
}

TEST_CASE("OBJ: a line names several material libraries, whose names may contain spaces") {
  const std::string faces = "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n";
  const auto colours = [&](const std::string& named, const std::string& first, const std::string& second) {
    Files files;
    for (const char* name : {"a.obj", "b.obj"})
      files.add(name, bytesOf("mtllib " + named + "\n" + squareObj() + faces));
    files.add(first, bytesOf("newmtl red\nKd 1 0 0\n")).add(second, bytesOf("newmtl blue\nKd 0 0 1\n"));
    const Import import = imported(files);
    CAPTURE(named);
    CHECK(!says(import, "missing-materials"));
    REQUIRE(import.scene.materials.size() == 2);
    REQUIRE(import.scene.groups.size() == 2);
    CHECK(import.scene.materials[import.scene.groups[0].material].baseColor[0] == 1);
    CHECK(import.scene.materials[import.scene.groups[1].material].baseColor[2] == 1);
  };
  colours("a.mtl b.mtl", "a.mtl", "b.mtl");
  colours("a.mtl\tb.MTL  ", "a.mtl", "b.MTL");
  colours("my paint.mtl other paint.mtl", "my paint.mtl", "other paint.mtl");
  colours("paint library", "paint", "library");
  colours("a.mtl \\ \n b.mtl", "a.mtl", "b.mtl");
  colours("./a.mtl ./b.mtl", "a.mtl", "b.mtl");
  colours("mats/a.mtl mats/b.mtl", "mats/a.mtl", "mats/b.mtl");
  colours(".\\a.mtl .\\b.mtl", "a.mtl", "b.mtl");
  colours("my mats/a.mtl my mats/b.mtl", "my mats/a.mtl", "my mats/b.mtl");

  Files missing = Files().add("a.obj", bytesOf("mtllib a.mtl not there.mtl\n" + squareObj() + faceLine));
  missing.add("b.obj", bytesOf(squareObj(1) + faceLine)).add("a.mtl", bytesOf("newmtl red\n"));
  CHECK(says(imported(missing), "missing-materials", "\"not there.mtl\""));
}

// A file, and itself as the second key, with its materials.
Import withMaterials(const std::string& obj, const std::string& mtl, const std::string& image = "skin.png") {
  return imported(Files()
                      .add("a.obj", bytesOf(obj))
                      .add("b.obj", bytesOf(obj))
                      .add("a.mtl", bytesOf(mtl))
                      .add(image, bytesOf("\x89PNG\r\n\x1a\n")));
}

TEST_CASE("MTL: d takes precedence over Tr, and Tr 1 alone is opaque with a warning") {
  const std::string obj = "mtllib a.mtl\nusemtl skin\n" + squareObj() + faceLine;
  const auto alpha = [&](const std::string& statements, bool warned = false) {
    CAPTURE(statements);
    const Import import = withMaterials(obj, "newmtl other\nd 0.25\nnewmtl skin\n" + statements + "newmtl last\n");
    CHECK(says(import, "unclear-opacity", "a.mtl: Tr 1 without d") == warned);
    const Material& skin = import.scene.materials.at(import.scene.groups.at(0).material);
    CHECK((skin.alphaMode == Material::Alpha::Blend) == (skin.baseColor[3] < 1));
    return skin.baseColor[3];
  };
  for (const char* opaque : {"d 1\nTr 1\n", "Tr 1\nd 1\n", "d 1\nTr 0\n", "d 1.0\nTr 0.3\n", "Tr 0\n", "", "d nan\n"})
    CHECK(alpha(opaque) == 1);
  for (const char* unclear : {"Tr 1\n", "Tr 1.000000\n", "TR 1\n"}) CHECK(alpha(unclear, true) == 1);
  CHECK(alpha("Tr 0.3\n") == 0.7f);
  CHECK(alpha("Tr 0\nd 0.4\n") == 0.4f);
  CHECK(alpha("d 0.4\nTr 1\n") == 0.4f);
  CHECK(alpha("d 0\n") == 0);
  CHECK(alpha("d -halo 0.6\n") == 0.6f);
}

TEST_CASE("OBJ: a library is read wherever the file names it") {
  const std::string vertices = squareObj(), face = "usemtl red\n" + faceLine;
  for (const std::string& obj :
       {"usemtl red\nmtllib ./a.mtl\n" + vertices + faceLine, vertices + face + "mtllib a.mtl\n",
        "usemtl none\n" + vertices + face + "mtllib a.mtl", "MTLLIB a.mtl\n" + vertices + "USEMTL red\n" + faceLine}) {
    CAPTURE(obj);
    const Import import = withMaterials(obj, "newmtl blue\nnewmtl red\nKd 1 0 0\n");
    REQUIRE(import.scene.groups.size() == 1);
    CHECK(import.scene.groups[0].material == 1);
    CHECK(import.scene.groups[0].name == "");
  }
}

TEST_CASE("OBJ and MTL: keywords in any case; an image replaces black") {
  const std::string obj =
      "MtlLib a.mtl\nUSEMTL skin\nV 0 0 0\nV 1 0 0\nV 1 1 0\nVT 0 0\nVN 0 0 1\nF 1/1/1 2/1/1 3/1/1\nL 1 2\n";
  const auto skin = [&](const std::string& statements) {
    const Import import = withMaterials(obj, "NEWMTL skin\n" + statements);
    CHECK(import.keyframes.normals.size() == 3);
    CHECK(says(import, "skipped-primitives"));
    return import.scene.materials.at(import.scene.groups.at(0).material);
  };
  const Material shown = skin("kd 1 0 0\nMAP_KD -CLAMP ON skin.png\nD 0.5\n");
  CHECK(shown.baseColor == std::array<float, 4>{1, 0, 0, 0.5f});
  CHECK(shown.baseColorImage == 0);
  CHECK(shown.wrapS == Material::Wrap::Clamp);
  const std::array<float, 4> white{1, 1, 1, 1}, black{0, 0, 0, 1};
  CHECK(skin("Kd 0 0 0\nmap_Kd skin.png\n").baseColor == white);
  CHECK(skin("map_Kd skin.png\nKd 0.00 0.00 0.00\n").baseColor == white);
  CHECK(skin("Kd 0 0 0\n").baseColor == black);
  CHECK(skin("map_Kd skin.png\nKd 0 0 1\n").baseColor[2] == 1);
}

TEST_CASE("MTL: paths of another computer lead to the file beside it") {
  const std::string obj = squareObj() + faceLine;
  for (const std::string path : {"C:\\Users\\me\\my tex\\skin.png", "D:/tex/skin.png", "/home/me/skin.png",
                                 "\\\\server\\tex\\skin.png", "../../skin.png", "file:///C:/tex/skin.png"}) {
    CAPTURE(path);
    const Import import = withMaterials("mtllib C:\\my mats\\a.mtl\n" + obj, "newmtl a\nmap_Kd " + path + "\n");
    CHECK(import.scene.materials.at(0).baseColorImage == 0);
    CHECK(!says(import, "missing-texture"));
  }
  const Import missing = withMaterials("mtllib a.mtl\n" + obj, "newmtl a\nmap_Kd C:\\tex\\other.png\n");
  CHECK(says(missing, "missing-texture", "needs the file \"other.png\""));
}

TEST_CASE("PLY: strips of triangles, restarted at -1, every other triangle turned") {
  const auto check = [&](const Bytes& bytes) { CHECK(facesOf("a.ply", bytes) == stripFaces); };
  std::string text = "ply\nformat ascii 1.0\n" + plyVertices + "property list int int vertex_index\nend_header\n";
  const auto addRow = [&](const std::vector<int>& row) {
    for (int value : row) text += std::to_string(value) + " ";
    text += "\n";
  };
  for (const auto& point : stripPoints) addRow(point);
  for (const auto& strip : stripText) text += std::to_string(strip.size()) + " ", addRow(strip);
  check(bytesOf(text));
  for (bool bigEndian : {false, true})
    for (const auto& [type, width] :
         {std::pair{"char", 1}, {"uchar", 1}, {"short", 2}, {"ushort", 2}, {"int", 4}, {"uint", 4}}) {
      CAPTURE(type);
      check(binaryStrips(type, width, bigEndian));
    }
  Bytes bad = binaryStrips("int", 4, false);
  bad[bad.size() - 4] = 99;
  checkRefused("a.ply", bad, "refers to vertex 99");
  bad.resize(bad.size() - 3);
  checkRefused("a.ply", bad, "cut off");
}

TEST_CASE("text in UTF-16 is refused with advice, with and without a byte order mark") {
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.obj", squareObj() + faceLine},
                                   {"a.ply", ply},
                                   {"a.off", "OFF\n4 1 0\n"},
                                   {"a.gltf", "{\"asset\": {\"version\": \"2.0\"}}"}})
    for (bool bigEndian : {false, true})
      for (bool marked : {false, true})
        checkRefused(name, utf16(text, bigEndian, marked), "UTF-16, which is not supported. Save it as UTF-8.");
  Files files = Files().add("a.obj", bytesOf("mtllib a.mtl\n" + squareObj() + faceLine));
  files.add("b.obj", bytesOf(squareObj(1) + faceLine)).add("a.mtl", utf16("newmtl red\nKd 1 0 0\n", false, true));
  CHECK(says(imported(files), "missing-materials", "UTF-16"));
}

TEST_CASE("decimal commas are refused with the line and advice") {
  const std::string says =
      "a number has a decimal comma or is followed by a comma. Export the file with decimal points";
  checkRefused("a.obj", bytesOf("v 0,5 1,2 3\n"), "line 1: " + says);
  checkRefused("a.obj", bytesOf("v 0 0 0\nv 1 2 3,5e-2\n"), "line 2: " + says);
  checkRefused("a.obj", bytesOf("v 0 0 0 0,5 1 1\n"), says);
  checkRefused("a.obj", bytesOf("v 0 0 0\nvt 0,25 1\n"), "line 2: " + says);
  checkRefused("a.obj", bytesOf("v 0 0 0\nvn 0 0,7 1\n"), "line 2: " + says);
  const std::string header =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  checkRefused("a.ply", bytesOf("ply\nformat ascii 1.0\n" + header + "0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), says);
  checkRefused("a.ply", bytesOf("ply\nformat ascii 1.0\n" + header + "0 0 0\n1 0 -1,5\n0 1 0\n3 0 1 2\n"), says);
  checkRefused("a.off", bytesOf("OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n"), "line 4: " + says);
  for (const char* vertex :
       {"v 1, 2, 3\n", "v 1, 0 2, 5 3, 0\n", "v 1 , 0 2 , 5 3 , 0\n", "v 1 2,\t5 0\n", "v 1,234.5 0 0\n"})
    checkRefused("a.obj", bytesOf(vertex), "line 1: " + says);
  Files files = Files().add("a.obj", bytesOf("mtllib a.mtl\n" + squareObj() + faceLine));
  files.add("b.obj", bytesOf(squareObj(1) + faceLine)).add("a.mtl", bytesOf("newmtl red\nKd 0,8 0 0\n"));
  CHECK(everyday_files_test::says(imported(files), "missing-materials", "decimal comma"));
}

TEST_CASE("files of other programs are refused with their type and advice") {
  for (const auto& [name, text, says] : std::vector<std::array<std::string, 3>>{
           {"shot.abc", "Ogawa\xff", "Alembic file, which is not supported. Export its frames"},
           {"shot.ABC", "\x89HDF", "Alembic"},
           {"a.usd", "PXR-USDC", "USD file, which is not supported. Export it as glTF"},
           {"a.usda", "#usda 1.0\n", "USD file"},
           {"a.usdc", "PXR-USDC", "USD file"},
           {"a.usdz", "PK\x03\x04", "USD file"},
           {"a.obj", "#usda 1.0\n", "USD file"},
           {"a.fbx", "; FBX 7.4.0 project file", "FBX"},
           {"a.blend", "BLENDER-v405", "Blender file"},
           {"a.blend", "\x28\xb5\x2f\xfd", "Blender file"},
           {"a.stl", std::string(84, '\x01'), "which triangles share a vertex"},
           {"a.dae", "<?xml version=\"1.0\"?>", "COLLADA"},
           {"a.3ds", "MM", "3DS"},
           {"a.max", "\xd0\xcf", "3ds Max"},
           {"a.ma", "//Maya ASCII 2024", "Maya"},
           {"a.mb", "FOR8", "Maya"},
           {"a.c4d", "QC4D", "Cinema 4D"},
           {"a.step", "ISO-10303-21;", "CAD"},
           {"a.bvh", "HIERARCHY", "without a mesh"},
           {"scan.e57", "ASTM-E57", "points without faces"},
           {"a.zip", "PK\x03\x04", "ZIP archive. Unpack it"}})
    checkRefused(name, bytesOf(text), says);
}

TEST_CASE("a file of another kind among poses is omitted with a warning, unless a key would be missing") {
  const Import import = imported(twoSquares().add("scene.blend", bytesOf("BLENDER-v405")).add("n.dat", bytesOf("x")));
  CHECK(import.keyframes.keyCount() == 2);
  CHECK(says(import, "left-out-file", "scene.blend is a Blender file"));
  CHECK(says(import, "left-out-file", "n.dat is not a supported 3D file"));
  const auto lone = Files().add("a.obj", bytesOf(squareObj() + faceLine)).add("b.fbx", bytesOf("Kaydara FBX")).import();
  REQUIRE(!lone.ok());
  CHECK(lone.error().message.starts_with("b.fbx is an FBX file"));
  // A broken pose must not be treated as another kind of file.
  CHECK(!twoSquares().add("c.obj", bytesOf("<html>")).import().ok());
  CHECK(!twoSquares().add("c.obj", {}).import().ok());
  Files many = twoSquares();
  for (int i = 0; i < 40; ++i) many.add("n" + std::to_string(i) + ".dat", bytesOf("x"));
  CHECK(says(imported(many), "left-out-file", "30 more such files"));
}

TEST_CASE("a mesh is recognised by its content, whatever its name") {
  const std::string ply =
      "ply \r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
      "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 "
      "2\r\n";
  const std::string obj = "# OBJ\n\nmtllib a.mtl\no a\n" + squareObj() + "s off\nf 1 2 \\\n 3 4\n";
  const std::string off = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string& text : {ply, obj, off})
    for (const char* name : {"a", "a.txt", "a.download", "a.glb", "a.obj.txt", "a.PLY.txt"}) {
      CAPTURE(name);
      const Import import = imported(Files().add(name, bytesOf(text)).add("b", bytesOf(text)));
      CHECK(import.keyframes.keyCount() == 2);
      const bool isOther = std::string(name).size() > 1 && !std::string(name).ends_with("download");
      CHECK(says(import, "other-extension", "Rename it") == isOther);
    }
  const Import notes = imported(twoSquares()
                                    .add("notes.txt", bytesOf("OFF we go\nv 1 2 3\n"))
                                    .add("a.txt", bytesOf("{\"a\": 1}"))
                                    .add("v.txt", bytesOf("v 0 0 0\nI made this\n")));
  CHECK(notes.keyframes.keyCount() == 2);
  CHECK(!says(notes, "left-out-file"));
  checkRefused("broken.glb.txt", bytesOf("glb"), "is not a supported 3D file");
  const std::string address = "a/" + std::string(5'000, 'x') + ".glb";
  const auto refused = Files().add(address, bytesOf("x")).import();
  REQUIRE(!refused.ok());
  CHECK(refused.error().message.size() < 250);
}

TEST_CASE("a pose much larger or smaller than the others is named in a warning") {
  const auto square = [](double size) {
    std::string text;
    for (const char* corner : {"0 0", "1 0", "1 1", "0 1"}) {
      const double x = corner[0] - '0', y = corner[2] - '0';
      text += "v " + std::to_string(size * x) + " " + std::to_string(size * y) + " 0\n";
    }
    return bytesOf(text + faceLine);
  };
  const auto read = [&](const std::vector<double>& sizes) {
    Files files;
    for (std::size_t k = 0; k < sizes.size(); ++k)
      files.add(std::string(1, static_cast<char>('a' + k)) + ".obj", square(sizes[k]));
    return imported(files);
  };
  CHECK(says(read({1, 100}), "sizes-differ", "(b.obj) is 100 times larger than a.obj."));
  CHECK(says(read({100, 1, 1}), "sizes-differ", "(a.obj) is 100 times larger than b.obj."));
  CHECK(says(read({1, 1, 0.001, 1}), "sizes-differ", "(c.obj) is 1,000 times smaller than a.obj."));
  CHECK(!says(read({1, 15}), "sizes-differ"));
}

TEST_CASE("numbers in names can be negative; all names together determine whether a hyphen is a sign") {
  std::ifstream file(SHAPESPLINE_SOURCE_DIR "/tests/numbered-names.json");
  for (const auto& one : nlohmann::json::parse(file)) {
    std::vector<NamedBytes> files;
    for (const auto& name : one.at("names")) files.push_back({name.get<std::string>(), {}});
    CAPTURE(files[0].name);
    std::vector<MeshFile> meshes;
    for (const NamedBytes& named : files)
      meshes.push_back({&named, named.name.ends_with("ply") ? FileKind::Ply : FileKind::Obj});
    const auto series = numberedFiles(meshes);
    CHECK(series.has_value() == !one.at("frames").is_null());
    for (std::size_t i = 0; series && i < files.size(); ++i) {
      const double frame = one.at("frames")[i], first = one.at("frames")[0];
      CHECK(series->seconds[i] == doctest::Approx((frame - first) / 24.0));
      CHECK(series->meshes[i].file->name == one.at("order")[i].get<std::string>());
    }
    CHECK(sequencesAmong(meshes).empty() == (one.value("sequences", 1) < 2));
  }
}

TEST_CASE("frames of formats without times are at the times given by their files") {
  ImportOptions options;
  options.everyFrame = true;
  options.frameTimes = {0, 0.5, 2};
  Files files;
  for (int i = 0; i < 3; ++i) files.add("s" + std::to_string(i) + ".obj", bytesOf(squareObj(i) + faceLine));
  const auto times = [&] {
    const auto import = files.import(options);
    REQUIRE(import.ok());
    std::vector<double> out;
    for (const Key& key : import->keyframes.keys) out.push_back(key.time);
    return out;
  };
  CHECK(times() == options.frameTimes);
  options.frameTimes = {0, 1};  // times for a different number of frames
  CHECK(times()[1] == doctest::Approx(1.0 / 24));
  options.frameTimes = {0, 1, 1};
  CHECK(times()[1] == doctest::Approx(1.0 / 24));
}

TEST_CASE("names that are not UTF-8 are read as Latin-1") {
  const std::string named =
      "o K\xe4"
      "fer\n";
  const Import import = imported(
      Files().add("a.obj", bytesOf(named + squareObj() + faceLine)).add("b.obj", bytesOf(squareObj(1) + faceLine)));
  REQUIRE(import.scene.objects.size() == 1);
  CHECK(import.scene.objects[0].name ==
        "K\xc3\xa4"
        "fer");
}

TEST_CASE("two numbered sequences that become keys of one motion are named in a warning") {
  Files files;
  for (const char* name : {"run_1.obj", "run_2.obj", "walk_1.obj", "walk_2.obj", "walk_3.obj"})
    files.add(name, bytesOf(squareObj(static_cast<double>(files.names.size())) + faceLine));
  const Import import = imported(files);
  CHECK(import.keyframes.keyCount() == 5);
  CHECK(says(import, "several-sequences", "\"run\" (2 files), \"walk\" (3 files)"));
  CHECK(!says(imported(twoSquares()), "several-sequences"));
}

TEST_CASE("faces that are all equal or share an edge are matched and ordered in linear time") {
  constexpr int count = 20'000;
  std::string equal = squareObj(), book = squareObj() + "v 2 0 0\nv 3 1 1\n", later = squareObj(1);
  for (int i = 0; i < count; ++i) {
    equal += "f 1 2 3\n";
    later += i % 2 ? "f 1 2 3\n" : "f 2 3 1\n";
    book += "f 1 2 " + std::to_string(3 + i % 4) + "\n";
  }
  for (const auto& [a, b] : {std::pair{equal, later}, {book, book}}) {
    const Import import = imported(Files().add("a.obj", bytesOf(a)).add("b.obj", bytesOf(b)));
    CHECK(import.keyframes.faceCount() == count);
  }
}

}  // namespace shapespline::test::everyday_files_test
