#pragma once
// One body on one mesh, whose modes are computed with one material after the other.

#include "frequency_model.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::fitting {

class StrainedBody {
 public:
  /// Makes the mesh. @param solids  one body
  StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass);

  [[nodiscard]] double volume() const { return statistics_.volume; }  ///< m3

  /// All modes up to a frequency (Hz) with a material, as a model for similar materials.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] FrequencyModel model(const scene::Material& material, double up_to);

  /// The lowest modes with a material; fewer than `count` on a mesh with little room.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] FrequencyModel lowest(const scene::Material& material, int count);

  /// Cents by which the mesh makes the multiplets of a model wrong, at most 100. [multiplets] Of hexahedra 0.15 of what
  /// one order less changes: of a block and a bar, orders 3 to 5, the error is 0.05 to 0.24 of it. Of tetrahedra, and
  /// of order 2, accuracy::pitch_error().
  /// @param model  of this body with the material
  [[nodiscard]] std::vector<double> mesh_errors(const FrequencyModel& model, const scene::Material& material) const;

 private:
  /// The body by itself, of the present material.
  [[nodiscard]] scene::Solids alone() const;
  [[nodiscard]] FrequencyModel solve(const scene::Material& material, const eigenmodes::Options& options);
  [[nodiscard]] std::vector<double> errors_by_rule(const FrequencyModel& model, const scene::Material& material) const;

  scene::Body body_;
  scene::Material material_;
  double max_frequency_;  ///< Hz
  eigenmodes::MassMatrix mass_;
  mesh::Statistics statistics_;
  mesh::Part part_;
  motion::Attachments attachments_;
};

}  // namespace idiophone::fitting
