#include "music.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "idiophone/timbre/nodes/random.hpp"
#include "music_curve.hpp"

namespace idiophone::timbre {

namespace {

int whole_within(double value, double lowest, double highest) {
  return static_cast<int>(std::lround(std::clamp(value, lowest, highest)));
}

/// Composes one part.
class Composer {
 public:
  Composer(const MusicPart& part, const SonicScene& scene, const MotionChannels& motion, std::uint64_t seed)
      : part_(part),
        pitch_(part.pitch, scene, motion, joined_seed(seed, 0)),
        velocity_(part.velocity, scene, motion, joined_seed(seed, 1)),
        program_(part.program, scene, motion, joined_seed(seed, 2)) {
    if (part.steps) {
      steps_.emplace(*part.steps, scene, motion, joined_seed(seed, 3));
    }
    if (part.rests) {
      rests_.emplace(part.rests->value, scene, motion, joined_seed(seed, 4));
    }
  }

  [[nodiscard]] ScorePart compose(int steps, double every) {
    ScorePart written{.name = part_.name, .tonic = part_.tonic, .scale = part_.scale};
    for (int step = 0; step < steps;) {
      const double time = step * every;
      const int length = std::min(steps_ ? whole_within(steps_->at(time), 1.0, longest_note) : 1, steps - step);
      if (!rests_ || rests_->at(time) >= part_.rests->below) {
        add(written.notes, {.start = step,
                            .length = length,
                            .number = note_of(part_, pitch_.at(time)),
                            .velocity = whole_within(velocity_.at(time), 1.0, 127.0),
                            .program = whole_within(program_.at(time), 0.0, 127.0)});
      }
      step += length;
    }
    return written;
  }

 private:
  void add(std::vector<ScoreNote>& notes, const ScoreNote& note) const {
    if (!notes.empty() && !steps_) {
      ScoreNote& before = notes.back();
      if (before.start + before.length == note.start && before.number == note.number &&
          before.program == note.program) {
        before.length += note.length;  // a slur
        return;
      }
    }
    notes.push_back(note);
  }

  const MusicPart& part_;
  MusicCurve pitch_, velocity_, program_;
  std::optional<MusicCurve> steps_, rests_;
};

}  // namespace

int MusicScore::steps() const {
  constexpr double rounding = 1e-9;
  return static_cast<int>(std::ceil(duration / every - rounding));
}

int note_of(const MusicPart& part, double value) {
  const std::vector<int>& scale = musical_scales()[part.scale].second;
  const auto degrees = static_cast<int>(scale.size());
  const double share = std::clamp((value - part.from[0]) / (part.from[1] - part.from[0]), 0.0, 1.0);
  const auto degree = static_cast<int>(std::lround(share * part.octaves * degrees));
  return part.tonic + 12 * (degree / degrees) + scale[degree % degrees];
}

MusicScore compose(const SonicScene& scene, const MotionChannels& motion, double duration) {
  const Music& music = *scene.music;
  MusicScore score{.title = scene.scene.name, .every = music.every, .duration = duration};
  for (std::size_t part = 0; part < music.parts.size(); ++part) {
    Composer composer(music.parts[part], scene, motion, joined_seed(scene.seed, part));
    score.parts.push_back(composer.compose(score.steps(), music.every));
  }
  return score;
}

}  // namespace idiophone::timbre
