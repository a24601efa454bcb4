# The modes, bows and contacts of the Sonic Explorer in WebAssembly, from the same files as those of `play`. clang makes it with WASI's
# libraries (scripts/install_dependencies webassembly). The emscripten of Debian 12 can't: its standard library lacks the
# algorithms of std::ranges.
set(IDIOPHONE_WEBASSEMBLY AUTO CACHE STRING "Give the Sonic Explorer WebAssembly: ON, OFF, or AUTO (if clang makes it)")
set_property(CACHE IDIOPHONE_WEBASSEMBLY PROPERTY STRINGS AUTO ON OFF)

set(webassembly ${PROJECT_BINARY_DIR}/webassembly)
set(sources damped_oscillator smooth_rise bow resonator_bank chosen_groups bodies_in_contact contact_forces point_contacts
  stretched_modes force running_stroke)
list(TRANSFORM sources PREPEND resonators/)
list(APPEND sources score/score_values touching/contact_track touching/led_stroke touching/surface_pair touching/contact_sounds
  page_sound/page_bow page_sound/page_body page_sound/page_contacts page_sound/exports)
list(TRANSFORM sources PREPEND instruments/)
list(APPEND sources foundation/friction/elasto_plastic_friction foundation/stretching/stretching_energy
  foundation/stretching/stretching_order scene/course scene/bowing)
list(TRANSFORM sources REPLACE "(.+)" "#include \"${PROJECT_SOURCE_DIR}/src/\\1.cpp\"")
list(JOIN sources "\n" sources)
file(CONFIGURE OUTPUT ${webassembly}/all.cpp CONTENT "${sources}\n")

# The standard library: the oldest that works, because the newest may be too new for the compiler.
find_program(IDIOPHONE_WASM_CLANG NAMES clang++ clang++-19)
set(compile ${IDIOPHONE_WASM_CLANG} --target=wasm32-wasi -msimd128 -std=c++20 -O3 -DNDEBUG -fno-exceptions -fno-rtti -nostdinc++ -c)
set(link ${IDIOPHONE_WASM_CLANG} --target=wasm32-wasi -mexec-model=reactor -Wl,--strip-all)
function(idiophone_find_wasm_library)
  file(WRITE ${webassembly}/probe.cpp "#include <algorithm>\n#include <array>\n#include <complex>\n"
    "std::array<std::complex<double>, 2> list;\nvoid probe() { std::ranges::fill(list, std::exp(list[0])); }\n")
  file(GLOB libraries LIST_DIRECTORIES true /usr/lib/llvm-*/include/wasm32-wasi/c++/v1)
  list(SORT libraries COMPARE NATURAL)
  foreach(library IN LISTS libraries)
    execute_process(COMMAND ${compile} -isystem ${library} probe.cpp -o probe.o WORKING_DIRECTORY ${webassembly}
      RESULT_VARIABLE compiled OUTPUT_QUIET ERROR_QUIET)
    execute_process(COMMAND ${link} probe.o -o probe.wasm WORKING_DIRECTORY ${webassembly}
      RESULT_VARIABLE linked OUTPUT_QUIET ERROR_QUIET)
    if(compiled EQUAL 0 AND linked EQUAL 0)
      set(IDIOPHONE_WASM_LIBRARY ${library} CACHE INTERNAL "Headers of the standard library for WebAssembly")
      return()
    endif()
  endforeach()
endfunction()
if(IDIOPHONE_WEBASSEMBLY AND IDIOPHONE_WASM_CLANG AND NOT IDIOPHONE_WASM_LIBRARY)
  idiophone_find_wasm_library()
endif()

set(code ${webassembly}/modes.wasm)
if(IDIOPHONE_WEBASSEMBLY AND IDIOPHONE_WASM_LIBRARY)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_custom_command(OUTPUT ${code} DEPENDS ${webassembly}/all.cpp DEPFILE ${webassembly}/all.d VERBATIM
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${compile} -isystem ${IDIOPHONE_WASM_LIBRARY} -isystem ${eigen} -I${PROJECT_SOURCE_DIR}/include
      -Wall -Wextra -Werror ${webassembly}/all.cpp -o ${webassembly}/all.o -MD -MF ${webassembly}/all.d -MT ${code}
    COMMAND ${link} ${webassembly}/all.o -o ${code})
elseif(IDIOPHONE_WEBASSEMBLY STREQUAL ON)
  message(FATAL_ERROR "IDIOPHONE_WEBASSEMBLY is ON, but clang makes no WebAssembly here: scripts/install_dependencies webassembly")
else()
  file(CONFIGURE OUTPUT ${code} CONTENT "")
  message(NOTICE "Without WebAssembly (IDIOPHONE_WEBASSEMBLY is ${IDIOPHONE_WEBASSEMBLY}): the Sonic Explorer has no bow, lets nothing fall, has small vibrations only, and computes "
    "modes in JavaScript, far fewer in real time. Its packages: scripts/install_dependencies webassembly")
endif()

set(embedded ${webassembly}/explorer_webassembly.cpp)
set(template ${PROJECT_SOURCE_DIR}/src/instruments/explorer/explorer_webassembly.cpp.in)
add_custom_command(OUTPUT ${embedded} DEPENDS ${code} ${template} ${PROJECT_SOURCE_DIR}/cmake/EmbedBytes.cmake VERBATIM
  COMMAND ${CMAKE_COMMAND} -DFILE=${code} -DTEMPLATE=${template} -DOUTPUT=${embedded} -P ${PROJECT_SOURCE_DIR}/cmake/EmbedBytes.cmake)
set_source_files_properties(${embedded} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # a long text
target_sources(idiophone_explorer PRIVATE ${embedded})
