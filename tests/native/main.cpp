// The test runner for all cases in this folder. Takes doctest's options, and --report=FILE for counts and names of
// failed cases as JSON. A case that cannot run (for example, without its data) prints MESSAGE("SKIPPED: <why>") and
// returns. It counts as skipped.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace {

struct Counts {
  int passed = 0;
  std::vector<std::string> failed;
  int skipped = 0;
};
Counts counts;

struct Counter : doctest::IReporter {
  explicit Counter(const doctest::ContextOptions&) {}

  void test_case_start(const doctest::TestCaseData& data) override {
    saidSkipped = false;
    name = data.m_name;
  }
  void log_message(const doctest::MessageData& message) override {
    saidSkipped |= std::strncmp(message.m_string.c_str(), "SKIPPED", 7) == 0;
  }
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    if (stats.failure_flags != 0) return counts.failed.push_back(name);
    ++(saidSkipped ? counts.skipped : counts.passed);
  }

  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  // doctest also calls this for filtered cases, which do not count.
  void test_case_skipped(const doctest::TestCaseData&) override {}

  bool saidSkipped = false;
  std::string name;
};
REGISTER_LISTENER("counts", 1, Counter);

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string listed(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : ",") + quoted(name);
  return "[" + result + "]";
}

bool writeReport(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) return false;
  std::fprintf(file, "{\"passed\":%d,\"failed\":%zu,\"skipped\":%d,\"names\":%s}\n", counts.passed,
               counts.failed.size(), counts.skipped, listed(counts.failed).c_str());
  return std::fclose(file) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  const int result = context.run();
  const std::string option = "--report=";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind(option, 0) == 0 && !writeReport(argument.substr(option.size()))) return 1;
  }
  return result;
}
