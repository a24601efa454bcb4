#pragma once
// Radiation models: the contribution of each triangle at a receiver (O'Brien 2001, section 3.3; the calibrated models
// are those of docs/method/radiation.md). Free field: no diffraction by other bodies.

#include <string_view>
#include <vector>

#include "idiophone/air/radiation/paths.hpp"
#include "idiophone/air/surface/emission.hpp"

namespace idiophone::radiation {

/// The contributions of each triangle of an emission at one receiver: `sound`, and the derivative of `change` with
/// respect to the time of arrival in audio samples.
struct Arrivals {
  std::vector<double> sound;   ///< [triangles of the emission], in the model's unit
  std::vector<double> change;  ///< likewise; empty if the model has none
  std::vector<double> delay;   ///< likewise; travel time in audio samples
};

/// A radiation model.
class Model {
 public:
  virtual ~Model() = default;

  /// Unit of the sound, e.g. "Pa m".
  [[nodiscard]] virtual std::string_view unit() const = 0;

  /// A description of the sound for users, e.g. "sound pressure by Rayleigh's integral (model rayleigh)".
  [[nodiscard]] virtual std::string_view description() const = 0;

  /// Whether a body's triangles hide each other. False if the sum over the whole closed surface already gives the
  /// shadow. Other bodies hide a triangle in any case.
  [[nodiscard]] virtual bool shaded_by_own_body() const = 0;

  /// @param emission  arrays padded to a multiple of 8 triangles
  /// @param paths     from its triangles to the receiver; their gain multiplies the sound
  /// @param arrivals  overwritten; becomes as long as the emission's arrays
  virtual void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const = 0;

 protected:
  Model() = default;
  Model(const Model&) = default;
  Model& operator=(const Model&) = default;
};

/// The paper's model: s = p~ a delta cos(theta)/R (eq. 10), theta between the normal and the direction to the receiver,
/// cos(theta) zero behind the triangle, delta (visibility) in the paths' gain. Its unit is Pa m. A pressure would need
/// the additional factor (1/(2 pi c)) d/dt, so the spectrum is tilted and the level is not a sound pressure level.
class Huygens final : public Model {
 public:
  [[nodiscard]] std::string_view unit() const override { return "Pa m"; }
  [[nodiscard]] std::string_view description() const override {
    return "sound at the listener by the paper's eq. 10 (model huygens)";
  }
  [[nodiscard]] bool shaded_by_own_body() const override { return true; }
  void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const override;
};

/// Rayleigh's integral, Pa: p = rho/(2 pi) sum a v'/R over the triangles that face the receiver; v' is the normal
/// acceleration at the time of emission. Exact for a flat face in an infinite rigid wall.
class Rayleigh final : public Model {
 public:
  explicit Rayleigh(const Medium& air) : air_(air) {}
  [[nodiscard]] std::string_view unit() const override { return "Pa"; }
  [[nodiscard]] std::string_view description() const override {
    return "sound pressure at the listener by Rayleigh's integral (model rayleigh)";
  }
  [[nodiscard]] bool shaded_by_own_body() const override { return true; }
  void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const override;

 private:
  Medium air_;
};

/// Kirchhoff's integral over the closed surface, Pa: p = 1/(4 pi) sum a [rho v'/R + cos(theta) (p_s/R^2 + p_s'/(c R))],
/// with the emission's surface pressure p_s at the time of emission. Exact if p_s is. The derivatives are taken with
/// respect to the time of arrival: Ffowcs Williams and Hawkings' form for moving surfaces.
class Kirchhoff final : public Model {
 public:
  explicit Kirchhoff(const Medium& air) : air_(air) {}
  [[nodiscard]] std::string_view unit() const override { return "Pa"; }
  [[nodiscard]] std::string_view description() const override {
    return "sound pressure at the listener by Kirchhoff's integral (model kirchhoff)";
  }
  [[nodiscard]] bool shaded_by_own_body() const override { return false; }
  void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const override;

 private:
  Medium air_;
};

/// The Kirchhoff-Helmholtz integral over a box in the air, Pa:
/// p = 1/(4 pi) sum a [-(dp/dn)/R + cos(theta) (p/R^2 + p'/(c R))], with the emission's surface pressure p and pressure
/// gradient dp/dn. Exact outside the box for whatever sounds inside it.
class KirchhoffHelmholtz final : public Model {
 public:
  explicit KirchhoffHelmholtz(const Medium& air) : air_(air) {}
  [[nodiscard]] std::string_view unit() const override { return "Pa"; }
  [[nodiscard]] std::string_view description() const override {
    return "sound pressure at the listener by waves on a grid (model waves)";
  }
  [[nodiscard]] bool shaded_by_own_body() const override { return false; }
  void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const override;

 private:
  Medium air_;
};

}  // namespace idiophone::radiation
