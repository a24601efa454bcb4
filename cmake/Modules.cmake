# Headers of other libraries that most files include. They are compiled once for all modules, and once for all tests.
set(IDIOPHONE_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <numbers> <numeric> <optional> <span>
    <stdexcept> <string> <vector> <Eigen/Geometry> <Eigen/LU> <fmt/format.h>)
file(CONFIGURE OUTPUT headers.cpp CONTENT "")
add_library(idiophone_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
target_precompile_headers(idiophone_headers PRIVATE ${IDIOPHONE_HEADERS})
target_link_libraries(idiophone_headers PRIVATE Eigen3::Eigen idiophone_flags)
target_link_libraries(idiophone_flags INTERFACE fmt::fmt) # its headers are compiled with a macro that all files then need

# All files of a target are compiled as one, because most of the time goes into headers and the templates that they need.
function(idiophone_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${IDIOPHONE_UNITY} UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# A module is a static library made of src/<folder>/*.cpp; what it shows is include/idiophone/<folder>/. The folder is
# LAYER/MODULE, or LAYER for a layer of one module. USES names modules it may call, USES_INSIDE modules that its headers do
# not show, LINKS outside libraries. Without the optional package that it NEEDS, there is no such module. In a module with ONE_FILE_AT_A_TIME the bits would depend on which functions of the
# module the compiler can inline.
function(idiophone_module folder)
  cmake_parse_arguments(MODULE "ONE_FILE_AT_A_TIME" "NEEDS" "USES;USES_INSIDE;LINKS" ${ARGN})
  if(MODULE_NEEDS AND NOT IDIOPHONE_HAS_${MODULE_NEEDS})
    return()
  endif()
  get_filename_component(module ${folder} NAME)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
  list(TRANSFORM MODULE_USES PREPEND idiophone_)
  list(TRANSFORM MODULE_USES_INSIDE PREPEND idiophone_)
  add_library(idiophone_${module} STATIC ${sources})
  target_include_directories(idiophone_${module} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(idiophone_${module} PUBLIC ${MODULE_USES} ${MODULE_LINKS} PRIVATE ${MODULE_USES_INSIDE} idiophone_flags)
  target_precompile_headers(idiophone_${module} REUSE_FROM idiophone_headers)
  if(NOT MODULE_ONE_FILE_AT_A_TIME)
    idiophone_unity(idiophone_${module})
  endif()
endfunction()

# A program made of src/NAME.cpp. Before its other code runs, instruction_set.cpp looks whether this processor can run it.
set_source_files_properties(src/instruction_set.cpp src/missing_instructions.cpp src/idiophone_lv2.cpp
                            PROPERTIES COMPILE_OPTIONS -march=x86-64)
function(idiophone_program name)
  cmake_parse_arguments(PROGRAM "" "" "USES;LINKS" ${ARGN})
  list(TRANSFORM PROGRAM_USES PREPEND idiophone_)
  add_executable(${name} ${PROJECT_SOURCE_DIR}/src/${name}.cpp ${PROJECT_SOURCE_DIR}/src/built_for.cpp
    ${PROJECT_SOURCE_DIR}/src/instruction_set.cpp ${PROJECT_SOURCE_DIR}/src/missing_instructions.cpp)
  target_link_libraries(${name} PRIVATE ${PROGRAM_USES} ${PROGRAM_LINKS} idiophone_flags)
endfunction()

# The LV2 plugin: a folder of its description and of two shared objects, as hosts look for it. The first one refuses a
# processor that can't run the second one.
function(idiophone_lv2_bundle)
  set(bundle ${PROJECT_BINARY_DIR}/lv2/idiophone.lv2)
  add_library(idiophone_lv2 MODULE src/idiophone_lv2.cpp src/missing_instructions.cpp src/built_for.cpp)
  target_link_libraries(idiophone_lv2 PRIVATE PkgConfig::LV2 ${CMAKE_DL_LIBS} idiophone_flags)
  add_library(idiophone_lv2_code MODULE src/idiophone_lv2_code.cpp)
  target_link_libraries(idiophone_lv2_code PRIVATE idiophone_plugin idiophone_flags)
  set_target_properties(idiophone_lv2 PROPERTIES OUTPUT_NAME idiophone)
  set_target_properties(idiophone_lv2_code PROPERTIES OUTPUT_NAME idiophone_code)
  foreach(object IN ITEMS idiophone_lv2 idiophone_lv2_code)
    # A host has libraries of its own: it sees one name of this one.
    target_link_options(${object} PRIVATE -Wl,--as-needed -Wl,--exclude-libs,ALL -Wl,--no-undefined)
    set_target_properties(${object} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${bundle})
  endforeach()
  add_dependencies(idiophone_lv2 idiophone_lv2_code)
  foreach(description IN ITEMS manifest.ttl idiophone.ttl)
    configure_file(${PROJECT_SOURCE_DIR}/src/plugin/bundle/${description} ${bundle}/${description} COPYONLY)
  endforeach()
endfunction()

# Puts files of src/ into a module, by its MODULE_KIND_files.cpp.in.
function(idiophone_embed folder kind)
  get_filename_component(module ${folder} NAME)
  foreach(file IN LISTS ARGN)
    set(path ${PROJECT_SOURCE_DIR}/src/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    string(TOUPPER ${module} prefix)
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} name)
    file(READ ${path} ${prefix}_${name})
  endforeach()
  set(files ${PROJECT_BINARY_DIR}/${module}/${module}_${kind}_files.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/src/${folder}/${module}_${kind}_files.cpp.in ${files} @ONLY)
  target_sources(idiophone_${module} PRIVATE ${files})
  target_include_directories(idiophone_${module} PRIVATE ${PROJECT_SOURCE_DIR}/src/${folder})
endfunction()

# The files of a module's folder page/. FOLDER/FILE is a file of the page of another module's folder.
function(idiophone_embed_page folder)
  foreach(file IN LISTS ARGN)
    get_filename_component(owner ${file} DIRECTORY)
    get_filename_component(file ${file} NAME)
    if(NOT owner)
      set(owner ${folder})
    endif()
    list(APPEND files ${owner}/page/${file})
  endforeach()
  idiophone_embed(${folder} page ${files})
endfunction()
