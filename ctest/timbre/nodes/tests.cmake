idiophone_test(timbre/nodes LINKS idiophone_language MPI::MPI_CXX)
target_include_directories(test_nodes PRIVATE timbre/language)
