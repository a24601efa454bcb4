#include "music_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/timbre/track/soundtrack.hpp"
#include "motion_curve.hpp"

namespace idiophone::timbre {

MusicCurve::MusicCurve(const MusicVariable& variable, const SonicScene& scene, const MotionChannels& motion,
                       std::uint64_t seed)
    : rate_(scene.scene.audio.rate) {
  if (const auto* number = std::get_if<double>(&variable)) {
    source_ = *number;
  } else if (const auto* keys = std::get_if<Keyframes>(&variable)) {
    source_ = time_dependent_variable(*keys);
  } else if (const auto* channel = std::get_if<MotionVariable>(&variable)) {
    source_ = curve_of(*channel, motion);
  } else {
    const auto& tree = std::get<TreeVariable>(variable);
    source_ = std::make_unique<Graph>(read_tree_file(scene.classes[tree.sound_class].tree),
                                      bindings_of(tree.parameters, motion),
                                      SoundStart{.rate = rate_, .body_seed = seed, .start_seed = joined_seed(seed, 0)});
  }
}

double MusicCurve::at(double time) {
  if (const auto* number = std::get_if<double>(&source_)) {
    return *number;
  }
  if (const auto* curve = std::get_if<std::shared_ptr<const Curve>>(&source_)) {
    return (*curve)->at(time);
  }
  Graph& graph = *std::get<std::unique_ptr<Graph>>(source_);
  std::array<double, 1024> samples{};
  const std::int64_t wanted = std::llround(time * rate_) + 1;
  while (rendered_ < wanted) {
    const auto count = std::min<std::int64_t>(wanted - rendered_, samples.size());
    graph.render(std::span(samples).first(static_cast<std::size_t>(count)));
    last_ = samples[static_cast<std::size_t>(count) - 1];
    rendered_ += count;
  }
  return last_;
}

}  // namespace idiophone::timbre
