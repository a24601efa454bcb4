#pragma once
// One performance of sound maps, proxies and timbre trees: the commands `play` and `proxies`.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/body_track.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/voices/shared_budget.hpp"
#include "idiophone/instruments/voices/voice.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::timbre {

/// How bodies of decks become proxies.
struct ProxySettings {
  proxy_bodies::Springs springs = proxy_bodies::Springs::van_gelder;
  int levels = 1;                          ///< meshes of each body, each with elements twice as large as before
  std::optional<double> budget;            ///< processor time per time of sound, of sound maps and proxies together
  double speed = voices::usual_speed;      ///< springs that one core computes in a second, for the budget
  proxies::EngineOptions engine{};         ///< rate, air and budget are set from the rest
  std::map<std::string, double> strength;  ///< Pa: tensile strength of bodies that break
  std::filesystem::path report;            ///< CSV file for the choices of levels, if any
  double frames_per_second = 0.0;          ///< of the bodies' motion in a result; 0: none
};

struct PlaySettings {
  std::vector<std::filesystem::path> files;  ///< sound maps (.h5), timbre trees (.tt) and decks of proxies, any number
  std::vector<std::string> deck_overrides;   ///< of all decks
  std::filesystem::path score;               ///< if any
  std::vector<std::string> score_overrides;
  std::optional<int> osc;                 ///< UDP port
  std::string osc_address = "127.0.0.1";  ///< of this machine, on which the port is open
  std::string midi;                       ///< a MIDI file, or jack
  std::string midi_out;                   ///< MIDI input of JACK for the notes of score and MIDI file, or jack; if any
  std::filesystem::path contacts;         ///< result whose contact forces strike the bodies, if any
  std::filesystem::path motion;           ///< result whose channels the score's `motion` follows, if any
  std::filesystem::path output;           ///< WAV file or result (.h5) to write; empty: the audio device plays
  std::string device;                     ///< part of its name; empty for the default one
  std::optional<int> rate;                ///< audio samples per second; that of the first deck if empty
  int frames = 128;                       ///< of a block of the audio device
  int buffer_frames = 256;                ///< of a buffer that is computed ahead
  int buffers = 8;                        ///< that are computed ahead
  double full_scale = 1.0;                ///< of the audio device, Pa
  ProxySettings proxies;
  bool masking = true;                  ///< as voices::MapDetail
  std::filesystem::path detail_report;  ///< CSV file for what was heard of the sound maps, if any
};

/// A proxy at one level of detail.
struct LevelSize {
  std::string body;
  std::size_t level = 0, masses = 0, springs = 0;
};

/// A proxy that broke.
struct Break {
  double time = 0.0;  ///< s
  std::string body;
  std::size_t pieces = 0;
  double released = 0.0;  ///< energy, J
};

/// What happened to the proxies of a performance.
struct ProxyFacts {
  std::vector<LevelSize> levels;
  std::map<std::string, int> choices;  ///< how often proxies "begin", "end", "stop" or are refused ("refuse")
  std::vector<Break> breaks;
};

/// What was heard of the sound maps of a performance with a budget.
struct MapFacts {
  double mean_cost = 0.0, largest_cost = 0.0;  ///< of an interval, processor time per time of sound
  std::size_t most_sounding = 0;               ///< bodies at once
  double heard = 0.0;                          ///< share of the modes of the bodies that sounded
  double left_out = 0.0;                       ///< power of the other modes over that of all, dB
};

/// What a performance was.
struct Performance {
  std::vector<std::string> bodies{};
  int rate = 0;                 ///< audio samples per second
  double duration = 0.0;        ///< of the sound, s
  double processor_time = 0.0;  ///< s
  voices::VoiceReport told{};   ///< waits and gaps of a live performance
  std::optional<ProxyFacts> proxies{};
  std::optional<MapFacts> maps{};
  std::size_t midi_messages = 0;  ///< that went to a MIDI input
};

/// Plays until the score is over, or a signal comes if there is live input. With midi_out, the notes of score and MIDI
/// file go to a MIDI input instead of an audio device; to both a file and then the MIDI input if there is an output.
/// @throws std::runtime_error and deck::DeckError for what can't be read or played
Performance play(const PlaySettings& settings);

/// What drives the bodies of one deck, all of it: forces of the score's events, then contacts and motion.
struct DrivenProxies {
  scene::Scene scene;
  score::Score score;
  std::vector<std::vector<std::shared_ptr<const proxies::Lattice>>> levels;  ///< [bodies]
  std::vector<proxies::Force> forces;
  std::vector<drivers::BodyTrack> tracks;  ///< [bodies] empty for those that stay where they are
};

/// For another way to compute the sound of the settings' only deck.
/// @throws as play()
[[nodiscard]] DrivenProxies driven_proxies(const PlaySettings& settings);

}  // namespace idiophone::timbre
