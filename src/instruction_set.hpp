#pragma once
// The instructions beyond the first x86-64 that a compiler may use: a number, the name that compilers have for them,
// and the macro that they define where they use them.

#define IDIOPHONE_INSTRUCTIONS(entry)                                                                             \
  entry(0, "sse3", __SSE3__) entry(1, "ssse3", __SSSE3__) entry(2, "sse4.1", __SSE4_1__)                          \
      entry(3, "sse4.2", __SSE4_2__) entry(4, "popcnt", __POPCNT__) entry(5, "avx", __AVX__)                      \
          entry(6, "avx2", __AVX2__) entry(7, "fma", __FMA__) entry(8, "bmi", __BMI__) entry(9, "bmi2", __BMI2__) \
              entry(10, "avx512f", __AVX512F__) entry(11, "avx512vl", __AVX512VL__)                               \
                  entry(12, "avx512bw", __AVX512BW__) entry(13, "avx512dq", __AVX512DQ__)                         \
                      entry(14, "avx512cd", __AVX512CD__) entry(15, "avx512vbmi", __AVX512VBMI__)                 \
                          entry(16, "avx512ifma", __AVX512IFMA__) entry(17, "avx512vbmi2", __AVX512VBMI2__)       \
                              entry(18, "avx512vnni", __AVX512VNNI__) entry(19, "avx512bitalg", __AVX512BITALG__) \
                                  entry(20, "avx512vpopcntdq", __AVX512VPOPCNTDQ__)

constexpr int idiophone_instruction_count = 21;

/// Bit n is set if the program was compiled for entry n.
extern const unsigned idiophone_built_for;
