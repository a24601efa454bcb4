#pragma once
// Settings of a run: time and steps, audio, output, and frequencies to compare with.

#include <optional>
#include <string>
#include <vector>

namespace idiophone::scene {

/// Time and steps.
struct Time {
  double duration = 0.0;                   ///< of the sound, s
  std::optional<int> steps_per_sample;     ///< m; chosen from the largest eigenfrequency if omitted
  double safety = 0.9;                     ///< of the largest stable step, in (0, 1]
  std::optional<double> wall_clock_limit;  ///< after which the run stops in good order, s
};

/// Filters and sampling (paper, section 3.2).
struct Audio {
  int rate = 44100;                 ///< samples per second
  double max_frequency = 22050.0;   ///< f_max of eq. 7, Hz
  double kernel_wavelengths = 3.0;  ///< half-width of the low-pass in wavelengths of f_max (the paper's w)
  double dc_loss = 0.0;             ///< alpha of eq. 9, in [0, 1); from the deck's dc_block or its corner frequency
};

enum class WavFormat { float32, pcm24, pcm16 };

struct Output {
  double frames_per_second = 60.0;    ///< of the mesh; 0 for none
  double motion_per_second = 2000.0;  ///< of the motion channels and energies; 0 for none
  WavFormat wav = WavFormat::float32;
  std::optional<double> wav_full_scale;  ///< pressure that becomes 1.0 in the WAV; the largest one if omitted
  double checkpoint_minutes = 15.0;      ///< of wall clock between checkpoints; 0: only at a stop
  int checkpoint_keep = 3;               ///< number of newest ones kept
  bool surface_motion = false;           ///< whether the surfaces' motion is recorded
};

/// Expected frequencies of the sound, for spectra and `analyze`.
struct ReferenceSet {
  std::string name;                 ///< e.g. "thin plate (Leissa)"
  std::vector<double> frequencies;  ///< Hz
};

}  // namespace idiophone::scene
