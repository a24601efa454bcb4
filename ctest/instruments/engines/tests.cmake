idiophone_test(instruments/engines LINKS idiophone_drivers ${CMAKE_DL_LIBS})
target_sources(test_engines PRIVATE plugin/strictness.cpp)
target_include_directories(test_engines PRIVATE plugin instruments/proxies ${PROJECT_SOURCE_DIR}/src/instruments/touching)

# As an engine that is written in C sees the library; ctest/app/test_install.py starts it.
add_executable(voices_in_c instruments/engines/voices_in_c.c)
set_target_properties(voices_in_c PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(voices_in_c PRIVATE -Wall -Wextra -Wpedantic -Werror)
target_link_libraries(voices_in_c PRIVATE idiophone_voices_shared m)
if(IDIOPHONE_SANITIZE)
  target_link_options(voices_in_c PRIVATE -fsanitize=${IDIOPHONE_SANITIZE})
endif()
