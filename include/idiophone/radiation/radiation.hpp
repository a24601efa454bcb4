#pragma once
// From triangles to a receiver: what each triangle contributes (O'Brien 2001, section 3.3; the calibrated models are
// those of docs/radiation.md). The air is open: no diffraction by other bodies.

#include <string_view>
#include <vector>

#include "idiophone/radiation/paths.hpp"
#include "idiophone/surface/emission.hpp"

namespace idiophone::radiation {

/// What reaches one receiver from each triangle of an emission: `sound` itself, and the derivative of `change` with
/// respect to time in audio samples, which is taken on arrival.
struct Arrivals {
  std::vector<double> sound;   ///< [triangles of the emission], in the model's unit
  std::vector<double> change;  ///< likewise, or empty: the model has none
  std::vector<double> delay;   ///< likewise; travel time in audio samples
};

/// A way of computing what triangles contribute at a receiver.
class Model {
 public:
  virtual ~Model() = default;

  /// Unit of the sound, e.g. "Pa m".
  [[nodiscard]] virtual std::string_view unit() const = 0;

  /// What the sound is, for people, e.g. "sound pressure by Rayleigh's integral (model rayleigh)".
  [[nodiscard]] virtual std::string_view description() const = 0;

  /// Whether a triangle is not heard where its own body stands in the way. False where the sum over the whole closed
  /// surface already makes the shadow; other bodies shade either way.
  [[nodiscard]] virtual bool shaded_by_own_body() const = 0;

  /// @param emission  arrays padded to a multiple of 8 triangles
  /// @param paths     from its triangles to the receiver; their gain multiplies the sound
  /// @param arrivals  as long as the emission's arrays; what was in it is lost
  virtual void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const = 0;

 protected:
  Model() = default;
  Model(const Model&) = default;
  Model& operator=(const Model&) = default;
};

/// The paper's model: s = p~ a delta cos(theta)/R (eq. 10), theta between the normal and the direction to the receiver,
/// cos(theta) zero behind the triangle, delta (visibility) in the paths' gain. Its unit is Pa m: a pressure would take
/// a factor (1/(2 pi c)) d/dt besides, so its spectrum tilts and its level is no pressure.
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
/// acceleration when the sound set out. Exact for a flat face in an infinite rigid wall.
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
/// with the pressure p_s at the surface that the emission brings, at the time when the sound set out. Exact as far as
/// p_s is. The derivatives are taken on arrival: Ffowcs Williams and Hawkings' form for moving surfaces.
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

}  // namespace idiophone::radiation
