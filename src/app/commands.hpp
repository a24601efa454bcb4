#pragma once
// The commands of the program. Each returns its exit status and throws what went wrong.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/study/advice/network.hpp"

namespace idiophone::app {

/// How a command answers: text for people, JSON for scripts.
enum class Style { text, json };

struct RunOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  bool resume = false;
  std::filesystem::path scene;    ///< a sonic scene whose sounds are made, too; empty for none
  std::string progress = "auto";  ///< line, log, or auto: a line where standard output is a terminal of our own
};

/// `idiophone run`: from a deck to sound. Collective.
int run(const RunOptions& options);

struct CheckOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";        ///< whose free space is compared
  bool resolved = false;                           ///< print the resolved deck, and nothing else
  std::optional<double> accuracy;                  ///< cents, of the recommended mesh
  std::optional<double> up_to;                     ///< Hz, likewise; no mesh is recommended if both are empty
  std::optional<int> ranks;                        ///< predict a run on so many
  std::optional<double> latency;                   ///< of a message between them, s; see usual_latency
  double bandwidth = advice::Network{}.bandwidth;  ///< of a rank, bytes/s
  Style style = Style::text;
};

/// `idiophone check`: everything up to the first step, sizes and costs. Collective.
int check(const CheckOptions& options);

struct ListenOptions {
  std::filesystem::path recording;  ///< NAME.h5, with NAME_surface.h5 beside it, or a recording
  std::filesystem::path deck;       ///< for listening; empty for the recorded one
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string progress = "auto";  ///< as in RunOptions
};

/// `idiophone listen`: the sound of a recorded motion, at other listeners or by another model. Collective.
int listen(const ListenOptions& options);

struct InfoOptions {
  std::filesystem::path file;
  std::string channel;  ///< of a result, whose rows are printed; empty for what is in the file
  bool verify = false;  ///< read all of it and compare it with its checksums
  Style style = Style::text;
};

/// `idiophone info`: what is in a result, recording, checkpoint, sound map or file of `radiate`.
int info(const InfoOptions& options);

struct AnalyzeOptions {
  std::filesystem::path result;  ///< NAME.h5, or a sound file
  std::string listener;          ///< empty for all
  std::optional<double> start;   ///< s, after the blow; default: 0.02, or a tenth of a short sound
  std::optional<double> duration;
  double lowest = 20.0;  ///< Hz
  std::optional<double> highest;
  double dynamic_range = 60.0;  ///< dB
  double tolerance = 100.0;     ///< cents, of matches with references
  Style style = Style::text;
  std::filesystem::path partials;     ///< CSV to write, if any
  std::filesystem::path spectrum;     ///< CSV to write, if any
  std::filesystem::path spectrogram;  ///< CSV to write, if any
};

/// `idiophone analyze`: the partials of a sound.
int analyze(const AnalyzeOptions& options);

struct ModesOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string body;                ///< empty for the first
  int count = 20;                  ///< of modes
  std::string mass = "lumped";     ///< or consistent
  std::optional<double> shift;     ///< Hz below zero
  std::vector<double> references;  ///< Hz; empty for the deck's own
  double tolerance = 100.0;        ///< cents, of matches with references
  Style style = Style::text;
};

/// `idiophone modes`: eigenfrequencies and mode shapes of a body. Collective.
int modes(const ModesOptions& options);

struct MapOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  double up_to = 20000.0;    ///< Hz: all modes up to there
  std::optional<int> count;  ///< of modes, the lowest; takes the place of `up_to`
  std::string radiation;     ///< "boundary_elements" or "kirchhoff"; empty: as the time allows
};

/// `idiophone map`: sound maps of the bodies of a deck. Collective.
int map(const MapOptions& options);

struct ExportOptions {
  std::filesystem::path map;      ///< NAME_BODY.map.h5, or a timbre tree, TREE.tt
  std::filesystem::path faust;    ///< to write, if any
  std::filesystem::path gltf;     ///< to write, if any
  std::vector<double> at;         ///< where a body is struck in Faust, m; empty for the first vertex
  std::vector<double> direction;  ///< of the force in Faust; empty for down
  std::string listener;           ///< who hears it in Faust; empty for the first
};

/// `idiophone export`: a sound map or a timbre tree in the languages of other programs. On one rank.
int export_map(const ExportOptions& options);

struct ExploreOptions {
  std::vector<std::string> maps;       ///< NAME_BODY.map.h5
  std::string page = "explorer.html";  ///< to write
  std::filesystem::path proxies;       ///< deck whose bodies also get proxies, if any
  std::vector<std::string> overrides;  ///< of this deck
  int levels = 1;                      ///< meshes of each body, each with elements twice as large as the one before
};

/// `idiophone explore`: the Sonic Explorer, a web page on which the bodies of sound maps are struck. On one rank.
int explore(const ExploreOptions& options);

struct ReportOptions {
  std::vector<std::filesystem::path> results;  ///< NAME.h5, one or two
  std::string page = "report.html";            ///< to write
};

/// `idiophone report`: one web page about a run, or two compared. On one rank.
int report(const ReportOptions& options);

struct PlayOptions {
  std::vector<std::filesystem::path> maps;  ///< sound maps
  std::filesystem::path score;              ///< if any
  std::vector<std::string> overrides;       ///< of the score
  std::optional<int> osc;                   ///< UDP port
  std::string midi;                         ///< a MIDI file, or jack
  std::filesystem::path output;             ///< WAV file to write; empty: the audio device plays
  std::string device;                       ///< part of its name; empty for the default one
  int rate = 48000;                         ///< audio samples per second
  int frames = 128;                         ///< of a block of the audio device
  double full_scale = 1.0;                  ///< of the audio device, Pa
};

/// `idiophone play`: plays bodies by their sound maps.
int play(const PlayOptions& options);

struct TimbreOptions {
  std::filesystem::path scene;   ///< a sonic scene
  std::filesystem::path result;  ///< NAME.h5 with the motion, if any
  std::vector<std::string> overrides;
  std::filesystem::path output;  ///< WAV file; empty for NAME.wav
};

/// `idiophone timbre`: the sounds of a sonic scene, bound to motion. On one rank.
int timbre(const TimbreOptions& options);

struct EvolveOptions {
  std::vector<std::filesystem::path> trees;  ///< the ancestors
  std::filesystem::path target;              ///< WAV file to imitate; empty for selection by ear
  std::filesystem::path output = "evolved.tt";
  std::filesystem::path page;  ///< to select by ear; empty with a target
  bool constants = false;      ///< change numbers only
  int population = 40;
  int generations = 40;
  int nodes = 100;  ///< of a tree, at most
  int seed = 1;
  double duration = 2.0;  ///< of a sound on the page, s
};

/// `idiophone evolve`: breeds timbre trees, by ear or towards a sound. Collective.
int evolve(const EvolveOptions& options);

struct ProxiesOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path score;     ///< what is done to the bodies, if any
  std::filesystem::path contacts;  ///< result of the deck's run whose contact forces drive the proxies, if any
  std::filesystem::path output;    ///< WAV file; empty: the audio device plays
  std::filesystem::path result;    ///< folder for a result by the radiation model of the deck, if any
  std::optional<int> osc;          ///< UDP port
  std::string device;              ///< part of its name; empty for the default one
  int frames = 256;                ///< of an audio buffer
  int buffers = 8;                 ///< that are computed ahead
  double full_scale = 1.0;         ///< of the audio device, Pa
  std::filesystem::path report;    ///< CSV file for the choices of levels, if any
  int levels = 1;                  ///< meshes of each body, each with elements twice as large as the one before
  int lowest_rate = 1;             ///< the audio rate over this power of two
  int most_active = 8;             ///< proxies that may sound at once
  std::optional<double> budget;    ///< processor time per time of sound
  double speed = 4e8;              ///< springs that one core computes in a second, for the budget
  std::string priority = "distance";
  std::string integrator = "symplectic_euler";
  std::string sound = "pressure";
  double significant_distance = 1e-10;  ///< m
};

/// `idiophone proxies`: the sound of bodies by mass-spring proxies with levels of detail. On one rank.
int proxies(const ProxiesOptions& options);

struct RadiateOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  std::string body;                 ///< empty for the first
  int modes = 10;                   ///< number of modes, the lowest
  std::vector<double> frequencies;  ///< Hz; if there are any, the body moves rigidly along each axis, without modes
  std::optional<double> cell;       ///< of a grid of model waves, which is compared too, m
  Style style = Style::text;
};

/// `idiophone radiate`: the sound of a body's modes by boundary elements. Collective.
int radiate(const RadiateOptions& options);

struct IdentifyOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path measured;      ///< a YAML file, or a recording
  std::string body;                    ///< empty for the first
  std::vector<std::string> constants;  ///< to fit; empty for all of the material
  double tolerance = 50.0;             ///< cents, between a line and its mode
  std::optional<int> lines;            ///< fit only so many, the lowest
  std::string mass = "consistent";     ///< or lumped
  Style style = Style::text;
};

/// `idiophone identify`: the constants of a material from measured resonances. On rank 0.
int identify(const IdentifyOptions& options);

struct TuneOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output;      ///< tuned deck to write, if any
  std::string body;                  ///< empty for the first
  std::string target;                ///< frequencies, notes or ratios
  std::optional<std::string> pitch;  ///< of the first of the ratios
  std::vector<std::string> vary;     ///< KEY=LOWEST:HIGHEST
  std::vector<int> modes;            ///< from 1 on; empty for the lowest
  double tolerance = 2.0;            ///< cents
  double a4 = 440.0;                 ///< Hz
  std::string mass = "lumped";       ///< or consistent
  Style style = Style::text;
};

/// `idiophone tune`: numbers of a deck that give modes wanted frequencies. On rank 0.
int tune(const TuneOptions& options);

}  // namespace idiophone::app
