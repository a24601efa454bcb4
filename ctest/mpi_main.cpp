// The main of tests that run under mpirun: every rank runs every test, only rank 0 prints, and one failing rank fails
// all.
#include <gtest/gtest.h>
#include <mpi.h>

int main(int argument_count, char** arguments) {
  MPI_Init(&argument_count, &arguments);
  ::testing::InitGoogleTest(&argument_count, arguments);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) {
    delete listeners.Release(listeners.default_result_printer());
  }
  int failed = RUN_ALL_TESTS();
  if (rank != 0 && failed != 0) {
    std::fprintf(stderr, "tests failed on rank %d\n", rank);
  }
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return failed;
}
