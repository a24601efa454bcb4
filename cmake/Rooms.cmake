# Headers of other libraries that most files include. They are compiled once for all rooms, and once for all tests.
set(IDIOPHONE_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numbers> <numeric> <optional> <span>
    <stdexcept> <string> <vector> <Eigen/Geometry> <Eigen/LU> <fmt/format.h>)
file(CONFIGURE OUTPUT headers.cpp CONTENT "")
add_library(idiophone_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
target_precompile_headers(idiophone_headers PRIVATE ${IDIOPHONE_HEADERS})
target_link_libraries(idiophone_headers PRIVATE Eigen3::Eigen idiophone_flags)
target_link_libraries(idiophone_flags INTERFACE fmt::fmt) # its headers are compiled with a macro that all files then need

# Eight files of a target are compiled as one, because most of the time goes into headers.
function(idiophone_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${IDIOPHONE_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# A room of the house is a static library made of src/<room>/*.cpp; what it shows is include/idiophone/<room>/.
# USES names rooms it may call, LINKS outside libraries. In a room with ONE_FILE_AT_A_TIME the bits would depend on which
# functions of the room the compiler can inline.
function(idiophone_room room)
  cmake_parse_arguments(ROOM "ONE_FILE_AT_A_TIME" "" "USES;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
  list(TRANSFORM ROOM_USES PREPEND idiophone_)
  add_library(idiophone_${room} STATIC ${sources})
  target_include_directories(idiophone_${room} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(idiophone_${room} PUBLIC ${ROOM_USES} ${ROOM_LINKS} PRIVATE idiophone_flags)
  target_precompile_headers(idiophone_${room} REUSE_FROM idiophone_headers)
  if(NOT ROOM_ONE_FILE_AT_A_TIME)
    idiophone_unity(idiophone_${room})
  endif()
endfunction()

# A program made of src/NAME.cpp.
function(idiophone_program name)
  cmake_parse_arguments(PROGRAM "" "" "USES;LINKS" ${ARGN})
  list(TRANSFORM PROGRAM_USES PREPEND idiophone_)
  add_executable(${name} ${PROJECT_SOURCE_DIR}/src/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${PROGRAM_USES} ${PROGRAM_LINKS} idiophone_flags)
endfunction()

# Puts the files of src/ROOM/page into the room, by src/ROOM/page_files.cpp.in. OTHER/FILE is a file of src/OTHER/page.
function(idiophone_embed_page room)
  foreach(file IN LISTS ARGN)
    get_filename_component(owner ${file} DIRECTORY)
    get_filename_component(file ${file} NAME)
    if(NOT owner)
      set(owner ${room})
    endif()
    set(path ${PROJECT_SOURCE_DIR}/src/${owner}/page/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    string(TOUPPER ${room} prefix)
    string(MAKE_C_IDENTIFIER ${file} name)
    file(READ ${path} ${prefix}_${name})
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/src/${room}/page_files.cpp.in ${PROJECT_BINARY_DIR}/${room}/page_files.cpp @ONLY)
  target_sources(idiophone_${room} PRIVATE ${PROJECT_BINARY_DIR}/${room}/page_files.cpp)
  target_include_directories(idiophone_${room} PRIVATE ${PROJECT_SOURCE_DIR}/src/${room})
endfunction()
