# The Python module, by pytest and mypy, with the program of this build.
set(python_tests deck result sound_map studies notebooks)
if(TARGET idiophone_python)
  list(APPEND python_tests native)
endif()
foreach(name IN LISTS python_tests)
  add_test(NAME python.${name} COMMAND /usr/bin/python3 -m pytest -q -p no:cacheprovider ${CMAKE_CURRENT_SOURCE_DIR}/python/test_${name}.py)
  set_tests_properties(python.${name} PROPERTIES TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT
    "PYTHONDONTWRITEBYTECODE=1;${IDIOPHONE_MPI_ENVIRONMENT};IDIOPHONE=$<TARGET_FILE:idiophone>;PYTHONPATH=${PROJECT_SOURCE_DIR}/python")
endforeach()
add_test(NAME python.types COMMAND mypy --disallow-untyped-defs --disallow-incomplete-defs --warn-unused-ignores --ignore-missing-imports
  --cache-dir ${PROJECT_BINARY_DIR}/mypy ${PROJECT_SOURCE_DIR}/python/idiophone)
