#include "idiophone/instruments/outputs/collected.hpp"

#include <algorithm>

namespace idiophone::outputs {

void Collected::start(Renderer& renderer) {
  renderer_ = &renderer;
  sound_.reserve(static_cast<std::size_t>(left_) * renderer.receivers());
}

bool Collected::advance() {
  const std::int64_t count = std::min(block_, left_);
  const std::size_t before = sound_.size();
  sound_.resize(before + static_cast<std::size_t>(count) * renderer_->receivers());
  renderer_->render(std::span(sound_).subspan(before), 0);
  left_ -= count;
  return left_ > 0;
}

}  // namespace idiophone::outputs
