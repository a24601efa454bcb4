# The library of voices for engines (docs/use/engines.md). It is made of the files that LICENSES/MIT_files.txt lists, which other
# modules contain as well, and compiled by itself: so it needs neither MPI nor HDF5 nor any other library at run time.
set(mit_files ${PROJECT_SOURCE_DIR}/LICENSES/MIT_files.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${mit_files})
file(STRINGS ${mit_files} voices_sources REGEX "\\.cpp$")
list(FILTER voices_sources EXCLUDE REGEX "/proxies/") # a library of its own, which programs may link as well
add_library(idiophone_voices_objects OBJECT ${voices_sources})
target_include_directories(idiophone_voices_objects PRIVATE include)
target_link_libraries(idiophone_voices_objects PRIVATE Eigen3::Eigen fmt::fmt-header-only idiophone_flags)
target_compile_definitions(idiophone_voices_objects PRIVATE EIGEN_MPL2_ONLY)
idiophone_unity(idiophone_voices_objects)
foreach(kind IN ITEMS STATIC SHARED) # for C++; for C and languages that call C
  string(TOLOWER ${kind} name)
  add_library(idiophone_voices_${name} ${kind} $<TARGET_OBJECTS:idiophone_voices_objects>)
  set_target_properties(idiophone_voices_${name} PROPERTIES OUTPUT_NAME idiophone_voices LINKER_LANGUAGE CXX
    ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/engines LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/engines)
  target_include_directories(idiophone_voices_${name} INTERFACE include)
endforeach()
target_link_libraries(idiophone_voices_static INTERFACE $<LINK_ONLY:idiophone_proxies>)
target_link_libraries(idiophone_voices_shared PRIVATE $<LINK_ONLY:idiophone_proxies>)
if(IDIOPHONE_SANITIZE)
  target_link_options(idiophone_voices_shared PRIVATE -fsanitize=${IDIOPHONE_SANITIZE})
else()
  target_link_options(idiophone_voices_shared PRIVATE -Wl,--no-undefined) # with a sanitizer, the program has its functions
endif()
