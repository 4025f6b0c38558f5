#include "core/sequence/weld_keys.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/base/centroid.h"
#include "core/base/format.h"
#include "core/mesh/canonical_order.h"
#include "core/rotation/rigid_fit.h"

namespace shapespline {

namespace {

constexpr int minGhostFaces = 4;
// Share of the diagonal. Poses closer than this are equal up to rounding and modelling noise.
constexpr double samePose = 1e-4;

Status checkEncoding(const EncodingOptions& o, const Keyframes& k) {
  const auto invalid = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (o.reference < 0 || o.reference >= k.keyCount())
    return invalid("The reference is key " + std::to_string(o.reference + 1) + ", but there are " +
                   std::to_string(k.keyCount()) + " keys.");
  if (o.patches < 0)
    return invalid("The number of patches is " + grouped(o.patches) + ". Use 0 for the default, or a positive number.");
  if (o.ghostFaces < 0 || (o.ghostFaces > 0 && o.ghostFaces < minGhostFaces))
    return invalid("A ghost mesh needs at least " + std::to_string(minGhostFaces) + " faces, but " +
                   grouped(o.ghostFaces) + " were requested. Use 0 for no ghost mesh.");
  for (const auto* tangent : {&o.startTangent, &o.endTangent}) {
    if (!*tangent) continue;
    if (static_cast<int>((*tangent)->size()) != k.vertexCount())
      return Error{ErrorCode::VertexCountMismatch,
                   "A tangent pose has " + grouped(static_cast<std::int64_t>((*tangent)->size())) +
                       " vertices, but the keys have " + grouped(k.vertexCount()) + ". Use a pose of the same mesh."};
    for (std::size_t v = 0; v < (*tangent)->size(); ++v)
      if (!(**tangent)[v].allFinite())
        return Error{ErrorCode::NotFinite,
                     "A tangent pose's vertex " + grouped(static_cast<std::int64_t>(v)) + " is not finite.", -1,
                     static_cast<int>(v)};
  }
  return {};
}

// The rigid motion from the first key to the last, if one exists.
std::optional<RigidMotion> closingOf(const WeldedShape& shape, double diagonal) {
  const Positions &first = shape.poses.front(), &last = shape.poses[shape.keys - 1];
  const RigidFit fit = fitRigid(first, last);
  if (fit.largestDistance > samePose * diagonal) return {};
  const Quaternion rotation(fit.rotation);
  return RigidMotion{rotation, centroidOf(last) - rotation * centroidOf(first)};
}

// Puts the welded mesh into its canonical order.
void putInOrder(WeldedShape& shape, InputMesh& input, const FractionReport& onProgress) {
  // The last key of a loop repeats the first. It must not count twice, because any key could be the first.
  Positions repeated;
  const auto last = shape.poses.begin() + (shape.keys - 1);
  if (shape.closing) {
    repeated = std::move(*last);
    shape.poses.erase(last);
  }
  const MeshOrder order = canonicalOrder(shape.faces, shape.poses, onProgress);
  if (shape.closing) shape.poses.insert(shape.poses.begin() + (shape.keys - 1), std::move(repeated));
  shape.faces = order.apply(shape.faces);
  for (Positions& pose : shape.poses) pose = order.apply(pose);
  input.welding = order.apply(input.welding);
  input.inputFaceOf = order.oldFaces();
  input.mirrored = order.mirrored;
}

}  // namespace

Result<WeldedKeys> weldKeys(Keyframes keyframes, const EncodingOptions& options, const FractionReport& onProgress) {
  reportFraction(onProgress, 0);
  if (Status status = validate(keyframes); !status) return status.error();
  if (Status status = checkEncoding(options, keyframes); !status) return status.error();
  const Positions normals = std::move(keyframes.normals);
  std::vector<const Positions*> poses;
  for (const Key& key : keyframes.keys) poses.push_back(&key.positions);
  WeldedKeys keys;
  WeldedShape& shape = keys.shape;
  InputMesh& input = keys.input;
  shape.keys = keyframes.keyCount();
  shape.reference = options.reference;
  if (options.startTangent) {
    shape.startTangent = static_cast<int>(poses.size());
    poses.push_back(&*options.startTangent);
  }
  if (options.endTangent) {
    shape.endTangent = static_cast<int>(poses.size());
    poses.push_back(&*options.endTangent);
  }
  for (const Positions* pose : poses) keys.diagonal = std::max(keys.diagonal, boundingDiagonal({&pose, 1}));
  input.faces = std::move(keyframes.faces);
  input.welding = weld(poses, weldTolerances(poses), partOf(onProgress, 0, 0.5));
  shape.faces = weldFaces(input.faces, input.welding);
  for (const Positions* pose : poses) shape.poses.push_back(weldPositions(*pose, input.welding));
  keyframes.keys.clear();  // later steps take the most memory, and use the welded poses
  shape.closing = closingOf(shape, keys.diagonal);
  putInOrder(shape, input, partOf(onProgress, 0.55, 1));
  for (const Positions& pose : shape.poses) keys.meanPosition.push_back(centroidOf(pose));
  keys.shadingGroup = shadingGroups(input.welding, normals, keys.shadingGroups);
  reportFraction(onProgress, 1);
  return keys;
}

}  // namespace shapespline
