// Files from other sources, if available: checks counts, and that every malformed file is rejected or imported.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>

#include "../fuzz/one_input.h"
#include "core/sequence/sequence.h"
#include "gltf_maker.h"
#include "real_data.h"

namespace fs = std::filesystem;
namespace shapespline::test::real_files_test {

namespace {

Import imported(const Files& files, const ImportOptions& options = {}) {
  auto result = files.import(options);
  REQUIRE_MESSAGE(result.ok(), (result.ok() ? "" : result.error().message));
  shapespline::fuzz::checkImport(*result);
  return std::move(*result);
}

void checkCounts(const Import& import, int keys, int vertices, int faces) {
  CHECK(import.keyframes.keyCount() == keys);
  CHECK(import.keyframes.vertexCount() == vertices);
  CHECK(import.keyframes.faceCount() == faces);
}

}  // namespace

TEST_CASE("real poses and morph targets") {
  if (!hasData()) return;
  const Import poses = imported(realFiles({"cactus/cactus-1.glb", "cactus/cactus-2.glb", "cactus/cactus-3.glb"}));
  checkCounts(poses, 3, 5261, 10518);
  const Import morph = imported(realFiles({"cactus/cactus-morph.glb"}));
  checkCounts(morph, 3, 5261, 10518);
  CHECK(morph.keyframes.faces == poses.keyframes.faces);
  for (int j = 0; j < 3; ++j)
    CHECK(distance(morph.keyframes.keys[j].positions, poses.keyframes.keys[j].positions) < 1e-6);

  const Import horse = imported(realFiles({"morph/Horse.glb"}));
  checkCounts(horse, 16, 796, 984);
  CHECK(horse.keyframes.keys.back().time == doctest::Approx(1.5));
  CHECK(horse.scene.colors.size() == 4 * 796);

  checkCounts(imported(realFiles({"morph/AnimatedMorphSphere.gltf", "morph/AnimatedMorphSphere.bin"})), 8, 1876, 960);
  CHECK(realFiles({"morph/AnimatedMorphSphere.gltf"}).import().error().code == ErrorCode::MissingResource);

  const Import stress = imported(realFiles({"morph/MorphStressTest.gltf"}));
  checkCounts(stress, 8, 1528, 2412);
  CHECK(stress.animations.size() == 3);
  CHECK(stress.scene.groups.size() == 2);
}

TEST_CASE("real skins and their animations") {
  if (!hasData()) return;
  const Import man = imported(realFiles({"skin/CesiumMan.glb"}));
  checkCounts(man, 8, 3273, 4672);
  CHECK(man.keyframes.normals.size() == 3273);
  CHECK(man.scene.images.size() == 1);
  CHECK(man.scene.images[0].mimeType == "image/jpeg");
  CHECK(man.keyframes.keys.back().time == doctest::Approx(2));

  ImportOptions options;
  options.animation = std::string("Run");
  options.sampleTimes = {0, 0.25, 0.5};
  const Import fox = imported(realFiles({"skin/Fox.glb"}), options);
  checkCounts(fox, 3, 1728, 576);
  CHECK(fox.animation == 2);
  CHECK(fox.animations.size() == 3);
  CHECK(fox.animations[0].name == "Survey");

  const Import soldier = imported(realFiles({"skin/Soldier.glb"}), options);
  checkCounts(soldier, 3, 7434, 11376);
  CHECK(soldier.scene.groups.size() == 2);
  CHECK(soldier.scene.images.size() == 2);
}

TEST_CASE("real OBJ poses") {
  if (!hasData()) return;
  checkCounts(imported(realFiles(wolfPoses)), 6, 5075, 10018);
  checkCounts(imported(realFiles({"obj/lowpoly-cat/cat_000001.obj", "obj/lowpoly-cat/cat_000007.obj",
                                  "obj/lowpoly-cat/cat_000013.obj", "obj/lowpoly-cat/cat_000019.obj",
                                  "obj/lowpoly-cat/cat_000025.obj", "obj/lowpoly-cat/cat_000031.obj"})),
              6, 398, 794);
}

TEST_CASE("keys of two meshes are refused with both counts") {
  if (!hasData()) return;
  const auto mixed = realFiles({"cactus/cactus-1.glb", "obj/wolf/wolf-1.obj"}).import();
  REQUIRE(!mixed.ok());
  CHECK(mixed.error().code == ErrorCode::VertexCountMismatch);
  CHECK(mixed.error().message.find("5,075") != std::string::npos);
  CHECK(mixed.error().message.find("5,261") != std::string::npos);
}

TEST_CASE("malformed real files") {
  if (!hasData()) return;
  int files = 0, refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(dataFolder() / "malformed")) {
    const fs::path path = entry.path();
    const std::string extension = path.extension().string();
    if (!entry.is_regular_file() || (extension != ".gltf" && extension != ".glb")) continue;
    CAPTURE(path.string());
    ++files;
    Files alone = Files().add(path.filename().string(), contentOf(path));
    for (const auto& beside : fs::directory_iterator(path.parent_path()))
      if (beside.path().extension() == ".bin") alone.add(beside.path().filename().string(), contentOf(beside.path()));
    const auto start = std::chrono::steady_clock::now();
    const auto import = alone.import();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    CHECK(took.count() < 60);  // detects hangs, not slowness
    if (import.ok()) {
      shapespline::fuzz::checkImport(*import);
    } else {
      ++refused;
      shapespline::fuzz::checkError(import.error());
    }
    shapespline::fuzz::oneInput(path.filename().string(), contentOf(path));
  }
  CHECK(files > 100);
  CHECK(refused > 90);
  CHECK(realFiles({"malformed/wild/html-page/Soldier.glb"}).import().error().message.find("web page") !=
        std::string::npos);
  CHECK(realFiles({"malformed/wild/truncated/facecap.glb"}).import().error().code == ErrorCode::TruncatedFile);
}

}  // namespace shapespline::test::real_files_test
