add_test(NAME house.rooms COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/house/test_rooms.py -v)
set_tests_properties(house.rooms PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
