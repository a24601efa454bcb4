#pragma once
// Sounds that are rendered block by block, faster than real time.

#include <utility>
#include <vector>

#include "idiophone/instruments/outputs/output.hpp"

namespace idiophone::outputs {

/// Keeps the samples.
class Collected : public Output {
 public:
  /// @param samples  audio samples to render
  /// @param block    that are rendered at once
  explicit Collected(std::int64_t samples, std::int64_t block = 512) : left_(samples), block_(block) {}

  [[nodiscard]] std::int64_t horizon() const override { return block_; }
  void start(Renderer& renderer) override;
  bool advance() override;
  void finish() override {}

  /// [samples x channels]
  [[nodiscard]] std::vector<double> take() { return std::move(sound_); }

 protected:
  [[nodiscard]] std::size_t channels() const { return renderer_->receivers(); }

 private:
  Renderer* renderer_ = nullptr;
  std::int64_t left_, block_;
  std::vector<double> sound_;
};

}  // namespace idiophone::outputs
