#include "music.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/timbre/nodes/curve.hpp"
#include "motion_curve.hpp"

namespace idiophone::timbre {

int note_of(const timbre::MusicPart& part, double value) {
  const std::vector<int>& scale = timbre::musical_scales()[part.scale].second;
  const auto degrees = static_cast<int>(scale.size());
  const double share = std::clamp((value - part.from[0]) / (part.from[1] - part.from[0]), 0.0, 1.0);
  const auto degree = static_cast<int>(std::lround(share * part.octaves * degrees));
  return part.tonic + 12 * (degree / degrees) + scale[degree % degrees];
}

std::vector<ScorePart> compose(const timbre::Music& music, const MotionChannels& motion, double duration) {
  std::vector<ScorePart> score;
  for (const timbre::MusicPart& part : music.parts) {
    ScorePart& written = score.emplace_back(ScorePart{.name = part.name, .program = part.program, .notes = {}});
    const std::shared_ptr<const Curve> pitch = curve_of(part.pitch, motion);
    const auto* velocities = std::get_if<timbre::MotionVariable>(&part.velocity);
    const std::shared_ptr<const Curve> velocity = velocities == nullptr ? nullptr : curve_of(*velocities, motion);
    for (int step = 0; step * music.every < duration; ++step) {
      const double time = step * music.every;
      const double length = std::min(music.every, duration - time);
      const int note = note_of(part, pitch->at(time));
      if (!written.notes.empty() && written.notes.back().number == note) {
        written.notes.back().duration += length;  // a slur
        continue;
      }
      const double strength = velocity ? velocity->at(time) : std::get<int>(part.velocity);
      written.notes.push_back({time, length, note, static_cast<int>(std::lround(std::clamp(strength, 1.0, 127.0)))});
    }
  }
  return score;
}

}  // namespace idiophone::timbre
