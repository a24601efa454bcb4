# The Python module, by pytest and mypy, with the program of this build.
foreach(name IN ITEMS deck result sound_map studies notebooks)
  add_test(NAME python.${name} COMMAND /usr/bin/python3 -m pytest -q -p no:cacheprovider ${CMAKE_CURRENT_SOURCE_DIR}/python/test_${name}.py)
  set_tests_properties(python.${name} PROPERTIES TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT
    "PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>;PYTHONPATH=${PROJECT_SOURCE_DIR}/python")
endforeach()
add_test(NAME python.types COMMAND mypy --disallow-untyped-defs --disallow-incomplete-defs --warn-unused-ignores --ignore-missing-imports
  --cache-dir ${PROJECT_BINARY_DIR}/mypy ${PROJECT_SOURCE_DIR}/python/idiophone)
