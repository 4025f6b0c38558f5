// Without a helper, with a late one and with a dead one, every part is done once or an error is reported. Also runs
// under ThreadSanitizer.
#include "core/base/fork_join.h"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "helper_thread.h"

namespace shapespline::test::fork_join_test {

TEST_CASE("forkJoin: without a helper all is done by the caller") {
  ForkJoin forkJoin;
  std::array<int, 2> done = {0, 0};
  for (ForkJoin* someone : {&forkJoin, static_cast<ForkJoin*>(nullptr)})
    inTwo(someone, [&](int part) { ++done[part]; });
  CHECK(done == std::array{2, 2});
  CHECK(forkJoin.helped() == 0);
}

#if SHAPESPLINE_THREADS

using namespace shapespline::test;

TEST_CASE("forkJoin: every part is done once, by the caller or the helper") {
  ForkJoin forkJoin;
  const HelperThread helper(forkJoin);
  std::array<std::vector<int>, 2> done;
  for (auto& list : done) list.reserve(20000);
  for (int i = 0; i < 20000; ++i) inTwo(&forkJoin, [&, i](int part) { done[part].push_back(i); });
  std::vector<int> all(20000);
  std::iota(all.begin(), all.end(), 0);
  CHECK(done[0] == all);
  CHECK(done[1] == all);
  std::atomic<bool> began = false;
  inTwo(&forkJoin, [&](int part) {  // waits until the helper has begun
    if (part == 1) began.store(true);
    else
      while (!began.load()) std::this_thread::yield();
  });
  CHECK(forkJoin.helped() > 0);
}

TEST_CASE("forkJoin: a helper that fails is reported, and the caller continues alone") {
  ForkJoin forkJoin;
  const HelperThread helper(forkJoin);
  std::atomic<bool> began = false;
  CHECK_THROWS_AS(inTwo(&forkJoin,
                        [&](int part) {
                          while (part == 0 && !began.load()) std::this_thread::yield();
                          if (part == 1) began.store(true), throw std::runtime_error("broken");
                        }),
                  std::runtime_error);
  std::array<int, 2> done = {0, 0};
  inTwo(&forkJoin, [&](int part) { ++done[part]; });
  CHECK(done == std::array{1, 1});
}

TEST_CASE(
    "forkJoin: a helper that breaks down before the caller is done is reported as well: its part is half written") {
  ForkJoin forkJoin;
  const HelperThread helper(forkJoin);
  CHECK_THROWS_AS(inTwo(&forkJoin,
                        [&](int part) {
                          if (part == 1 && !forkJoin.lost()) throw std::runtime_error("broken");
                          while (!forkJoin.lost()) std::this_thread::yield();
                        }),
                  std::runtime_error);
}

TEST_CASE("forkJoin: a helper that does not respond is abandoned, and has no later effect") {
  std::atomic<bool> began = false, late = false;
  const auto stuck = [&](int part) {  // must outlive the helper
    if (part == 1) began.store(true);
    while (part == 0 ? !began.load() : !late.load()) std::this_thread::yield();
  };
  ForkJoin forkJoin(2);
  const HelperThread helper(forkJoin);
  CHECK_THROWS_AS(inTwo(&forkJoin, stuck), std::runtime_error);
  std::array<int, 2> done = {0, 0};
  const auto count = [&](int part) { ++done[part]; };
  inTwo(&forkJoin, count);
  late.store(true);
  inTwo(&forkJoin, count);
  CHECK(done == std::array{2, 2});
  CHECK(forkJoin.helped() == 0);
}

#endif

}  // namespace shapespline::test::fork_join_test
