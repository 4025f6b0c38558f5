// Shapes -> bytes of files. The bytes are an object of their own, to be copied and released.
#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "bindings/marshal.h"
#include "io/export.h"

namespace shapespline::bindings {
namespace {

Json keepBytes(Bytes bytes) {
  const int handle = handleTable().add(std::move(bytes));
  const Bytes& kept = handleTable().get<Bytes>(handle);
  return {{"handle", handle}, {"bytes", range(kept.data(), kept.size())}};
}

Result<Bytes> writePose(const std::string& format, std::span<const float> positions, std::span<const float> normals,
                        const std::vector<Triangle>& faces, const Scene& scene) {
  if (format == "obj") return writeObj(positions, faces, scene);
  if (format == "ply") return writePly(positions, faces);
  return writePoseGlb(positions, normals, faces, scene);
}

}  // namespace

/// {faces, scene, vertices, seconds, stills, project} -> {handle, bytes}; asks JavaScript for one frame after the
/// other.
EXPORT const char* shapespline_write_animation(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    const auto faces = trianglesFrom(elements<std::int32_t>(json.at("faces")));
    const Scene scene = sceneFrom(json.at("scene"));
    const auto floats = 3 * json.at("vertices").get<std::size_t>();
    AnimationSource source;
    source.faces = &faces;
    source.scene = &scene;
    source.seconds = json.at("seconds").get<std::vector<double>>();
    source.stills = json.at("stills");
    source.project = json.at("project");
    source.frame = [&](int frame, std::vector<float>& positions, std::vector<float>& normals) -> Status {
      positions.resize(floats);
      normals.resize(floats);
      if (takeFrame(frame, positions.data(), normals.data())) return {};
      return Error{ErrorCode::Internal, "Frame " + std::to_string(frame) + " of the animation was not given."};
    };
    Result<Bytes> bytes = writeAnimatedGlb(source);
    if (!bytes) return bytes.error();
    return keepBytes(std::move(*bytes));
  });
}

/// {vertices, faces, frames, scene} -> {bytes}: the size of what shapespline_write_animation will write.
EXPORT const char* shapespline_animation_size(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    const Scene scene = sceneFrom(json.at("scene"));
    return Json{{"bytes", animatedGlbSize(json.at("vertices"), json.at("faces"), json.at("frames"), scene)}};
  });
}

/// {format: 'glb' | 'obj' | 'ply', positions, normals, faces, scene} -> {handle, bytes}.
EXPORT const char* shapespline_write_pose(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    const auto faces = trianglesFrom(elements<std::int32_t>(json.at("faces")));
    Result<Bytes> bytes = writePose(json.at("format"), elements<float>(json.at("positions")),
                                    elements<float>(json.at("normals")), faces, sceneFrom(json.at("scene")));
    if (!bytes) return bytes.error();
    return keepBytes(std::move(*bytes));
  });
}

}  // namespace shapespline::bindings
