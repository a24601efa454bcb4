#pragma once
// Whatever an audio device plays.

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone::outputs {

class Renderer {
 public:
  Renderer() = default;
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  [[nodiscard]] virtual int rate() const = 0;               ///< audio samples per second
  [[nodiscard]] virtual std::size_t receivers() const = 0;  ///< channels

  /// Audio thread: the next samples, [frames x receivers]. It never locks or allocates.
  /// @param clock  ns of the steady clock at the start of the block; to measure delays
  virtual void render(std::span<double> sound, std::int64_t clock) = 0;

  /// The audio sample that is rendered next. Any thread.
  [[nodiscard]] virtual std::int64_t now() const = 0;
};

}  // namespace idiophone::outputs
