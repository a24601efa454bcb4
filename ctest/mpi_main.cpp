// The main of tests that run under mpirun: every rank runs every test that is declared for so many ranks
// (support/ranks.hpp), only rank 0 prints, and one failing rank fails all.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "ranks.hpp"

namespace {

/// By the last declaration above the test in its file.
bool runs_on(int ranks, const testing::TestInfo& test) {
  const idiophone::support::RanksDeclaration* found = nullptr;
  for (const auto& declaration : idiophone::support::ranks_declarations()) {
    if (declaration.file == test.file() && declaration.line < test.line() &&
        (found == nullptr || found->line < declaration.line)) {
      found = &declaration;
    }
  }
  if (found == nullptr) {
    std::fprintf(stderr, "%s:%d: there is no ON_RANKS(...) above this test\n", test.file(), test.line());
    std::exit(1);
  }
  return std::ranges::find(found->ranks, ranks) != found->ranks.end();
}

/// Leaves out the tests that are not for so many ranks.
void choose_tests(int ranks) {
  std::string others;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      if (!runs_on(ranks, test)) {
        others += std::string(":") + suite.name() + "." + test.name();
      }
    }
  }
  if (!others.empty()) {
    std::string filter = GTEST_FLAG_GET(filter);  // WANTED:... or WANTED:...-UNWANTED:...
    filter += filter.find('-') == std::string::npos ? "-" : "";
    filter += others;
    GTEST_FLAG_SET(filter, filter);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  MPI_Init(&argument_count, &arguments);
  ::testing::InitGoogleTest(&argument_count, arguments);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  choose_tests(ranks);
  auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) {
    delete listeners.Release(listeners.default_result_printer());
  }
  int failed = RUN_ALL_TESTS();
  if (testing::UnitTest::GetInstance()->test_to_run_count() == 0) {
    std::fprintf(stderr, "no test is declared for %d ranks\n", ranks);
    failed = 1;
  }
  if (rank != 0 && failed != 0) {
    std::fprintf(stderr, "tests failed on rank %d\n", rank);
  }
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed;
}
