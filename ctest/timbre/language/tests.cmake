idiophone_test(timbre/language LINKS MPI::MPI_CXX)
