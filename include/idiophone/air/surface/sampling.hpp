#pragma once
// How a surface's motion is sampled and filtered on its way to the audio rate (O'Brien 2001, section 3.2).

namespace idiophone::surface {

/// Plain numbers, so that a surface can be moved by anything.
struct Sampling {
  int rate = 44100;                 ///< audio samples per second
  int steps_per_sample = 1;         ///< m: the motion's step is 1/(m rate)
  int steps_per_read = 1;           ///< k, a divisor of m: displacements are read after each k steps
  double max_frequency = 22050.0;   ///< f_max of eq. 7, Hz; rate/100 to rate/2
  double kernel_wavelengths = 3.0;  ///< half-width of the low-pass in wavelengths of f_max, 0.5 to 32
  double impedance = 415.03;        ///< z = rho c of eq. 2, Pa s/m

  /// Reads in an audio sample, m/k.
  [[nodiscard]] int reads_per_sample() const { return steps_per_sample / steps_per_read; }
  /// w of eq. 6, in steps of the motion: ceil(kernel_wavelengths/(f_max dt)).
  [[nodiscard]] int half_width() const;
  /// What is emitted after the n-th complete audio sample belongs to audio sample n - latency(): half the kernel.
  [[nodiscard]] int latency() const;

  /// @throws std::invalid_argument naming the number that is out of its range.
  void validate() const;
};

/// Largest divisor k of `steps_per_sample` with k dt <= 1/(12 max_frequency): the mean velocity over a read then loses
/// at most 0.1 dB at max_frequency, which the low-pass restores. 1 where even a single step is longer.
[[nodiscard]] int choose_steps_per_read(int steps_per_sample, int rate, double max_frequency);

}  // namespace idiophone::surface
