// Replays the fuzzers' corpus and all their findings.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "../fuzz/one_input.h"

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> filesUnder(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".md" && entry.path().extension() != ".mjs")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("corpus and findings of the fuzzers") {
  const fs::path root = fs::path(SHAPESPLINE_SOURCE_DIR) / "tests" / "fuzz";
  std::vector<fs::path> files = filesUnder(root / "corpus");
  REQUIRE(files.size() > 40);
  const auto found = filesUnder(root / "found");
  files.insert(files.end(), found.begin(), found.end());
  for (const fs::path& file : files) {
    CAPTURE(file.string());
    std::ifstream stream(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    const auto start = std::chrono::steady_clock::now();
    shapespline::fuzz::oneInput(file.filename().string(), bytes);  // aborts on a defect
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    CHECK(took.count() < 60);  // detects hangs, not slowness
  }
}
