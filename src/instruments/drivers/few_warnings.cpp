#include "idiophone/instruments/drivers/few_warnings.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

namespace idiophone::drivers {

void FewWarnings::warn(std::string text) {
  if (++count_ > most) {
    return;
  }
  const auto controls = [](unsigned char code) { return (code < 0x20 && code != '\n') || code >= 0x7f; };
  std::ranges::replace_if(text, controls, '?');
  spdlog::warn("{}{}", text, count_ == most ? " (more warnings of this kind are only counted)" : "");
}

}  // namespace idiophone::drivers
