#include "samples/sample_file.h"

#include <cmath>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

#include "io/export.h"

namespace shapespline {
namespace {

constexpr const char* credit = "Made by the generator in wasm/samples; MIT licence";

const char* boundaryName(BoundaryKind boundary) {
  switch (boundary) {
    case BoundaryKind::Hermite: return "hermite";
    case BoundaryKind::Periodic: return "periodic";
    case BoundaryKind::Natural: break;
  }
  return "natural";
}

std::vector<double> timesOf(const Keyframes& keyframes) {
  std::vector<double> times;
  for (const Key& key : keyframes.keys) times.push_back(key.time);
  return times;
}

std::vector<float> toFloats(const Positions& positions) {
  std::vector<float> floats;
  floats.reserve(3 * positions.size());
  for (const Vec3& p : positions) {
    for (int k = 0; k < 3; ++k) floats.push_back(static_cast<float>(p[k]));
  }
  return floats;
}

float linear(std::uint32_t level) {
  const double c = level / 255.0;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

// One colour all over, matt.
Scene plainScene(int faces, std::uint32_t colour) {
  Scene scene;
  Material material;
  material.name = "clay";
  material.baseColor = {linear(colour >> 16), linear(colour >> 8 & 255), linear(colour & 255), 1.0f};
  material.roughness = 0.6f;
  scene.materials.push_back(material);
  scene.groups.push_back({0, faces, 0});
  return scene;
}

}  // namespace

std::string sampleFileName(const Sample& sample) { return sample.id + ".glb"; }

Result<std::vector<std::uint8_t>> sampleGlb(const Sample& sample) {
  const Keyframes& keyframes = sample.keyframes;
  const Scene scene = plainScene(keyframes.faceCount(), sample.colour);
  AnimationSource source;
  source.faces = &keyframes.faces;
  source.scene = &scene;
  source.seconds = timesOf(keyframes);
  source.frame = [&](int frame, std::vector<float>& positions, std::vector<float>& normals) {
    positions = toFloats(keyframes.keys[frame].positions);
    normals.clear();
    return Status();
  };
  return writeAnimatedGlb(source);
}

std::string sampleList(const std::vector<Sample>& samples) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Sample& sample : samples) {
    list.push_back({{"id", sample.id},
                    {"title", sample.title},
                    {"description", sample.description},
                    {"files", {sampleFileName(sample)}},
                    {"times", timesOf(sample.keyframes)},
                    {"boundary", boundaryName(sample.boundary)},
                    {"hold", sample.hold ? "on" : "off"},
                    {"credit", credit}});
  }
  return list.dump(2) + "\n";
}

}  // namespace shapespline
