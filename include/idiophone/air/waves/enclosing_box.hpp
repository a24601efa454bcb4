#pragma once
// A box in the air around all bodies, from whose surface the sound goes on to listeners anywhere.

#include <vector>

#include "idiophone/air/surface/emission.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::waves {

/// Cells from `from` to before `to` along each axis.
struct Enclosure {
  std::array<int, 3> from{}, to{};

  /// @param in_cells  see Grid::in_cells
  [[nodiscard]] bool contains(const Vector3& in_cells) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(in_cells[axis] >= from.at(axis) && in_cells[axis] < to.at(axis))) {
        return false;
      }
    }
    return true;
  }
};

/// One patch for each face of a cell on the box. A rank has those whose inner cell is its own.
class EnclosingBox {
 public:
  /// @param field  must outlive this object
  EnclosingBox(const WaveField& field, const Enclosure& enclosure);

  [[nodiscard]] std::size_t patches() const { return numbers_.size(); }
  /// Numbers of this rank's patches among those of all ranks.
  [[nodiscard]] const std::vector<std::int32_t>& numbers() const { return numbers_; }
  /// How many patches all ranks have.
  [[nodiscard]] std::int32_t global_patches() const { return global_patches_; }

  /// Takes the pressures of the present. Does not wait for an accelerator.
  void begin() { probe_->begin(); }
  /// Waits for an accelerator.
  /// @return the air at the box at the time of begin(): surface_pressure and pressure_gradient, which stay until the
  ///         next finish(). The rest does not change
  [[nodiscard]] const surface::Emission& finish();
  /// Both.
  [[nodiscard]] const surface::Emission& emission() {
    begin();
    return finish();
  }

 private:
  void add_side(const Subdomain& subdomain, const Enclosure& enclosure, std::size_t axis, int end);

  double cell_;
  std::vector<std::int32_t> numbers_;
  std::int32_t global_patches_ = 0;
  surface::Emission emission_;
  std::vector<Index> cells_;              // [patches x 2] numbers of those inside and outside of the box
  std::unique_ptr<PressureProbe> probe_;  // of these cells
};

}  // namespace idiophone::waves
