#include "track_renderer.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "idiophone/air/receivers/spreading.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "point_sources.hpp"
#include "soundtrack_parts.hpp"

namespace idiophone::timbre {

namespace {

constexpr std::size_t block_length = 1024;  // audio samples

}  // namespace

TrackRenderer::TrackRenderer(const Soundtrack& track, const std::optional<timbre::Reverberation>& reverberation,
                             std::int64_t samples)
    : track_(track), samples_(samples), next_(track.sources_.size()), bands_(track.sources_.size()) {
  sources_sound_.resize(block_length * track.sources_.size());
  add_emitters();
  const std::size_t emitters = padded(emitters_.size());
  emission_.resize(emitters);
  std::ranges::fill(emission_.normal[2], 1.0);
  if (reverberation) {
    late_.emplace(track.acoustics_, *reverberation, PointSources(PointSources::Fall::none, patterns(Field::diffuse)),
                  emitters, samples);
  }
  if (track.acoustics_.listeners.empty()) {
    heard_.push_back({.listener = "sound", .samples = std::vector<double>(static_cast<std::size_t>(samples))});
    return;
  }
  ears_.emplace(track.acoustics_, 0, emitters,
                std::make_unique<PointSources>(PointSources::Fall::with_distance, patterns(Field::direct)),
                receivers::Spreading::band_limited());
  if (!track.objects_.empty()) {
    objects_.emplace(track.acoustics_, track.objects_, sources_of_emitters(), patterns(Field::direct), samples);
  }
  for (const scene::Listener& listener : track.acoustics_.listeners) {
    const std::size_t channels = listener.receivers.size();
    heard_.push_back({.listener = listener.name,
                      .channels = channels,
                      .samples = std::vector<double>(channels * static_cast<std::size_t>(samples))});
  }
}

void TrackRenderer::add_emitters() {
  for (std::size_t s = 0; s < track_.sources_.size(); ++s) {
    const Soundtrack::Source& source = track_.sources_[s];
    const bool has_bands = source.path && source.aim && !source.aim->directivity.bands.empty();
    if (!has_bands || track_.acoustics_.listeners.empty()) {
      emitters_.push_back({.source = s, .band = {}});
      continue;
    }
    const int rate = track_.acoustics_.audio.rate;
    lead_ = static_cast<std::int64_t>(OctaveBands::lead(rate));
    bands_[s].emplace(rate);
    for (std::size_t band = 0; band < OctaveBands::count; ++band) {
      emitters_.push_back({.source = s, .band = band});
    }
  }
}

std::vector<std::size_t> TrackRenderer::sources_of_emitters() const {
  std::vector<std::size_t> sources;
  std::ranges::transform(emitters_, std::back_inserter(sources), &Emitter::source);
  return sources;
}

std::vector<PointSources::Pattern> TrackRenderer::patterns(Field field) const {
  std::vector<PointSources::Pattern> all;
  for (const auto& [source, band] : emitters_) {
    PointSources::Pattern& pattern = all.emplace_back();
    const std::optional<Soundtrack::Aim>& aim = track_.sources_[source].aim;
    if (!aim) {
      continue;
    }
    const Directivity& directivity = band ? aim->directivity.bands[*band] : aim->directivity;
    if (field == Field::direct) {
      pattern = [directivity](double cosine) { return directivity.gain(cosine); };
    } else {
      pattern = [gain = directivity.diffuse_gain()](double /*cosine*/) { return gain; };
    }
  }
  return all;
}

std::vector<TrackSound> TrackRenderer::render(const Soundtrack::Progress& progress) {
  std::size_t count = 0;
  for (std::int64_t first = -lead_; first < samples_; first += static_cast<std::int64_t>(count)) {
    const std::int64_t end = first < 0 ? 0 : samples_;
    count = static_cast<std::size_t>(std::min<std::int64_t>(block_length, end - first));
    start_voices(first, count);
    render_sources(first, count);
    if (first < 0) {
      for (std::size_t i = 0; i < count; ++i) {
        emit(i);
      }
      continue;
    }
    if (ears_) {
      hear(first, count);
      const std::int64_t last = first + static_cast<std::int64_t>(count) - 1;
      take(last + 1 == samples_ ? samples_ : ears_->final_before(last));
    }
    add_plain_sounds(first, count);
    if (progress) {
      progress(first + static_cast<std::int64_t>(count));
    }
  }
  if (objects_) {
    objects_->add_to(heard_);
  }
  if (late_) {
    late_->add_to(heard_);
  }
  return std::move(heard_);
}

void TrackRenderer::start_voices(std::int64_t first, std::size_t count) {
  const std::int64_t end = first + static_cast<std::int64_t>(count);
  for (std::size_t s = 0; s < next_.size(); ++s) {
    const Soundtrack::Source& source = track_.sources_[s];
    for (; next_[s] < source.instances.size() && source.instances[next_[s]].start - lead(s) < end; ++next_[s]) {
      const Soundtrack::Instance& instance = source.instances[next_[s]];
      const double start = static_cast<double>(instance.start) / track_.acoustics_.audio.rate;
      voices_.push_back({s, instance.start - lead(s), instance.stop - lead(s),
                         Graph(*source.tree, instance.bindings, track_.sound_start(s, next_[s], start))});
    }
  }
}

void TrackRenderer::render_sources(std::int64_t first, std::size_t count) {
  std::ranges::fill(sources_sound_, 0.0);
  std::vector<double> sound(count);
  const std::int64_t end = first + static_cast<std::int64_t>(count);
  for (Voice& voice : voices_) {
    const std::int64_t begin = std::max(first, voice.start);
    const auto samples =
        std::span(sound).first(static_cast<std::size_t>(std::max<std::int64_t>(0, std::min(end, voice.stop) - begin)));
    voice.graph.render(samples);
    rendered_ += static_cast<std::int64_t>(samples.size());
    double* output = &sources_sound_[voice.source * block_length + static_cast<std::size_t>(begin - first)];
    const double gain = track_.sources_[voice.source].gain;
    for (const double sample : samples) {
      *output++ += gain * sample;
    }
  }
  std::erase_if(voices_, [end](const Voice& voice) { return voice.stop <= end || voice.graph.has_ended(); });
}

void TrackRenderer::emit(std::size_t place_in_block) {
  for (std::size_t e = 0; e < emitters_.size(); ++e) {
    const std::size_t s = emitters_[e].source;
    const double sound = sources_sound_[s * block_length + place_in_block];
    if (bands_[s]) {
      std::ranges::copy(bands_[s]->step(sound), &emission_.pressure[e]);
      e += OctaveBands::count - 1;
    } else if (track_.sources_[s].path) {
      emission_.pressure[e] = sound;
    }
  }
}

void TrackRenderer::place_emitters(double time) {
  for (std::size_t e = 0; e < emitters_.size(); ++e) {
    const Soundtrack::Source& source = track_.sources_[emitters_[e].source];
    if (!source.path) {
      continue;
    }
    const Vector3 place = source.path(time);
    const Vector3 normal = source.aim ? source.aim->axis(time) : Vector3(0, 0, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      emission_.centre[axis][e] = place[static_cast<Eigen::Index>(axis)];
      emission_.normal[axis][e] = normal[static_cast<Eigen::Index>(axis)];
    }
  }
}

void TrackRenderer::hear(std::int64_t first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t sample = first + static_cast<std::int64_t>(i);
    emit(i);
    place_emitters(static_cast<double>(sample) / track_.acoustics_.audio.rate);
    if (objects_) {
      objects_->hear(sample, emission_);
    }
    const surface::Emission& late_emission = objects_ ? objects_->late_emission() : emission_;
    ears_->hear(sample, emission_, nullptr, {}, &late_emission);
    if (late_) {
      late_->hear(sample, late_emission);
    }
  }
}

void TrackRenderer::take(std::int64_t final_before) {
  if (final_before <= taken_) {
    return;
  }
  const std::vector<std::vector<double>> sounds =
      ears_->take(static_cast<std::size_t>(final_before - taken_), MPI_COMM_SELF);
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    const auto begin = static_cast<std::ptrdiff_t>(heard_[l].channels * static_cast<std::size_t>(taken_));
    std::transform(sounds[l].begin(), sounds[l].end(), heard_[l].samples.begin() + begin,
                   heard_[l].samples.begin() + begin, std::plus<>());
  }
  taken_ = final_before;
}

void TrackRenderer::add_plain_sounds(std::int64_t first, std::size_t count) {
  for (std::size_t s = 0; s < track_.sources_.size(); ++s) {
    if (ears_ && track_.sources_[s].path) {
      continue;
    }
    for (std::size_t i = 0; late_ && i < count; ++i) {
      late_->hear_plain(first + static_cast<std::int64_t>(i), sources_sound_[s * block_length + i]);
    }
    for (TrackSound& listener : heard_) {
      for (std::size_t i = 0; i < count * listener.channels; ++i) {
        listener.samples[static_cast<std::size_t>(first) * listener.channels + i] +=
            sources_sound_[s * block_length + i / listener.channels];
      }
    }
  }
}

}  // namespace idiophone::timbre
