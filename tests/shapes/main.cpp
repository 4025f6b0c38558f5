// Writes bench-FACES.glb: keys (three) of a generated mesh.
//   --bench FACES [KEYS] OUTDIR        one smooth body
//   --bench-split FACES [KEYS] OUTDIR  the same with every face split into four
//   --bench-parts FACES [KEYS] OUTDIR  several components with open boundaries
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/export.h"
#include "shapes/bench_mesh.h"
#include "shapes/bench_parts.h"

using namespace shapespline;

namespace {

bool writeFile(const std::filesystem::path& path, const void* bytes, std::size_t size) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.string().c_str(), "wb"), std::fclose);
  const bool written = file && std::fwrite(bytes, 1, size, file.get()) == size && std::fflush(file.get()) == 0;
  if (!written) std::fprintf(stderr, "%s cannot be written\n", path.string().c_str());
  return written;
}

std::vector<float> toFloats(const Positions& positions) {
  std::vector<float> floats;
  floats.reserve(3 * positions.size());
  for (const Vec3& p : positions)
    for (int k = 0; k < 3; ++k) floats.push_back(static_cast<float>(p[k]));
  return floats;
}

Result<std::vector<std::uint8_t>> glbOf(const Keyframes& keyframes) {
  Scene scene;
  scene.materials.emplace_back();
  scene.groups.push_back({0, keyframes.faceCount(), 0});
  AnimationSource source;
  source.faces = &keyframes.faces;
  source.scene = &scene;
  for (const Key& key : keyframes.keys) source.seconds.push_back(key.time);
  source.frame = [&](int frame, std::vector<float>& positions, std::vector<float>& normals) {
    positions = toFloats(keyframes.keys[frame].positions);
    normals.clear();
    return Status();
  };
  return writeAnimatedGlb(source);
}

// The kind of mesh for a command line option.
struct BenchKind {
  const char* word;
  const char* suffix;
  Keyframes (*make)(int faces, int keys, std::uint32_t seed);
};

Keyframes makeSplit(int faces, int keys, std::uint32_t seed) {
  return subdivided(makeBenchKeyframes(faces, keys, seed));
}

constexpr BenchKind benchKinds[] = {
    {"--bench", "", makeBenchKeyframes},
    {"--bench-split", "-split", makeSplit},
    {"--bench-parts", "-parts", makeBenchParts},
};

const BenchKind* benchKindOf(const std::string& word) {
  for (const BenchKind& kind : benchKinds)
    if (word == kind.word) return &kind;
  return nullptr;
}

int writeMesh(const BenchKind& kind, int faces, int keys, const std::filesystem::path& folder) {
  constexpr std::uint32_t seed = 1;
  const auto glb = glbOf(kind.make(faces, keys, seed));
  if (!glb) {
    std::fprintf(stderr, "%s\n", glb.error().message.c_str());
    return 1;
  }
  const std::string name = "bench-" + std::to_string(faces) + kind.suffix + ".glb";
  return writeFile(folder / name, glb->data(), glb->size()) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const BenchKind* const kind = argc == 4 || argc == 5 ? benchKindOf(argv[1]) : nullptr;
  const int faces = kind ? std::atoi(argv[2]) : 0;
  const int keys = argc == 5 ? std::atoi(argv[3]) : 3;
  if (!kind || faces < 64 || faces > 4000000 || keys < 2 || keys > 100) {
    std::fprintf(stderr, "usage: shapespline_meshes --bench|--bench-split|--bench-parts FACES [KEYS] OUTDIR\n");
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    std::fprintf(stderr, "%s cannot be made: %s\n", folder.string().c_str(), error.message().c_str());
    return 1;
  }
  return writeMesh(*kind, faces, keys, folder);
}
