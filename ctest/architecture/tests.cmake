add_test(NAME architecture.modules COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_modules.py -v)
add_test(NAME architecture.torment COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_torment.py -v)
add_test(NAME architecture.licences COMMAND ${CMAKE_CURRENT_LIST_DIR}/test_licences.py -v)
set_tests_properties(architecture.modules architecture.torment architecture.licences PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
