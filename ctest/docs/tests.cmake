# The documentation refers to files, sections and pages that exist.
add_test(NAME docs.references COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_docs.py -v)
set_tests_properties(docs.references PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
