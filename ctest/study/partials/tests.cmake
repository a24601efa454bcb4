idiophone_test(study/partials)
add_test(NAME partials.pictures
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_LIST_DIR}/pictures.py ${PROJECT_SOURCE_DIR}/scripts)
set_tests_properties(partials.pictures PROPERTIES TIMEOUT 120)
