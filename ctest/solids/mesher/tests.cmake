# The program idiophone_gmsh, as the module mesh starts it.
file(GLOB mesher_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/solids/mesher/*.cpp)
add_executable(test_mesher ${mesher_tests})
idiophone_unity(test_mesher)
target_link_libraries(test_mesher PRIVATE idiophone_mesh idiophone_web gmsh PkgConfig::ASSIMP GTest::gtest_main GTest::gmock idiophone_flags)
target_include_directories(test_mesher PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/solids/mesh ${CMAKE_CURRENT_SOURCE_DIR}/support)
target_compile_definitions(test_mesher PRIVATE IDIOPHONE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_dependencies(test_mesher idiophone_gmsh)
gtest_discover_tests(test_mesher TEST_PREFIX mesher. DISCOVERY_TIMEOUT 60)

# Ordinary parts through `idiophone check`: a few of each format, and, as a long test, all of them at three sizes.
add_test(NAME mesher.parts COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_parts.py 0.012 --only
  box.step,tuning_fork.step,funnel.brep,scan.stl,knot.obj,refused_open_scan.stl,refused_cut.step)
add_test(NAME mesher.parts_long COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_parts.py 0.02 0.012 0.006)
add_test(NAME mesher.repaired_modes COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_repaired_modes.py)
set_tests_properties(mesher.parts mesher.parts_long mesher.repaired_modes PROPERTIES TIMEOUT 600 ENVIRONMENT
  "${IDIOPHONE_MPI_ENVIRONMENT};PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>")
set_tests_properties(mesher.parts_long mesher.repaired_modes PROPERTIES LABELS long TIMEOUT 3600)
