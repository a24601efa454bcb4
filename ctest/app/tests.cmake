# Tests of the whole program: each test_*.py is a ctest, which starts the program under mpirun as a user would.
add_library(collective_counter MODULE app/collective_counter.cpp)
add_library(block_signal MODULE app/block_signal.cpp)
target_link_libraries(collective_counter PRIVATE MPI::MPI_CXX idiophone_flags)
target_link_libraries(block_signal PRIVATE MPI::MPI_CXX idiophone_flags)
list(JOIN IDIOPHONE_MPIRUN " " mpirun)

foreach(name IN ITEMS same_bits stopping wrong_input collectives outputs physics movie table1)
  add_test(NAME app.${name} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/app/test_${name}.py -v)
  set_tests_properties(app.${name} PROPERTIES PROCESSORS 2 TIMEOUT 900 ENVIRONMENT
    "${IDIOPHONE_MPI_ENVIRONMENT};PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>;IDIOPHONE_MPIRUN=${mpirun};\
COLLECTIVE_COUNTER=$<TARGET_FILE:collective_counter>;BLOCK_SIGNAL=$<TARGET_FILE:block_signal>")
endforeach()

# The decks of inputs/table1/fidelity as they are: half an hour of computing.
add_test(NAME long.table1 COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/app/test_table1.py -v)
set_tests_properties(long.table1 PROPERTIES LABELS long PROCESSORS 2 TIMEOUT 14400 ENVIRONMENT
  "${IDIOPHONE_MPI_ENVIRONMENT};PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>;IDIOPHONE_MPIRUN=${mpirun};\
IDIOPHONE_TABLE1=long")
