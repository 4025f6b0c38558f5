// Writes shapes as bytes of files. JavaScript copies the bytes and releases their handle.
#include "bindings/export.h"
#include "bindings/files/file_marshal.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "core/mesh/principal_offsets.h"
#include "io/export.h"

namespace shapespline::bindings {
namespace {

using Bytes = std::vector<std::uint8_t>;

Json keepBytes(Bytes bytes) {
  const int handle = handleTable().add(std::move(bytes));
  const Bytes& kept = handleTable().get<Bytes>(handle);
  return {{"handle", handle}, {"bytes", range(kept.data(), kept.size())}};
}

Result<Bytes> writePose(const std::string& format, std::span<const float> positions, std::span<const float> normals,
                        const std::vector<Triangle>& faces, const Scene& scene, const MaterialLibrary& library,
                        const MeshOffset& offset) {
  if (format == "obj") return writeObj(positions, faces, scene, normals, library, offset);
  if (format == "ply") return writePly(positions, faces, offset);
  return writePoseGlb(positions, normals, faces, scene, offset.value);
}

}  // namespace

/// {faces, scene, vertices, seconds, stills, weights, project, offset, name, clip, targetNames} -> {handle, bytes}.
/// Requests the frames from JavaScript one by one.
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
    const auto weights = elements<float>(json.at("weights"));
    source.weights.assign(weights.begin(), weights.end());
    source.project = json.at("project");
    source.offset = vec3From(json.at("offset"));
    source.name = json.at("name");
    source.clip = json.at("clip");
    source.targetNames = json.at("targetNames").get<std::vector<std::string>>();
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

/// {faces, vertices, frames, scene} -> {bytes, vertices}: the file size for shapespline_write_animation, and the number
/// of vertices in its primitives.
EXPORT const char* shapespline_animation_size(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    const Scene scene = sceneFrom(json.at("scene"));
    const auto faces = trianglesFrom(elements<std::int32_t>(json.at("faces")));
    const GlbSize size = animatedGlbSize(faces, json.at("vertices"), json.at("frames"), scene);
    return Json{{"bytes", size.bytes}, {"vertices", size.vertices}};
  });
}

/// {format, positions, normals, faces, scene, library: {file, names}, offset, local} -> {handle, bytes}. format: glb,
/// obj or ply. `local`: an OBJ states the offset instead of adding it.
EXPORT const char* shapespline_write_pose(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    const auto faces = trianglesFrom(elements<std::int32_t>(json.at("faces")));
    const MaterialLibrary library{json.at("library").at("file"), json.at("library").at("names")};
    Result<Bytes> bytes =
        writePose(json.at("format"), elements<float>(json.at("positions")), elements<float>(json.at("normals")), faces,
                  sceneFrom(json.at("scene")), library, {vec3From(json.at("offset")), !json.at("local").get<bool>()});
    if (!bytes) return bytes.error();
    return keepBytes(std::move(*bytes));
  });
}

/// {frames: [range, ...], tolerance, most} -> {handle, count, offsets, weights, largest}: principalOffsets of the
/// frames.
EXPORT const char* shapespline_principal_offsets(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    std::vector<std::vector<float>> rows;
    for (const Json& frame : json.at("frames")) {
      const auto numbers = elements<float>(frame);
      rows.emplace_back(numbers.begin(), numbers.end());
    }
    const int handle = handleTable().add(principalOffsets(rows, json.at("tolerance"), json.at("max")));
    const PrincipalOffsets& kept = handleTable().get<PrincipalOffsets>(handle);
    return Json{{"handle", handle},
                {"count", kept.count},
                {"offsets", range(kept.offsets.data(), kept.offsets.size())},
                {"weights", range(kept.weights.data(), kept.weights.size())},
                {"largest", kept.largest}};
  });
}

}  // namespace shapespline::bindings
