idiophone_test(analysis)
add_test(NAME analysis.pictures
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/pictures.py ${PROJECT_SOURCE_DIR}/scripts)
set_tests_properties(analysis.pictures PROPERTIES TIMEOUT 120)
