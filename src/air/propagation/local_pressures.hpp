#pragma once
// Pressures of a grid at places in the air within the box around the bodies.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/waves/enclosing_box.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::propagation {

/// Linear between the centres of eight cells.
class LocalPressures {
 public:
  /// @param field  must outlive this object
  LocalPressures(const waves::WaveField& field, const waves::Enclosure& enclosure)
      : field_(field), enclosure_(enclosure) {}

  /// Takes the pressures of the present around these places, m. Does not wait for an accelerator.
  void begin(std::span<const Vector3> places);
  /// Waits for an accelerator.
  void finish();
  /// This rank's share of the pressure at one of these places at the time of begin(), Pa; none outside of the box.
  /// @throws std::logic_error if it is none of them
  [[nodiscard]] std::optional<Ears::LocalSounds> at(const Vector3& place) const;

 private:
  /// A cell next to a place, if this rank has it.
  struct Corner {
    std::optional<Index> cell;
    double weight;
  };
  [[nodiscard]] std::array<Corner, 8> corners(const Vector3& in_cells) const;

  const waves::WaveField& field_;
  waves::Enclosure enclosure_;
  std::vector<Index> cells_;  // around the places in the box
  std::unique_ptr<waves::PressureProbe> probe_;
  std::span<const float> pressures_;  // of these cells, Pa
};

}  // namespace idiophone::propagation
