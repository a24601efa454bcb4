# The Blender add-on, in Blender without a window and in a window of Xvfb. scripts/install_dependencies blender installs both; without
# Blender the test is skipped.
add_test(NAME blender.add_on COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/blender/test_add_on.py -v)
set_tests_properties(blender.add_on PROPERTIES LABELS blender TIMEOUT ${IDIOPHONE_TIME_LIMIT} ENVIRONMENT
  "PYTHONDONTWRITEBYTECODE=1;IDIOPHONE=$<TARGET_FILE:idiophone>" SKIP_REGULAR_EXPRESSION "Blender is not installed")
