// Keyframes -> a sequence object; times -> shapes and what can be measured on them.
#include <malloc.h>

#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "bindings/marshal.h"
#include "core/mesh/measures.h"
#include "core/sequence/gram_matrix.h"

namespace shapespline::bindings {
namespace {

Json state(const Sequence& sequence) {
  const auto [first, last] = sequence.range();
  return {{"range", {first, last}}, {"warnings", toJson(sequence.warnings())}};
}

Sequence& sequenceOf(int handle) { return handleTable().get<SequenceObject>(handle).sequence; }

Json described(const Frame& frame) {
  return {{"positions", range(frame.positions.data(), frame.positions.size())},
          {"normals", range(frame.normals.data(), frame.normals.size())},
          {"indefiniteFaces", frame.indefiniteFaces},
          {"indefiniteFace", frame.indefiniteFace}};
}

std::vector<double> numbersIn(const char* request, const char* name) {
  return Json::parse(request).at(name).get<std::vector<double>>();
}

}  // namespace

/// {faces, normals, keys: [{name, time, positions}], encoding, motion} -> {handle, range, warnings}.
EXPORT const char* shapespline_sequence(const char* request) {
  return callResult([&]() -> Result<Json> {
    reportProgress("welding", 0);
    const Json json = Json::parse(request);
    Result<Sequence> sequence = Sequence::create(keyframesFrom(json), encodingFrom(json.at("encoding")),
                                                 motionFrom(json.at("motion")), reportProgress, takeOrder);
    if (!sequence) return sequence.error();
    Json described = state(*sequence);
    described["handle"] = handleTable().add(SequenceObject{std::move(*sequence), {}, {}});
    return described;
  });
}

/// The same -> {order}: int32 numbers, valid until the next call.
EXPORT const char* shapespline_order(const char* request) {
  return callResult([&]() -> Result<Json> {
    static std::vector<int> order;
    const Json json = Json::parse(request);
    auto found = eliminationOrder(keyframesFrom(json), encodingFrom(json.at("encoding")));
    if (!found) return found.error();
    order = std::move(*found);
    return Json{{"order", range(order.data(), order.size())}};
  });
}

/// {motion, keyTimes} -> {range, warnings}.
EXPORT const char* shapespline_update(int handle, const char* request) {
  return callResult([&]() -> Result<Json> {
    const Json json = Json::parse(request);
    Sequence& sequence = sequenceOf(handle);
    const Status status =
        sequence.update(motionFrom(json.at("motion")), json.at("keyTimes").get<std::vector<double>>());
    if (!status) return status.error();
    return state(sequence);
  });
}

/// {positions, normals, indefiniteFaces, indefiniteFace} of the shape at t: 3n floats each, valid until
/// the next frame of this handle.
EXPORT const char* shapespline_evaluate(int handle, double t) {
  return callResult([&]() -> Result<Json> {
    auto& [sequence, frame, ghost] = handleTable().get<SequenceObject>(handle);
    const Status status = sequence.evaluate(t, frame);
    if (!status) return status.error();
    return described(frame);
  });
}

/// {weights: one per key, sum 1} -> the same of the shape that they blend.
EXPORT const char* shapespline_blend(int handle, const char* request) {
  return callResult([&]() -> Result<Json> {
    auto& [sequence, frame, ghost] = handleTable().get<SequenceObject>(handle);
    const Status status = sequence.evaluateBlend(numbersIn(request, "weights"), frame);
    if (!status) return status.error();
    return described(frame);
  });
}

/// {volume, area, sliding} of the shape at t, in double precision, on the input's own faces.
EXPORT const char* shapespline_measure(int handle, double t) {
  return callResult([&]() -> Result<Json> {
    Sequence& sequence = sequenceOf(handle);
    Positions positions;
    if (const Status status = sequence.evaluate(t, positions); !status) return status.error();
    const auto& faces = sequence.faces();
    return Json{{"volume", enclosedVolume(positions, faces)},
                {"area", surfaceArea(positions, faces)},
                {"sliding", sequence.sliding(t, positions)}};
  });
}

/// {times} -> {keys, tangents, curve, distance, weights, explained}: feature_curve.h.
EXPORT const char* shapespline_plane(int handle, const char* request) {
  return callResult([&]() -> Result<Json> {
    const ShapePlane plane = sequenceOf(handle).shapePlane(numbersIn(request, "times"));
    return Json{{"keys", plane.keys},         {"tangents", plane.tangents}, {"curve", plane.curve},
                {"distance", plane.distance}, {"weights", plane.weights},   {"explained", plane.explained}};
  });
}

/// {times, weights, plane, energy, curveEnergy} of so many samples: feature_curve.h.
EXPORT const char* shapespline_discrete_path(int handle, int samples) {
  return callResult([&]() -> Result<Json> {
    const auto path = sequenceOf(handle).discretePath(samples);
    if (!path) return path.error();
    return Json{{"times", path->times},
                {"weights", path->weights},
                {"plane", path->plane},
                {"energy", path->energy},
                {"curveEnergy", path->curveEnergy}};
  });
}

/// {times} -> {patch, neighbours, numbers, natural} of a face, or of a patch: feature_curve.h.
EXPORT const char* shapespline_part_curve(int handle, int index, bool isPatch, const char* request) {
  return callResult([&]() -> Result<Json> {
    const std::vector<double> times = numbersIn(request, "times");
    const auto curve =
        isPatch ? sequenceOf(handle).patchCurve(index, times) : sequenceOf(handle).faceCurve(index, times);
    if (!curve) return curve.error();
    return Json{{"patch", curve->patch},
                {"neighbours", curve->neighbours},
                {"numbers", curve->numbers},
                {"natural", curve->natural}};
  });
}

/// {distance, tension}: feature_curve.h.
EXPORT const char* shapespline_pace(int handle) {
  return callResult([&]() -> Result<Json> {
    const KeyPace pace = sequenceOf(handle).keyPace();
    return Json{{"distance", pace.distance}, {"tension", pace.tension}};
  });
}

/// {times} -> {speed, overshoot}: feature_curve.h.
EXPORT const char* shapespline_motion_pace(int handle, const char* request) {
  return callResult([&]() -> Result<Json> {
    const auto times = numbersIn(request, "times");
    const MotionPace pace = sequenceOf(handle).motionPace(times);
    return Json{{"speed", pace.speed}, {"overshoot", pace.overshoot}};
  });
}

/// {times} -> {energy}.
EXPORT const char* shapespline_bending(int handle, const char* request) {
  return callResult([&]() -> Result<Json> {
    return Json{{"energy", sequenceOf(handle).bendingEnergy(numbersIn(request, "times"))}};
  });
}

/// {parts}: the patch of each face, or its component, int32, belonging to the handle.
EXPORT const char* shapespline_parts(int handle, bool arePatches) {
  return callResult([&]() -> Result<Json> {
    const Sequence& sequence = sequenceOf(handle);
    const std::vector<int>& parts = arePatches ? sequence.patchOfFace() : sequence.componentOfFace();
    return Json{{"parts", range(parts.data(), parts.size())}};
  });
}

/// {faces, vertexOf, ghostVertexOf, ghostFaceOf} of the ghost mesh, int32, belonging to the handle; all empty without
/// one.
EXPORT const char* shapespline_ghost(int handle) {
  return callResult([&]() -> Result<Json> {
    const Ghost& ghost = sequenceOf(handle).ghost();
    const auto indices = [](const std::vector<int>& list) { return range(list.data(), list.size()); };
    return Json{{"faces", range(reinterpret_cast<const int*>(ghost.faces.data()), 3 * ghost.faces.size())},
                {"vertexOf", indices(ghost.vertexOf)},
                {"ghostVertexOf", indices(ghost.ghostVertexOf)},
                {"ghostFaceOf", indices(ghost.ghostFaceOf)}};
  });
}

/// {positions}: xyz of the ghost's vertices at t, valid until the next call for the same handle.
EXPORT const char* shapespline_ghost_positions(int handle, double t) {
  return callResult([&]() -> Result<Json> {
    auto& [sequence, frame, ghost] = handleTable().get<SequenceObject>(handle);
    if (const Status status = sequence.evaluateGhost(t, ghost); !status) return status.error();
    return Json{{"positions", range(ghost.data(), ghost.size())}};
  });
}

/// What building and frames cost, and usedBytes: what the heap holds now.
EXPORT const char* shapespline_stats(int handle) {
  return callResult([&]() -> Result<Json> {
    Json stats = toJson(sequenceOf(handle).stats());
    stats["usedBytes"] = mallinfo().uordblks;
    return stats;
  });
}

}  // namespace shapespline::bindings
