#pragma once
// From triangles to a receiver: what each triangle contributes and when it arrives (O'Brien 2001, section 3.3). The air
// is open: no reflections, no diffraction.

#include <string_view>
#include <vector>

#include "idiophone/surface/emission.hpp"
#include "idiophone/types.hpp"

namespace idiophone::radiation {

/// What reaches one receiver from each triangle of an emission.
struct Arrivals {
  std::vector<double> sound;  ///< [triangles of the emission], in the model's unit
  std::vector<double> delay;  ///< likewise; travel time in audio samples
};

/// The air, and the clock that delays are counted with.
struct Air {
  double speed = 343.0;  ///< of sound, m/s
  int rate = 44100;      ///< audio samples per second

  /// Audio samples in which sound travels a metre.
  [[nodiscard]] double samples_per_metre() const { return rate / speed; }
};

/// Receivers farther away than this are a mistake; it bounds the memory of what is still on its way, m.
inline constexpr double longest_distance = 100e3;

/// Receivers nearer to a triangle's centre than this are taken to be this far away, m. Nothing is infinite then; no
/// model means anything within a triangle's own size.
inline constexpr double smallest_distance = 1e-3;

/// A way of computing what triangles contribute at a receiver.
class Model {
 public:
  virtual ~Model() = default;

  /// Unit of Arrivals::sound, e.g. "Pa m".
  [[nodiscard]] virtual std::string_view unit() const = 0;

  /// @param emission  arrays padded to a multiple of 8 triangles
  /// @param receiver  m
  /// @param arrivals  as long as the emission's arrays; what was in it is lost
  virtual void radiate(const surface::Emission& emission, const Vector3& receiver, Arrivals& arrivals) const = 0;

 protected:
  Model() = default;
  Model(const Model&) = default;
  Model& operator=(const Model&) = default;
};

/// The paper's model: s = p~ a delta cos(theta)/R (eq. 10) after R/c (eq. 11), theta between the normal and the
/// direction to the receiver, cos(theta) zero behind the triangle, delta (visibility) one. Its unit is Pa m: a pressure
/// would take a factor (1/(2 pi c)) d/dt besides, so its spectrum tilts and its level is no pressure.
class Huygens final : public Model {
 public:
  /// @throws std::invalid_argument when speed or rate is not positive.
  explicit Huygens(const Air& air);

  [[nodiscard]] std::string_view unit() const override { return "Pa m"; }
  void radiate(const surface::Emission& emission, const Vector3& receiver, Arrivals& arrivals) const override;

 private:
  double samples_per_metre_;
};

}  // namespace idiophone::radiation
