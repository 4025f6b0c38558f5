#include "core/sequence/preview.h"

#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace shapespline {

namespace {

// Of each vertex the first face with a frame, of loose vertices the one that they are anchored at.
std::vector<int> facesOfVertices(const WeldedShape& shape, std::span<const int> frameOf,
                                 const std::vector<LooseVertex>& loose) {
  std::vector<int> faceOfVertex(shape.vertexCount(), -1);
  for (int f = 0; f < shape.faceCount(); ++f)
    if (frameOf[f] >= 0)
      for (int v : shape.faces[f])
        if (faceOfVertex[v] < 0) faceOfVertex[v] = f;
  for (const LooseVertex& l : loose) faceOfVertex[l.vertex] = l.anchorFace;
  return faceOfVertex;
}

// Where components are attached, with the points that hold them in every column.
void addAnchors(const std::vector<ComponentPlace>& places, PreviewEmbedding::Input& input) {
  const WeldedShape& shape = input.shape;
  for (const ComponentPlace& place : places) {
    input.anchors.push_back({place.anchorFace, place.contactFace, {}});
    for (int c = 0; c < shape.columns(); ++c) {
      const Quaternion anchor = input.frames[c][place.anchorFrame] * expQuaternion(input.turn(place.anchorFace, c));
      input.anchors.back().pivot.push_back(centroidOf(shape.poses[c], shape.faces[place.anchorFace]) +
                                           anchor * place.offset[c]);
    }
  }
}

// What vertices are embedded by, besides their frames.
struct Parts {
  std::span<const int> placeOf, componentOfFace;
  const std::vector<ComponentPlace>& places;
  const std::vector<LooseVertex>& loose;
  std::function<Vec3(int face, int column)> turn;
  bool logarithmic, wholeFrames;
};

Result<PreviewEmbedding> embed(const WeldedShape& shape, const FramePoses& frames, Parts parts) {
  const std::vector<int> faceOfVertex = facesOfVertices(shape, frames.ofFace, parts.loose);
  std::vector<int> loose;
  for (const LooseVertex& l : parts.loose) loose.push_back(l.vertex);
  PreviewEmbedding::Input input{.shape = shape,
                                .placeOf = parts.placeOf,
                                .faceOfVertex = faceOfVertex,
                                .loose = loose,
                                .frameOf = frames.ofFace,
                                .componentOf = parts.componentOfFace,
                                .frames = frames.rotation,
                                .turn = std::move(parts.turn),
                                .anchors = {},
                                .logarithmic = parts.logarithmic,
                                .wholeFrames = parts.wholeFrames};
  addAnchors(parts.places, input);
  return PreviewEmbedding::create(input);
}

}  // namespace

Result<PreviewEmbedding> makePreview(const EncodedShape& encoded) {
  return encoded.withReconstructor([&](const auto& reconstructor) {
    const auto& lri = reconstructor.coordinates();
    return embed(encoded.shape(), encoded.framePoses(),
                 {reconstructor.placeOf(), reconstructor.componentOfFace(), lri.places, lri.loose,
                  [&](int face, int column) { return lri.face.rotation(face, column); },
                  reconstructor.stretch() == Stretch::Log, false});
  });
}

Result<PreviewEmbedding> makePatchPreview(const PatchedShape& patched) {
  const FramePoses frames = patched.patches.poses();
  const CarriedParts carried = encodeCarriedParts(patched.shape, patched.topology, frames, true);
  std::vector<int> placeOf(patched.shape.vertexCount());
  std::iota(placeOf.begin(), placeOf.end(), 0);
  return embed(patched.shape, frames,
               {placeOf, patched.topology.components.ofFace, carried.places, carried.loose,
                [](int, int) { return Vec3(Vec3::Zero()); }, patched.stretch == Stretch::Log, true});
}

}  // namespace shapespline
