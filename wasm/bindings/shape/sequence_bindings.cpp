// Creates shapes from keyframes, motions from options and times, and frames and measures from times. Most calls take a
// handle and JSON; all return JSON. web/engine/wire/calls.ts lists them.
#include <malloc.h>

#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/js_imports.h"
#include "bindings/shape/shape_marshal.h"
#include "bindings/shape/shape_objects.h"
#include "core/base/stopwatch.h"
#include "core/mesh/measures.h"
#include "core/sequence/elimination_order.h"
#include "core/sequence/mesh_report.h"
#include "core/space/lri_space.h"

namespace shapespline::bindings {
namespace {

Sequence& motionOf(int handle) { return handleTable().get<MotionObject>(handle).sequence; }

ShapeObject& shapeOf(int handle) { return handleTable().get<ShapeObject>(handle); }

/// The shape of a motion.
ShapeObject& shapeOfMotion(int handle) { return shapeOf(handleTable().get<MotionObject>(handle).shape); }

Json described(const Frame& frame) {
  return {{"positions", range(frame.positions.data(), frame.positions.size())},
          {"normals", range(frame.normals.data(), frame.normals.size())},
          {"indefiniteFaces", frame.indefiniteFaces},
          {"indefiniteFace", frame.indefiniteFace}};
}

std::vector<double> numbersOf(const Json& json, const char* name) { return json.at(name).get<std::vector<double>>(); }

Json described(const std::vector<int>& numbers) { return range(numbers.data(), numbers.size()); }

Json described(const CoordinateCurve& curve) {
  return {
      {"patch", curve.patch}, {"neighbours", curve.neighbours}, {"numbers", curve.numbers}, {"natural", curve.natural}};
}

/// Answers a query about the motion with this handle in LRI space. ask: FeatureCurve, Json -> Result<Json>.
template <class Ask>
const char* askCurve(int handle, const char* request, const Ask& ask) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    const auto curve = motionOf(handle).featureCurve();
    if (!curve) return curve.error();
    return ask(*curve, json);
  });
}

/// Answers a query about LRI space itself, which is created if needed.
template <class Ask>
const char* askLri(int handle, const Ask& ask) {
  return callResult([&]() -> Result<Json> {
    SharedShape& shape = *shapeOf(handle).shape;
    if (const Status status = shape.makeSpace(Method::Lri); !status) return status.error();
    return ask(shape.encoded().lri());
  });
}

}  // namespace

/// {faces, normals, keys: [{name, time, positions}], encoding} -> {handle} of a shape.
EXPORT const char* shapespline_encode(const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    reportProgress("welding", 0);
    auto shape = SharedShape::encode(keyframesFrom(json), encodingFrom(json.at("encoding")), reportProgress);
    if (!shape) return shape.error();
    return Json{{"handle", handleTable().add(ShapeObject{std::move(*shape), {}, {}})}};
  });
}

/// Same request as shapespline_encode -> {order}: int32 numbers, valid until the next call.
EXPORT const char* shapespline_order(const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    static std::vector<int> order;
    auto found = eliminationOrder(keyframesFrom(json), encodingFrom(json.at("encoding")));
    if (!found) return found.error();
    order = std::move(*found);
    return Json{{"order", range(order.data(), order.size())}};
  });
}

/// {faces, normals, keys} -> {report} on the mesh, for keys that do not come from a file.
EXPORT const char* shapespline_report(const char* request) {
  return answer(request, [](const Json& json) -> Result<Json> {
    const Keyframes keyframes = keyframesFrom(json);
    if (const Status valid = validate(keyframes); !valid) return valid.error();
    return Json{{"report", toJson(reportOf(keyframes))}};
  });
}

/// {motion, keyTimes, before} -> {handle, range, warnings} of a motion of the shape. Creates the motion's space if
/// needed. `before`: another motion of the shape whose costly parts are reused, or null.
EXPORT const char* shapespline_motion(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    const Json& before = json.at("before");
    auto motion = Sequence::fit(shapeOf(handle).shape, numbersOf(json, "keyTimes"), motionFrom(json.at("motion")),
                                before.is_null() ? nullptr : &motionOf(before), reportProgress, takeOrder);
    if (!motion) return motion.error();
    const auto [first, last] = motion->range();
    Json described = {{"range", {first, last}}, {"warnings", toJson(motion->warnings())}};
    described["handle"] = handleTable().add(MotionObject{std::move(*motion), handle});
    return described;
  });
}

/// {positions, normals, indefiniteFaces, indefiniteFace} of a motion's shape at t: 3n floats each, valid until the
/// shape's next frame.
EXPORT const char* shapespline_evaluate(int handle, double t) {
  return callResult([&]() -> Result<Json> {
    Frame& frame = shapeOfMotion(handle).frame;
    const Status status = motionOf(handle).evaluate(t, frame);
    if (!status) return status.error();
    return described(frame);
  });
}

/// {weights: one per key, sum 1} -> the blended shape, in the format of shapespline_evaluate.
EXPORT const char* shapespline_blend(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    Frame& frame = shapeOfMotion(handle).frame;
    const Status status = motionOf(handle).evaluateBlend(numbersOf(json, "weights"), frame);
    if (!status) return status.error();
    return described(frame);
  });
}

/// {times, maxMs} -> {volume, area, sliding} of the shapes at the first of these times: at least one, and more until
/// maxMs is used up. Computed in double precision, on the input's faces.
EXPORT const char* shapespline_measure(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    Sequence& motion = motionOf(handle);
    const double maxMs = json.at("maxMs");
    Stopwatch watch;
    double spent = 0;
    std::vector<double> volume, area, sliding;
    Positions positions;
    for (const double t : numbersOf(json, "times")) {
      if (!volume.empty() && spent > maxMs) break;
      if (const Status status = motion.evaluate(t, positions); !status) return status.error();
      volume.push_back(enclosedVolume(positions, motion.faces()));
      area.push_back(surfaceArea(positions, motion.faces()));
      const auto slides = motion.sliding(t, positions);
      if (!slides) return slides.error();
      sliding.push_back(*slides);
      spent += watch.lap();
    }
    return Json{{"volume", volume}, {"area", area}, {"sliding", sliding}};
  });
}

/// {times, shape} -> {keys, tangents, curve, distance, weights, explained}: feature_curve.h. shape: another motion's
/// shape at the only time, 3n floats, or null.
EXPORT const char* shapespline_plane(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    const std::vector<double> times = numbersOf(json, "times");
    const auto shape = elements<float>(json.at("shape"));
    const ShapePlane plane = shape.empty() ? curve.plane(times) : curve.planeWith(times.at(0), positionsFrom(shape));
    return Json{{"keys", plane.keys},         {"tangents", plane.tangents}, {"curve", plane.curve},
                {"distance", plane.distance}, {"weights", plane.weights},   {"explained", plane.explained}};
  });
}

/// {samples} -> {times, weights, plane, energy, curveEnergy}: feature_curve.h.
EXPORT const char* shapespline_discrete_path(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    const auto path = curve.discretePath(json.at("samples"));
    if (!path) return path.error();
    return Json{{"times", path->times},
                {"weights", path->weights},
                {"plane", path->plane},
                {"energy", path->energy},
                {"curveEnergy", path->curveEnergy}};
  });
}

/// {face, times} -> {patch, neighbours, numbers, natural}: feature_curve.h.
EXPORT const char* shapespline_face_curve(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    const auto face = curve.face(json.at("face"), numbersOf(json, "times"));
    if (!face) return face.error();
    return described(*face);
  });
}

/// {patch, times} -> the format of shapespline_face_curve.
EXPORT const char* shapespline_patch_curve(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    const auto patch = curve.patch(json.at("patch"), numbersOf(json, "times"));
    if (!patch) return patch.error();
    return described(*patch);
  });
}

/// {} -> {distance, tension}: feature_curve.h.
EXPORT const char* shapespline_key_spacing(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json&) -> Result<Json> {
    const KeySpacing spacing = curve.keySpacing();
    return Json{{"distance", spacing.distance}, {"tension", spacing.tension}};
  });
}

/// {times} -> {speed, overshoot}: feature_curve.h.
EXPORT const char* shapespline_motion_speed(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    const MotionSpeed motion = curve.speedAt(numbersOf(json, "times"));
    return Json{{"speed", motion.speed}, {"overshoot", motion.overshoot}};
  });
}

/// {times} -> {energy}.
EXPORT const char* shapespline_bending(int handle, const char* request) {
  return askCurve(handle, request, [](const FeatureCurve& curve, const Json& json) -> Result<Json> {
    return Json{{"energy", curve.bendingEnergy(numbersOf(json, "times"))}};
  });
}

/// {t, regionOf} -> {intervals, shapes}: timing_derivatives.h. `shapes` are valid until the next call.
EXPORT const char* shapespline_timing_derivatives(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    static TimingDerivatives derivatives;
    auto found = motionOf(handle).timingDerivatives(json.at("t"), json.at("regionOf").get<std::vector<int>>());
    if (!found) return found.error();
    derivatives = std::move(*found);
    return Json{{"intervals", derivatives.intervals},
                {"shapes", range(derivatives.shapes.data(), derivatives.shapes.size())}};
  });
}

/// {t} -> {positions}: xyz of the ghost's vertices, valid until the next call for this shape.
EXPORT const char* shapespline_ghost_positions(int handle, const char* request) {
  return answer(request, [&](const Json& json) -> Result<Json> {
    std::vector<float>& ghost = shapeOfMotion(handle).ghost;
    if (const Status status = motionOf(handle).evaluateGhost(json.at("t"), ghost); !status) return status.error();
    return Json{{"positions", range(ghost.data(), ghost.size())}};
  });
}

/// {} -> {componentOf}: component of each face of the shape, int32, -1 without area. The range belongs to the handle.
EXPORT const char* shapespline_components(int handle, const char*) {
  return callResult([&]() -> Result<Json> {
    return Json{{"componentOf", described(shapeOf(handle).shape->encoded().componentOfInputFace())}};
  });
}

/// {} -> {patchOf}: patch of each face of the shape, int32, -1 without area. The range belongs to the handle.
EXPORT const char* shapespline_patches(int handle, const char*) {
  return askLri(handle, [](const LriSpace& lri) { return Json{{"patchOf", described(lri.patchOfInputFace())}}; });
}

/// {} -> {faces, vertexOf, ghostVertexOf, ghostFaceOf} of the shape's ghost mesh, int32; all empty without a ghost. The
/// ranges belong to the handle.
EXPORT const char* shapespline_ghost(int handle, const char*) {
  return askLri(handle, [](const LriSpace& lri) {
    const Ghost& ghost = lri.ghost();
    return Json{{"faces", range(reinterpret_cast<const int*>(ghost.faces.data()), 3 * ghost.faces.size())},
                {"vertexOf", described(ghost.vertexOf)},
                {"ghostVertexOf", described(ghost.ghostVertexOf)},
                {"ghostFaceOf", described(ghost.ghostFaceOf)}};
  });
}

/// {} -> the cost of building the shape and its frames, and usedBytes: the heap in use.
EXPORT const char* shapespline_stats(int handle, const char* request) {
  return answer(request, [&](const Json&) -> Result<Json> {
    Json stats = toJson(shapeOf(handle).shape->stats());
    stats["usedBytes"] = mallinfo().uordblks;
    return stats;
  });
}

}  // namespace shapespline::bindings
