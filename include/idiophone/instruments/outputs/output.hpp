#pragma once
// Where the sound of a renderer goes: a file, a result, or an audio device.

#include <cstdint>

#include "idiophone/instruments/outputs/renderer.hpp"

namespace idiophone::outputs {

class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output(Output&&) = delete;
  Output& operator=(const Output&) = delete;
  Output& operator=(Output&&) = delete;

  /// Audio samples ahead of Renderer::now() that may be rendered before the next advance().
  [[nodiscard]] virtual std::int64_t horizon() const = 0;

  /// @param renderer  must outlive this object
  virtual void start(Renderer& renderer) = 0;

  /// Goes on for a moment: a file takes a block, a device plays. Returns false if it can't go on.
  virtual bool advance() = 0;

  /// After the last advance(). @throws std::runtime_error when the output failed
  virtual void finish() = 0;
};

}  // namespace idiophone::outputs
