#include "core/lri/carried_components.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/mesh/contact.h"

namespace shapespline {

namespace {

// Regularises the fixed point of rotations. Rotations of a few degrees determine it poorly.
constexpr double stillness = 1e-3;
// Number of query vertices for the face nearest to a part without area.
constexpr int queriesPerGroup = 1000;

class CarriedEncoder {
 public:
  CarriedEncoder(const WeldedShape& shape, const ShapeTopology& topology, const LocalFramePoses& frames, bool facesRest)
      : shape_(shape), topology_(topology), frames_(frames), rests_(facesRest) {}

  CarriedComponents run() {
    encodeJoints();
    encodeLoose();
    return std::move(out_);
  }

 private:
  const Quaternion& localFrameOf(int f, int column) const { return frames_.rotation[column][frames_.ofFace[f]]; }

  void encodeJoints() {
    std::vector<char> placed(topology_.solved.count, 0);
    for (int component : topology_.tree.order) {
      const ComponentLink& link = topology_.tree.link[component];
      if (link.parent < 0) continue;
      const int a = link.anchorFace, b = link.contactFace;
      // Components that torn faces connect have their relative position from the second system.
      placed[topology_.solved.ofFace[a]] = 1;
      const int part = topology_.solved.ofFace[b];
      if (std::exchange(placed[part], 1)) continue;
      ComponentJoint joint{part, a, b, frames_.ofFace[a], frames_.ofFace[b], Vec3::Zero(), {}};
      std::vector<Mat3> turn;  // rotation of b relative to a, per column
      for (int c = 0; c < shape_.columns(); ++c) {
        const Quaternion anchor = turnOf(a, c);
        const Positions& p = shape_.poses[c];
        turn.push_back((anchor.conjugate() * turnOf(b, c)).toRotationMatrix());
        joint.offset.push_back(anchor.conjugate() * (centroidOf(p, shape_.faces[b]) - centroidOf(p, shape_.faces[a])));
      }
      std::vector<Mat3> distinctTurn;
      std::vector<Vec3> distinctOffset;
      for (int c = 0; c < shape_.columns(); ++c)
        if (!shape_.repeatsFirst(c)) {
          distinctTurn.push_back(turn[c]);
          distinctOffset.push_back(joint.offset[c]);
        }
      joint.pivot = stillPoint(distinctTurn, distinctOffset);
      for (int c = 0; c < shape_.columns(); ++c) joint.offset[c] += turn[c] * joint.pivot;
      out_.joints.push_back(std::move(joint));
    }
  }

  // The x with the smallest variation of turn x + offset. Close to 0 in directions that the rotations leave
  // undetermined.
  static Vec3 stillPoint(const std::vector<Mat3>& turn, const std::vector<Vec3>& offset) {
    const double columns = static_cast<double>(turn.size());
    Mat3 meanTurn = Mat3::Zero(), normal = Mat3::Zero();
    Vec3 meanOffset = Vec3::Zero(), right = Vec3::Zero();
    for (std::size_t c = 0; c < turn.size(); ++c) {
      meanTurn += turn[c] / columns;
      meanOffset += offset[c] / columns;
    }
    for (std::size_t c = 0; c < turn.size(); ++c) {
      const Mat3 a = turn[c] - meanTurn;
      normal += a.transpose() * a / columns;
      right -= a.transpose() * (offset[c] - meanOffset) / columns;
    }
    return (normal + stillness * Mat3::Identity()).ldlt().solve(right);
  }

  // R_f, or the rotation of its frame if faces rest in their frames.
  Quaternion turnOf(int f, int column) const {
    return rests_ ? localFrameOf(f, column) : rotationOf(shape_, f, column);
  }

  void encodeLoose() {
    std::vector<int> faceAt(shape_.vertexCount(), -1);  // the anchor of a face with area at each vertex
    for (int f = 0; f < shape_.faceCount(); ++f)
      for (int v : shape_.faces[f])
        if (topology_.hasArea[f] && faceAt[v] < 0) faceAt[v] = topology_.anchor[f];
    if (std::none_of(faceAt.begin(), faceAt.end(), [](int f) { return f < 0; })) return;
    const VertexFaces facesAt = facesOfVertices(shape_.vertexCount(), shape_.faces);
    std::vector<int> anchor = faceAt;
    spreadOverFacesWithoutArea(facesAt, anchor);
    anchorGroups(facesAt, faceAt, anchor);
    for (int v = 0; v < shape_.vertexCount(); ++v) {
      if (faceAt[v] >= 0) continue;
      const int f = anchor[v];
      LooseVertex loose{v, f, frames_.ofFace[f], {}};
      for (int c = 0; c < shape_.columns(); ++c) {
        const Positions& p = shape_.poses[c];
        loose.offset.push_back(turnOf(f, c).conjugate() * (p[v] - centroidOf(p, shape_.faces[f])));
      }
      out_.loose.push_back(std::move(loose));
    }
  }

  // A vertex with only faces without area takes the anchor of the nearest vertex connected by such faces.
  void spreadOverFacesWithoutArea(const VertexFaces& facesAt, std::vector<int>& anchor) const {
    std::vector<int> settled;  // a queue
    for (int v = 0; v < shape_.vertexCount(); ++v)
      if (anchor[v] >= 0) settled.push_back(v);
    for (std::size_t taken = 0; taken < settled.size(); ++taken) {
      const int v = settled[taken];
      for (int f : facesAt.of(v)) {
        if (topology_.hasArea[f]) continue;
        for (int u : shape_.faces[f])
          if (anchor[u] < 0) {
            anchor[u] = anchor[v];
            settled.push_back(u);
          }
      }
    }
  }

  // Groups connected to no face with area, such as a part that is one point in some pose, follow their nearest face as
  // a whole.
  void anchorGroups(const VertexFaces& facesAt, const std::vector<int>& faceAt, std::vector<int>& anchor) const {
    std::vector<const Positions*> poses;
    for (const Positions& pose : shape_.poses) poses.push_back(&pose);
    std::vector<int> partOf;  // all vertices of faces with area form one part
    for (const int f : faceAt) partOf.push_back(f >= 0 ? 0 : -1);
    const int everyLabel[] = {0};
    std::optional<ContactSearch> search;
    std::vector<int> shared;
    std::vector<char> met(anchor.size(), 0);
    for (int first = 0; first < shape_.vertexCount(); ++first) {
      if (anchor[first] >= 0) continue;
      if (!search) {
        search.emplace(poses, partOf, 1);
        shared = search->sharedLabels(everyLabel);
      }
      const std::vector<int> group = looseGroup(facesAt, first, met);
      Contact nearest;
      std::vector<int> lastFound;
      for (int v : spreadSample(group, queriesPerGroup)) search->nearestOther(v, shared, -1, nearest, lastFound);
      for (int v : group) anchor[v] = faceAt[nearest.to];
    }
  }

  // The vertices connected to the first one by faces. None may be visited before.
  std::vector<int> looseGroup(const VertexFaces& facesAt, int first, std::vector<char>& met) const {
    std::vector<int> group = {first};
    met[first] = 1;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (int f : facesAt.of(group[i]))
        for (int v : shape_.faces[f])
          if (!met[v]) {
            met[v] = 1;
            group.push_back(v);
          }
    return group;
  }

  const WeldedShape& shape_;
  const ShapeTopology& topology_;
  const LocalFramePoses& frames_;
  bool rests_;
  CarriedComponents out_;
};

}  // namespace

CarriedComponents encodeCarriedComponents(const WeldedShape& shape, const ShapeTopology& topology,
                                          const LocalFramePoses& frames, bool facesRest) {
  return CarriedEncoder(shape, topology, frames, facesRest).run();
}

}  // namespace shapespline
