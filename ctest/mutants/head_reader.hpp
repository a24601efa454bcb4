#pragma once
// What the program reads of the head of a binaural listener, for mutants and for tools/fuzz.

#include "idiophone/air/receivers/head_responses.hpp"

namespace idiophone::mutants {

/// Reads a SOFA file as a listener with a head does, and some of its responses.
inline void read_head(const std::filesystem::path& file) {
  const receivers::HeadResponses head(file, 44100);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(head.count()); i += 50) {
    static_cast<void>(head.responses(head.nearest(head.direction(i))));
  }
}

}  // namespace idiophone::mutants
