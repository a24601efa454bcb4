add_test(NAME house.rooms COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/house/test_rooms.py -v)
add_test(NAME house.torment COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/house/test_torment.py -v)
set_tests_properties(house.rooms house.torment PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
