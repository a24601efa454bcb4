#include "idiophone/instruments/voices/voice.hpp"

#include <algorithm>
#include <stdexcept>

namespace idiophone::voices {

void Waits::add(const Waits& others) {
  const auto before = static_cast<double>(count), more = static_cast<double>(others.count);
  if (others.count > 0) {
    mean = (before * mean + more * others.mean) / (before + more);
  }
  count += others.count;
  longest = std::max(longest, others.longest);
}

void Voice::require_touchable(std::size_t body) const {
  throw std::runtime_error("only sound maps feel bows and mallets; " + bodies().at(body) + " is none");
}

void Voice::set_detail(std::size_t body, const score::Detail& /*detail*/, std::int64_t /*start*/) {
  throw std::runtime_error("detail: only proxies have levels and priorities; " + bodies().at(body) + " is none");
}

}  // namespace idiophone::voices
