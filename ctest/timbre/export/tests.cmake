idiophone_test(timbre/export LINKS MPI::MPI_CXX)
target_include_directories(test_export PRIVATE timbre/language)
