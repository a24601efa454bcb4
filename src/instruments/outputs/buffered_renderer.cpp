#include "idiophone/instruments/outputs/buffered_renderer.hpp"

#include <algorithm>
#include <chrono>

namespace idiophone::outputs {

BufferedRenderer::BufferedRenderer(Fill fill, int rate, std::size_t frames, std::size_t buffers, std::size_t channels)
    : fill_(std::move(fill)),
      rate_(rate),
      channels_(channels),
      buffers_(buffers, std::vector<double>(frames * channels)) {
  while (filled_ < buffers) {
    fill_next();
  }
  thread_ = std::thread([this] { fill_all(); });
}

BufferedRenderer::~BufferedRenderer() {
  ends_ = true;
  thread_.join();
}

void BufferedRenderer::fill_next() {
  const std::size_t number = filled_.load(std::memory_order_relaxed);
  fill_(buffers_[number % buffers_.size()]);
  filled_.store(number + 1, std::memory_order_release);
}

void BufferedRenderer::fill_all() {
  constexpr auto pause = std::chrono::microseconds(200);
  while (!ends_) {
    if (filled_.load(std::memory_order_relaxed) - played_.load(std::memory_order_acquire) < buffers_.size()) {
      fill_next();
    } else {
      std::this_thread::sleep_for(pause);
    }
  }
}

void BufferedRenderer::render(std::span<double> sound, std::int64_t /*clock*/) {
  now_ += static_cast<std::int64_t>(sound.size() / channels_);
  while (!sound.empty()) {
    const std::size_t number = played_.load(std::memory_order_relaxed);
    if (number == filled_.load(std::memory_order_acquire)) {
      ++gaps_;
      std::ranges::fill(sound, 0.0);
      return;
    }
    const std::span<const double> rest = std::span(buffers_[number % buffers_.size()]).subspan(place_);
    const std::size_t count = std::min(rest.size(), sound.size());
    std::ranges::copy(rest.first(count), sound.begin());
    sound = sound.subspan(count);
    place_ += count;
    if (count == rest.size()) {
      place_ = 0;
      played_.store(number + 1, std::memory_order_release);
    }
  }
}

}  // namespace idiophone::outputs
