// URIs in files: tests/uri-cases.json. The TypeScript reader of compressed files passes the same cases.
#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/base/uri.h"

namespace shapespline::test::uri_test {
using Json = nlohmann::json;

namespace {

Json sharedCases() {
  std::ifstream file(SHAPESPLINE_SOURCE_DIR "/tests/uri-cases.json");
  return Json::parse(file);
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  return text.replace(text.find(word), word.size(), by);
}

}  // namespace

TEST_CASE("URIs in files lead to a given file or are refused, as in the shared cases") {
  const Json shared = sharedCases();
  for (const Json& one : shared.at("cases")) {
    const auto uri = one.at("uri").get<std::string>();
    const auto from = one.at("from").get<std::string>();
    CAPTURE(uri);
    CAPTURE(from);
    const auto names = one.at("files").get<std::vector<std::string>>();
    std::vector<NamedBytes> files;
    for (const std::string& name : names)
      files.push_back({name, {reinterpret_cast<const std::uint8_t*>(name.data()), name.size()}});
    const auto found = resolveUri(uri, from, SourceFiles(files), "a.gltf");
    const std::string kind = one.value("is", "");
    CHECK(found.ok() == kind.empty());
    if (found.ok() && kind.empty()) {
      CHECK(std::string(found->bytes.begin(), found->bytes.end()) == one.at("finds").get<std::string>());
    } else if (!found.ok() && !kind.empty()) {
      const auto sentence = shared.at("sentences").at(kind).get<std::string>();
      CHECK(found.error().message == replaced(replaced(sentence, "FILE", "a.gltf"), "URI", one.value("said", uri)));
      CHECK((found.error().code == ErrorCode::MissingResource) == (kind == "missing"));
    }
  }
}

}  // namespace shapespline::test::uri_test
