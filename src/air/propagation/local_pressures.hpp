#pragma once
// Pressures of a grid at places in the air within the box around the bodies.

#include <array>
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

  /// Takes the pressures of the present around these places. Does not wait for an accelerator.
  /// @param places  m; as many in each call
  void begin(std::span<const Vector3> places);
  /// Waits for an accelerator.
  void finish();
  /// This rank's share of the pressure at each of the places at the time of begin(), Pa; none outside of the box. They
  /// stay until the next finish().
  [[nodiscard]] const std::vector<std::optional<Ears::LocalSounds>>& sounds() const { return sounds_; }

 private:
  /// A cell next to a place, if this rank has it.
  struct Corner {
    std::optional<Index> cell;
    double weight;
  };
  using Corners = std::array<Corner, 8>;
  [[nodiscard]] std::optional<Corners> corners(const Vector3& place) const;

  const waves::WaveField& field_;
  waves::Enclosure enclosure_;
  std::vector<std::optional<Corners>> corners_;  // [places] none outside of the box
  std::vector<Index> cells_;                     // of all corners, of the probe
  std::unique_ptr<waves::PressureProbe> probe_;
  std::vector<std::optional<Ears::LocalSounds>> sounds_;  // [places]
};

}  // namespace idiophone::propagation
