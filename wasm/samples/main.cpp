// shapespline_samples OUTDIR: writes the built-in samples and their list.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: shapespline_samples OUTDIR\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    std::fprintf(stderr, "%s cannot be made: %s\n", argv[1], error.message().c_str());
    return 1;
  }
  std::vector<shapespline::Sample> samples;
  for (const auto& maker : shapespline::sampleMakers()) {
    samples.push_back(maker.make());
    if (!writeSample(folder, samples.back())) return 1;
  }
  const std::string list = shapespline::sampleList(samples);
  return writeFile(folder / "samples.json", list.data(), list.size()) ? 0 : 1;
}
