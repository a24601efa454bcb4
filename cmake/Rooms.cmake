# A room of the house is a static library made of src/<room>/*.cpp; what it shows is include/idiophone/<room>/.
# USES names rooms it may call, LINKS outside libraries.
function(idiophone_room room)
  cmake_parse_arguments(ROOM "" "" "USES;LINKS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
  list(TRANSFORM ROOM_USES PREPEND idiophone_)
  add_library(idiophone_${room} STATIC ${sources})
  target_include_directories(idiophone_${room} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(idiophone_${room} PUBLIC ${ROOM_USES} ${ROOM_LINKS} PRIVATE idiophone_flags)
endfunction()

# A program made of src/NAME.cpp.
function(idiophone_program name)
  cmake_parse_arguments(PROGRAM "" "" "USES;LINKS" ${ARGN})
  list(TRANSFORM PROGRAM_USES PREPEND idiophone_)
  add_executable(${name} ${PROJECT_SOURCE_DIR}/src/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${PROGRAM_USES} ${PROGRAM_LINKS} idiophone_flags)
endfunction()
