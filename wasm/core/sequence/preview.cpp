#include "core/sequence/preview.h"

#include <span>
#include <vector>

namespace shapespline {

namespace {

// Of each vertex the first face with a frame; -1 for loose vertices.
std::vector<int> facesOfHeldVertices(const WeldedShape& shape, std::span<const int> frameOf) {
  std::vector<int> faceOfVertex(shape.vertexCount(), -1);
  for (int f = 0; f < shape.faceCount(); ++f)
    if (frameOf[f] >= 0)
      for (int v : shape.faces[f])
        if (faceOfVertex[v] < 0) faceOfVertex[v] = f;
  return faceOfVertex;
}

// Where components are attached, with the points that hold them in every column.
template <class Real>
std::vector<EmbeddedPlace> anchorsOf(const WeldedShape& shape, const FramePoses& frames,
                                     const LriCoordinates<Real>& lri) {
  std::vector<EmbeddedPlace> anchors;
  for (const ComponentPlace& place : lri.places) {
    anchors.push_back({place.anchorFace, place.contactFace, {}});
    for (int c = 0; c < shape.columns(); ++c) {
      const Quaternion anchor =
          frames.rotation[c][place.anchorFrame] * expQuaternion(lri.face.rotation(place.anchorFace, c));
      anchors.back().pivot.push_back(centroidOf(shape.poses[c], shape.faces[place.anchorFace]) +
                                     anchor * place.offset[c]);
    }
  }
  return anchors;
}

template <class Real>
Result<PreviewEmbedding> makePreview(const WeldedShape& shape, const FramePoses& frames,
                                     const Reconstructor<Real>& reconstructor) {
  const LriCoordinates<Real>& lri = reconstructor.coordinates();
  std::vector<int> faceOfVertex = facesOfHeldVertices(shape, frames.ofFace);
  std::vector<int> loose;
  for (const LooseVertex& l : lri.loose) {
    faceOfVertex[l.vertex] = l.anchorFace;
    loose.push_back(l.vertex);
  }
  return PreviewEmbedding::create({
      .shape = shape,
      .placeOf = reconstructor.placeOf(),
      .faceOfVertex = faceOfVertex,
      .loose = loose,
      .frameOf = frames.ofFace,
      .componentOf = reconstructor.componentOfFace(),
      .frames = frames.rotation,
      .turn = [&](int face, int column) { return lri.face.rotation(face, column); },
      .anchors = anchorsOf(shape, frames, lri),
      .logarithmic = reconstructor.stretch() == Stretch::Log,
  });
}

}  // namespace

Result<PreviewEmbedding> makePreview(const EncodedShape& encoded) {
  return encoded.withReconstructor(
      [&](const auto& reconstructor) { return makePreview(encoded.shape(), encoded.framePoses(), reconstructor); });
}

}  // namespace shapespline
