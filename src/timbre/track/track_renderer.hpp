#pragma once
// From the sounds of a soundtrack to what every listener hears.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/surface/emission.hpp"
#include "idiophone/timbre/language/graph.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "late_sound.hpp"
#include "object_sounds.hpp"
#include "octave_bands.hpp"

namespace idiophone::timbre {

/// The rendering nodes of the paper (Hahn 1995, figure 5) behind every sound: attenuation and delay, Doppler shift,
/// directivity, reflection from the floor, objects in the way, head responses, and reverberation.
class TrackRenderer {
 public:
  /// @param track    must outlive this object
  /// @param samples  of the whole sound
  TrackRenderer(const Soundtrack& track, const std::optional<timbre::Reverberation>& reverberation,
                std::int64_t samples);

  /// Once.
  [[nodiscard]] std::vector<TrackSound> render(const Soundtrack::Progress& progress);

  /// Samples of trees that were computed: the work so far.
  [[nodiscard]] std::int64_t rendered() const { return rendered_; }

 private:
  /// An instance that sounds.
  struct Voice {
    std::size_t source;
    std::int64_t start, stop;  ///< audio samples
    Graph graph;
  };

  /// A source, or one octave band of it.
  struct Emitter {
    std::size_t source;
    std::optional<std::size_t> band;
  };

  enum class Field { direct, diffuse };
  void add_emitters();
  /// [emitters]
  [[nodiscard]] std::vector<PointSources::Pattern> patterns(Field field) const;
  [[nodiscard]] std::vector<std::size_t> sources_of_emitters() const;
  /// Audio samples by which a source is computed before it is emitted.
  [[nodiscard]] std::int64_t lead(std::size_t source) const { return bands_[source] ? lead_ : 0; }
  void start_voices(std::int64_t first, std::size_t count);
  void render_sources(std::int64_t first, std::size_t count);
  void hear(std::int64_t first, std::size_t count);
  /// Splits one sample of each source into what its emitters emit.
  void emit(std::size_t place_in_block);
  void place_emitters(double time);
  /// Moves what is final from the ears to the listeners.
  void take(std::int64_t final_before);
  void add_plain_sounds(std::int64_t first, std::size_t count);

  const Soundtrack& track_;
  std::int64_t samples_;
  std::vector<std::size_t> next_;  // [sources] instance that has not begun
  std::vector<Voice> voices_;
  std::vector<double> sources_sound_;              // [block x sources] a source's samples side by side
  std::vector<std::optional<OctaveBands>> bands_;  // [sources] of those whose directivity has bands
  std::int64_t lead_ = 0;                          // of these sources
  std::vector<Emitter> emitters_;
  surface::Emission emission_;  // a triangle for each emitter
  std::optional<propagation::Ears> ears_;
  std::optional<LateSound> late_;
  std::optional<ObjectSounds> objects_;
  std::vector<TrackSound> heard_;
  std::int64_t taken_ = 0;
  std::int64_t rendered_ = 0;
};

}  // namespace idiophone::timbre
