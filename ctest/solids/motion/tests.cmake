idiophone_test(solids/motion RANKS 1 LINKS idiophone_test_support idiophone_petsc_environment)

foreach(ranks 2 3)
  add_test(NAME motion.exchange.ranks${ranks}
    COMMAND ${IDIOPHONE_MPIRUN} -n ${ranks} $<TARGET_FILE:test_motion> --gtest_filter=*VelocityExchange*)
  set_tests_properties(motion.exchange.ranks${ranks} PROPERTIES
    PROCESSORS ${ranks} TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT "${IDIOPHONE_MPI_ENVIRONMENT}")
endforeach()
