#pragma once
// The sound of surfaces that vibrate in the open, at single frequencies, from one short pulse of their velocity.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/waves/enclosing_box.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::waves {

/// Surfaces and how they vibrate.
struct PulsedSurface {
  Obstruction obstruction;
  std::span<const float> shape;        ///< [triangles that vibrate, the first ones] normal velocity, m/s
  double cell = 0.004;                 ///< edge of a cell, m
  double speed = 343.0;                ///< of sound, m/s
  double impedance = 415.03;           ///< rho c, Pa s/m
  std::optional<LossyAir> lossy = {};  ///< the losses at walls; none: walls take nothing
};

/// The waves around these surfaces, on this rank alone. Their velocity is shape times a pulse.
class PulsedField {
 public:
  explicit PulsedField(const PulsedSurface& surface);

  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const WaveField& field() const { return field_; }
  /// Of the field, s.
  [[nodiscard]] double time() const { return step_ * step_length_; }
  /// The pulse at this time, 1.
  [[nodiscard]] double pulse() const;
  /// One step.
  void advance();

 private:
  PulsedSurface surface_;
  Plan plan_;
  double step_length_;  // s
  WaveField field_;
  SurfaceSources sources_;
  std::vector<float> changes_, node_sources_;
  int step_ = 0;
};

/// The sound at single frequencies. Complex numbers belong to exp(+i w t) and are amplitudes for the velocity `shape`.
class PulseResponse {
 public:
  /// Goes on until the sound has faded: in cavities it may ring for long.
  /// @param frequencies  Hz; up to 6 kHz, as the pulse is short
  /// @param longest      at the latest it ends then, s
  PulseResponse(const PulsedSurface& surface, std::span<const double> frequencies, double longest = 0.1);

  /// When it ended, s.
  [[nodiscard]] double duration() const { return duration_; }

  /// Pressure at a point outside the grid's box, Pa.
  [[nodiscard]] std::complex<double> at(std::size_t frequency, const Vector3& point) const;
  /// Pressure times distance in the far field, Pa m, without the phase exp(-i k r) of the way from the origin.
  /// @param direction  unit vector
  [[nodiscard]] std::complex<double> towards(std::size_t frequency, const Vector3& direction) const;

 private:
  struct Wave {
    double angular;                                        // frequency, 1/s
    std::complex<double> driven;                           // spectrum of the pulse
    std::vector<std::complex<double>> pressure, gradient;  // spectra at the patches of the box
  };
  /// From a patch of the box to a listener.
  struct Path {
    std::complex<double> transfer;  // of a monopole there to the result
    Vector3 direction;              // unit vector
    std::complex<double> decrease;  // of the transfer with the distance, over itself, 1/m
  };
  /// Kirchhoff-Helmholtz integral over the box.
  /// @param find_path  Path from the centre of a patch
  template <class FindPath>
  [[nodiscard]] std::complex<double> integral(const Wave& wave, const FindPath& find_path) const;
  void add(Wave& wave, double time, double pulse) const;
  [[nodiscard]] bool has_faded(double recent) const;
  [[nodiscard]] std::complex<double> wave_number(const Wave& wave) const { return {0.0, wave.angular / speed_}; }

  double speed_;
  double duration_ = 0.0;
  surface::Emission box_;
  std::vector<Wave> waves_;
};

}  // namespace idiophone::waves
