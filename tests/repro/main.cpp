// shapespline_repro OUT_FOLDER: writes the inputs of repro_shapes.h, one folder per input with one OBJ per key, to open
// in the page.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/export.h"
#include "repro_shapes.h"

namespace fs = std::filesystem;
using namespace shapespline;

namespace {

bool writePose(const fs::path& path, const Positions& positions, const std::vector<Triangle>& faces) {
  std::vector<float> xyz;
  for (const Vec3& p : positions)
    for (const double x : p) xyz.push_back(static_cast<float>(x));
  const std::vector<std::uint8_t> bytes = *writeObj(xyz, faces, {});
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file.flush().good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: shapespline_repro OUT_FOLDER\n");
    return 2;
  }
  for (const repro::Repro& input : repro::allRepros()) {
    const fs::path folder = fs::path(argv[1]) / input.name;
    std::error_code error;
    fs::create_directories(folder, error);
    for (int j = 0; j < input.keyframes.keyCount(); ++j) {
      const fs::path path = folder / (input.name + "-" + std::to_string(j + 1) + ".obj");
      if (error || !writePose(path, input.keyframes.keys[j].positions, input.keyframes.faces)) {
        std::fprintf(stderr, "%s cannot be written\n", path.string().c_str());
        return 1;
      }
    }
    std::printf("%s: %d keys, %d vertices\n", input.name.c_str(), input.keyframes.keyCount(),
                input.keyframes.vertexCount());
  }
}
