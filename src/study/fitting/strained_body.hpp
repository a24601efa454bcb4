#pragma once
// One body on one mesh, whose modes are computed with one material after the other.

#include "frequency_model.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::fitting {

class StrainedBody {
 public:
  /// Makes the mesh. @param solids  one body
  StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass);

  [[nodiscard]] double volume() const { return volume_; }  ///< m3

  /// All modes up to a frequency (Hz) with a material, as a model for similar materials.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] FrequencyModel model(const scene::Material& material, double up_to);

 private:
  /// The body by itself, of the present material.
  [[nodiscard]] scene::Solids alone() const;

  scene::Body body_;
  scene::Material material_;
  double max_frequency_;  ///< Hz
  eigenmodes::MassMatrix mass_;
  double volume_ = 0.0;
  mesh::Part part_;
  motion::Attachments attachments_;
};

}  // namespace idiophone::fitting
