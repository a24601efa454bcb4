# What a builder may choose.
option(BUILD_TESTING "Build the tests and the benchmarks" ON)
option(IDIOPHONE_FUZZ "Build the fuzzer of the readers; the preset fuzz has the compiler and the sanitizers for it" OFF)
set(IDIOPHONE_ARCHITECTURE native CACHE STRING
    "Instruction set the binaries are built for (-march): native, or x86-64-v2, x86-64-v3, ... for portable ones")
set(IDIOPHONE_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")

option(IDIOPHONE_UNITY "Compile all files of a module or a test program as one, because most of the time goes into headers" ON)

add_library(idiophone_flags INTERFACE)
# -Wmaybe-uninitialized raises false alarms inside the AVX-512 header of GCC 12, -Warray-bounds inside its AVX header, and
# -Wstringop-overflow and -Wstringop-overread where GCC 14 inlines Eigen's stores and loads.
# -ffp-contract=fast and the chosen instruction set are the same for every file, so the bits do not depend on the rank.
# Hidden symbols: otherwise libgmsh's calls into Eigen would end up in our own Eigen, whose memory is aligned otherwise.
target_compile_options(idiophone_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> # lets ccache work with precompiled headers
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000> # kB before the compiler collects garbage: 8 % of its time
  -fPIC # the Python module and the plugin are shared objects of these libraries; one flag for all lets tests share headers
  -march=${IDIOPHONE_ARCHITECTURE} -fvisibility=hidden -ffp-contract=fast -fno-math-errno -fno-trapping-math
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-psabi -Wno-unknown-warning-option -Wno-maybe-uninitialized
  -Wno-array-bounds
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-stringop-overflow$<SEMICOLON>-Wno-stringop-overread>)
if(IDIOPHONE_SANITIZE)
  target_compile_options(idiophone_flags INTERFACE
    -fsanitize=${IDIOPHONE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer) # each report ends the program
  target_link_options(idiophone_flags INTERFACE -fsanitize=${IDIOPHONE_SANITIZE})
endif()
