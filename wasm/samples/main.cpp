// Writes the built-in samples and their list, or bench-FACES.glb: keys (three) of a generated mesh.
//   shapespline_samples OUTDIR
//   shapespline_samples --bench FACES [KEYS] OUTDIR        one smooth body
//   shapespline_samples --bench-split FACES [KEYS] OUTDIR  the same with every face split into four
//   shapespline_samples --bench-parts FACES [KEYS] OUTDIR  several components with open boundaries
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "samples/bench_mesh.h"
#include "samples/bench_parts.h"
#include "samples/sample_file.h"

namespace {

bool writeFile(const std::filesystem::path& path, const void* bytes, std::size_t size) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.string().c_str(), "wb"), std::fclose);
  const bool written = file && std::fwrite(bytes, 1, size, file.get()) == size && std::fflush(file.get()) == 0;
  if (!written) std::fprintf(stderr, "%s cannot be written\n", path.string().c_str());
  return written;
}

bool writeSample(const std::filesystem::path& folder, const shapespline::Sample& sample) {
  const auto glb = shapespline::sampleGlb(sample);
  if (!glb) {
    std::fprintf(stderr, "%s: %s\n", sample.id.c_str(), glb.error().message.c_str());
    return false;
  }
  const auto& keyframes = sample.keyframes;
  std::printf("%s: %d keys, %d vertices, %d faces, %zu KB\n", sample.id.c_str(), keyframes.keyCount(),
              keyframes.vertexCount(), keyframes.faceCount(), glb->size() / 1024);
  return writeFile(folder / shapespline::sampleFileName(sample), glb->data(), glb->size());
}

int writeSamples(const std::filesystem::path& folder) {
  std::vector<shapespline::Sample> samples;
  for (const auto& maker : shapespline::sampleMakers()) {
    samples.push_back(maker.make());
    if (!writeSample(folder, samples.back())) return 1;
  }
  const std::string list = shapespline::sampleList(samples);
  return writeFile(folder / "samples.json", list.data(), list.size()) ? 0 : 1;
}

// Which generated mesh a word asks for.
struct BenchKind {
  const char* word;
  const char* suffix;
  shapespline::Keyframes (*make)(int faces, int keys, std::uint32_t seed);
};

shapespline::Keyframes makeSplit(int faces, int keys, std::uint32_t seed) {
  return shapespline::subdivided(shapespline::makeBenchKeyframes(faces, keys, seed));
}

constexpr BenchKind benchKinds[] = {
    {"--bench", "", shapespline::makeBenchKeyframes},
    {"--bench-split", "-split", makeSplit},
    {"--bench-parts", "-parts", shapespline::makeBenchParts},
};

const BenchKind* benchKindOf(const std::string& word) {
  for (const BenchKind& kind : benchKinds)
    if (word == kind.word) return &kind;
  return nullptr;
}

int writeBenchMesh(const BenchKind& kind, int faces, int keys, const std::filesystem::path& folder) {
  constexpr std::uint32_t seed = 1;
  const std::string id = "bench-" + std::to_string(faces) + kind.suffix;
  return writeSample(folder, {id, id, "", shapespline::BoundaryKind::Natural, kind.make(faces, keys, seed)}) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const BenchKind* const bench = argc == 4 || argc == 5 ? benchKindOf(argv[1]) : nullptr;
  const int faces = bench ? std::atoi(argv[2]) : 0;
  const int keys = argc == 5 ? std::atoi(argv[3]) : 3;
  const bool samples = argc == 2 && argv[1][0] != '-';
  if (!samples && !(bench && faces >= 64 && faces <= 4000000 && keys >= 2 && keys <= 100)) {
    std::fprintf(stderr, "usage: shapespline_samples [--bench|--bench-split|--bench-parts FACES [KEYS]] OUTDIR\n");
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    std::fprintf(stderr, "%s cannot be made: %s\n", folder.string().c_str(), error.message().c_str());
    return 1;
  }
  return bench ? writeBenchMesh(*bench, faces, keys, folder) : writeSamples(folder);
}
