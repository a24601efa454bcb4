#pragma once
// From triangles to a receiver: what each triangle contributes (O'Brien 2001, section 3.3). The air is open: no
// diffraction.

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

  /// Whether triangles of a body that are hidden behind the body itself are not heard. An integral over a closed
  /// surface needs them all.
  [[nodiscard]] virtual bool own_body_hides() const { return true; }

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
  void radiate(const surface::Emission& emission, const Paths& paths, Arrivals& arrivals) const override;
};

}  // namespace idiophone::radiation
