// Runs an input of a fuzzer or a file of the corpus: imports it alone, as both of two keys and with a mesh, and writes
// the result. Aborts if a promise of import.h or export.h is broken.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/export.h"
#include "io/import.h"

namespace shapespline::fuzz {

inline void promise(bool kept, const char* what) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

inline void checkImport(const Import& import) {
  const Keyframes& k = import.keyframes;
  promise(validate(k).ok(), "imported keys are valid");
  const std::size_t n = k.vertexCount();
  promise(k.normals.empty() || k.normals.size() == n, "a normal for every vertex, or none");
  const Seams& seams = import.scene.seams;
  promise(import.scene.uvs.empty() || import.scene.uvs.size() == 2 * (n + seams.copyOf.size()),
          "coordinates for every drawn vertex, or none");
  promise(seams.faces.size() == (seams.copyOf.empty() ? 0 : k.faces.size()),
          "a drawn face for every face where there are copies");
  for (std::size_t f = 0; f < seams.faces.size(); ++f)
    for (int c = 0; c < 3; ++c) {
      const std::size_t v = seams.faces[f][c];
      promise(v < n + seams.copyOf.size() && k.faces[f][c] == (v < n ? static_cast<int>(v) : seams.copyOf[v - n]),
              "drawn faces lie on faces");
    }
  promise(import.scene.colors.empty() || import.scene.colors.size() == 4 * n, "a colour for every vertex, or none");
  for (float v : import.scene.uvs) promise(std::isfinite(v), "finite coordinates");
  for (float v : import.scene.colors) promise(v >= 0 && v <= 1, "colours in [0, 1]");
  int next = 0;
  for (const MaterialGroup& g : import.scene.groups) {
    promise(g.start == next && g.count >= 0, "groups follow each other");
    promise(g.material >= -1 && g.material < static_cast<int>(import.scene.materials.size()), "materials are there");
    next += g.count;
  }
  promise(next == k.faceCount(), "groups cover all faces");
  const int images = static_cast<int>(import.scene.images.size());
  for (const Material& m : import.scene.materials)
    for (int image : {m.baseColorImage, m.metallicRoughnessImage, m.normalImage, m.occlusionImage, m.emissiveImage})
      promise(image >= -1 && image < images, "images are there");
}

// Exports an import and imports that again: same faces, same number of vertices and keys. Small shapes only.
inline void checkRoundTrip(const Import& import) {
  const Keyframes& k = import.keyframes;
  if (k.vertexCount() > 2000 || k.keyCount() > 40) return;
  AnimationSource source;
  source.faces = &k.faces;
  source.scene = &import.scene;
  for (int j = 0; j < k.keyCount(); ++j) source.seconds.push_back(j);
  bool fits = true;  // numbers and their differences fit in float32
  source.frame = [&](int j, std::vector<float>& positions, std::vector<float>& normals) {
    const auto put = [&](const Positions& from, std::vector<float>& to, double largest) {
      to.clear();
      for (const Vec3& p : from)
        for (int c = 0; c < 3; ++c) {
          fits = fits && !(std::abs(p[c]) > largest);
          to.push_back(static_cast<float>(p[c]));
        }
    };
    put(k.keys[j].positions, positions, 1e38);
    put(k.normals, normals, 2);
    return Status();
  };
  const auto written = writeAnimatedGlb(source);
  if (!fits) return;
  promise(written.ok(), "what was imported can be exported");
  const NamedBytes file{"again.glb", *written};
  const auto again = importKeyframes(std::span(&file, 1), {});
  if (!again) {
    // Rounding to float32 can collapse a tiny shape.
    promise(again.error().code == ErrorCode::NoArea, again.error().message.c_str());
    return;
  }
  promise(again->keyframes.faces == k.faces, "faces survive the export");
  promise(again->keyframes.vertexCount() == k.vertexCount(), "vertices survive the export");
  promise(again->keyframes.keyCount() == k.keyCount(), "keys survive the export");
}

inline void checkError(const Error& error) {
  promise(!error.message.empty() && error.message.back() == '.', "an error is a sentence");
  for (char c : error.message) promise(static_cast<unsigned char>(c) >= ' ', "an error is one line");
}

/// A mesh of four vertices for formats without a mesh, such as point caches.
inline std::span<const std::uint8_t> squareObj() {
  static constexpr std::string_view text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// `name` decides the kind if the bytes do not.
inline void oneInput(const std::string& name, std::span<const std::uint8_t> bytes) {
  const NamedBytes alone[] = {{name, bytes}};
  const NamedBytes twice[] = {{name, bytes}, {"second-" + name, bytes}};
  const NamedBytes withMesh[] = {{"square.obj", squareObj()}, {name, bytes}};
  for (std::span<const NamedBytes> files : {std::span<const NamedBytes>(alone), std::span<const NamedBytes>(twice),
                                            std::span<const NamedBytes>(withMesh)}) {
    const auto import = importKeyframes(files, {});
    if (!import) {
      checkError(import.error());
      continue;
    }
    checkImport(*import);
    checkRoundTrip(*import);
  }
}

}  // namespace shapespline::fuzz
