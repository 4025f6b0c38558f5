// Imports files, and converts the parts of an import to JSON and heap ranges.
#include "bindings/export.h"
#include "bindings/files/file_marshal.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "core/sequence/mesh_report.h"
#include "io/import.h"

namespace shapespline::bindings {
namespace {

/// An import, with its last requested key in single precision and that key's normals.
struct ImportObject {
  Import import;
  std::vector<float> positions;
  std::vector<float> normals;
};

constexpr double importing = 0.5;  // share of the progress for the import; the rest is for the mesh report

constexpr auto reportChecking = [](double fraction) {
  reportProgress("checking the mesh", importing + (1 - importing) * fraction);
};

Json describe(const ImportObject& object) {
  const Import& import = object.import;
  Json names = Json::array(), times = Json::array();
  for (const Key& key : import.keyframes.keys) {
    names.push_back(key.name);
    times.push_back(key.time);
  }
  const auto& faces = import.keyframes.faces;
  return {{"names", names},
          {"times", times},
          {"faces", range(faces.data()->data(), 3 * faces.size())},
          {"normals", rangeOrNull(object.normals)},
          {"scene", toJson(import.scene)},
          {"report", toJson(reportOf(import.keyframes, reportChecking))},
          {"warnings", toJson(import.warnings)},
          {"animations", toJson(import.animations)},
          {"animation", import.animation},
          {"objects", import.objects},
          {"offset", {import.offset.x(), import.offset.y(), import.offset.z()}},
          {"matches", toJson(import.matches)},
          {"project", import.project}};
}

}  // namespace

/// {files: [{name, bytes}], options} -> {handle, names, times, faces, normals, scene, report, ...}. The ranges belong
/// to the handle.
EXPORT const char* shapespline_import(const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    std::vector<NamedBytes> files;
    for (const Json& file : json.at("files"))
      files.push_back({file.at("name"), elements<std::uint8_t>(file.at("bytes"))});
    const auto progress = [](const char* stage, double fraction) { reportProgress(stage, importing * fraction); };
    Result<Import> import = importKeyframes(files, importOptionsFrom(json.at("options")), progress);
    if (!import) return import.error();
    reportChecking(0);
    if (const Status valid = validate(import->keyframes); !valid) return valid.error();
    ImportObject object{std::move(*import), {}, {}};
    object.normals = floatsFrom(object.import.keyframes.normals);
    Json described = describe(object);
    described["handle"] = handleTable().add(std::move(object));
    return described;
  });
}

/// {positions}: 3n floats of one key, valid until the next call for the same handle.
EXPORT const char* shapespline_import_positions(int handle, int key) {
  return callResult([&]() -> Result<Json> {
    ImportObject& object = handleTable().get<ImportObject>(handle);
    object.positions = floatsFrom(object.import.keyframes.keys.at(key).positions);
    return Json{{"positions", range(object.positions.data(), object.positions.size())}};
  });
}

}  // namespace shapespline::bindings
