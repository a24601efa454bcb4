#include "idiophone/instruments/voices/voice.hpp"

#include <stdexcept>

namespace idiophone::voices {

void Voice::set_detail(std::size_t body, const score::Detail& /*detail*/, std::int64_t /*start*/) {
  throw std::runtime_error("detail: only proxies have levels and priorities; " + bodies().at(body) + " is none");
}

}  // namespace idiophone::voices
