// Checks that native and wasm agree. Both must match the shapes in tests/native-shapes.json;
// tests/engine/agreement.test.ts checks wasm.
#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sequences.h"
#include "shapes.h"

namespace shapespline::test::agreement_test {
using Json = nlohmann::json;

namespace {

Json sharedShapes() {
  std::ifstream file(SHAPESPLINE_SOURCE_DIR "/tests/native-shapes.json");
  return Json::parse(file);
}

template <class Real>
Keyframes keysOf(const Json& shared) {
  Keyframes keyframes;
  const auto faces = shared.at("faces").get<std::vector<int>>();
  for (std::size_t i = 0; i < faces.size(); i += 3) keyframes.faces.push_back({faces[i], faces[i + 1], faces[i + 2]});
  for (const Json& key : shared.at("keys")) {
    const auto numbers = key.get<std::vector<double>>();
    Positions positions;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      positions.push_back(Vec3(numbers[i], numbers[i + 1], numbers[i + 2]).cast<Real>().template cast<double>());
    keyframes.keys.push_back({"key", static_cast<double>(keyframes.keys.size()), std::move(positions)});
  }
  return keyframes;
}

// Every 12th vertex, one list per time.
std::vector<std::vector<double>> shapesOf(Keyframes keyframes, const Json& shared) {
  EncodingOptions encoding;
  encoding.precision = Precision::Double;
  Sequence sequence = sequenceOf(std::move(keyframes), encoding);
  std::vector<std::vector<double>> shapes;
  for (const double t : shared.at("times")) {
    const Positions positions = shapeAt(sequence, t);
    shapes.emplace_back();
    for (std::size_t i = 0; i < positions.size(); i += shared.at("every").get<std::size_t>())
      for (const double x : positions[i]) shapes.back().push_back(x);
  }
  return shapes;
}

double farthest(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  if (a.size() != b.size()) return INFINITY;
  double far = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].size() != b[k].size()) return INFINITY;
    for (std::size_t i = 0; i < a[k].size(); ++i) far = std::max(far, std::abs(a[k][i] - b[k][i]));
  }
  return far;
}

}  // namespace

TEST_CASE("agreement: native shapes of keys in float match those required of wasm") {
  const Json shared = sharedShapes();
  const double diagonal = diagonalOf(keysOf<float>(shared));
  const auto shapes = shapesOf(keysOf<float>(shared), shared);
  const auto expected = shared.at("shapes").get<std::vector<std::vector<double>>>();
  CHECK_MESSAGE(farthest(shapes, expected) < 1e-9 * diagonal, "native: ", Json(shapes).dump());
  // The keys before rounding, which the engine never receives.
  CHECK(farthest(shapesOf(keysOf<double>(shared), shared), expected) > 1e-6 * diagonal);
}

}  // namespace shapespline::test::agreement_test
