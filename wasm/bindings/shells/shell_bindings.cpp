// Fits shapes that keep lengths and angles, transfers them to a full shape, and measures the bending energy of motions.
#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "bindings/marshal.h"
#include "shells/deformation_transfer.h"
#include "shells/shell_bending.h"
#include "shells/shell_motion.h"

namespace shapespline::bindings {
namespace {

constexpr std::pair<const char*, ShellMethod> methods[] = {{"lengths", ShellMethod::Lengths},
                                                           {"shell", ShellMethod::Spline}};

struct ShapesObject {
  std::vector<std::vector<float>> shapes;
};

struct TransferObject {
  DeformationTransfer shape;
  std::vector<float> positions;  // positions of the last answer
};

constexpr auto reportFitting = [](double fraction) { reportProgress("fitting lengths", fraction); };

Positions poseFrom(const Json& json) { return positionsFrom(elements<float>(json)); }

std::vector<Positions> posesFrom(const Json& json) {
  std::vector<Positions> poses;
  for (const Json& pose : json) poses.push_back(poseFrom(pose));
  return poses;
}

std::vector<int> indicesFrom(const Json& json) {
  const auto indices = elements<std::int32_t>(json);
  return {indices.begin(), indices.end()};
}

ShellSample sampleFrom(const Json& json) {
  const auto weights = elements<double>(json.at("weights"));
  return {json.at("time"), {weights.begin(), weights.end()}, poseFrom(json.at("start")), json.at("key")};
}

}  // namespace

/// {method, faces, keys: [positions], samples: [{time, weights, start, key}]} -> {handle, shapes: [{positions}],
/// failed, stiff, finished}: shell_motion.h. weights, start: null at a key. The ranges belong to the handle.
EXPORT const char* shapespline_fit_shells(const char* request) {
  return answer(request, [](const Json& json) -> Result<Json> {
    std::vector<ShellSample> samples;
    for (const Json& sample : json.at("samples")) samples.push_back(sampleFrom(sample));
    auto found = shellShapes(trianglesFrom(elements<std::int32_t>(json.at("faces"))), posesFrom(json.at("keys")),
                             samples, named(json.at("method"), methods), reportFitting);
    if (!found) return found.error();
    ShapesObject object;
    for (const Positions& shape : found->shapes) object.shapes.push_back(floatsFrom(shape));
    const int handle = handleTable().add(std::move(object));
    Json shapes = Json::array();
    for (const std::vector<float>& shape : handleTable().get<ShapesObject>(handle).shapes)
      shapes.push_back({{"positions", range(shape.data(), shape.size())}});
    return Json{{"handle", handle},
                {"shapes", shapes},
                {"failed", found->failed},
                {"stiff", found->stiff},
                {"finished", found->finished}};
  });
}

/// {faces, keys: [positions], leader: {faces, vertexOf, faceOf}} -> {handle}: deformation_transfer.h.
EXPORT const char* shapespline_deformation_transfer(const char* request) {
  return answer(request, [](const Json& json) -> Result<Json> {
    const Json& leader = json.at("leader");
    auto transfer =
        DeformationTransfer::create(trianglesFrom(elements<std::int32_t>(json.at("faces"))), posesFrom(json.at("keys")),
                                    {trianglesFrom(elements<std::int32_t>(leader.at("faces"))),
                                     indicesFrom(leader.at("faceOf")), indicesFrom(leader.at("vertexOf"))});
    if (!transfer) return transfer.error();
    return Json{{"handle", handleTable().add(TransferObject{std::move(*transfer), {}})}};
  });
}

/// {shape, from, to} -> {positions}, which belong to the handle until its next call.
EXPORT const char* shapespline_follow(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    TransferObject& transfer = handleTable().get<TransferObject>(handle);
    transfer.positions = floatsFrom(
        transfer.shape.follow(poseFrom(json.at("shape")), poseFrom(json.at("from")), poseFrom(json.at("to"))));
    return Json{{"positions", range(transfer.positions.data(), transfer.positions.size())}};
  });
}

/// {faces, keys: [positions], shapes: [positions], steps: [[before, here, after]], step} -> {energy}: shell_bending.h.
/// steps: three indices of shapes per energy. An energy is null if an edge has no length.
EXPORT const char* shapespline_shell_bending(const char* request) {
  return answer(request, [](const Json& json) -> Result<Json> {
    const auto bending =
        ShellBending::create(trianglesFrom(elements<std::int32_t>(json.at("faces"))), posesFrom(json.at("keys")));
    if (!bending) return bending.error();
    std::vector<ShellMeasures> measures;
    for (const Json& shape : json.at("shapes")) measures.push_back(bending->measuresOf(poseFrom(shape)));
    const double step = json.at("step");
    Json energy = Json::array();
    for (const Json& at : json.at("steps"))
      energy.push_back(bending->energy(measures[int(at[0])], measures[int(at[1])], measures[int(at[2])], step));
    return Json{{"energy", energy}};
  });
}

}  // namespace shapespline::bindings
