#include "strained_body.hpp"

#include <algorithm>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "strain_products.hpp"

namespace idiophone::fitting {

StrainedBody::StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass)
    : body_(solids.bodies.front()),
      material_(solids.materials[body_.material]),
      max_frequency_(solids.max_frequency),
      mass_(mass) {
  body_.material = 0;
  const std::vector<mesh::Mesh> meshes = {mesh::read_mesh(body_)};
  volume_ = mesh::statistics(meshes.front()).volume;
  attachments_ = motion::attach(alone(), meshes);
  part_ = mesh::distribute(meshes, MPI_COMM_SELF);
}

scene::Solids StrainedBody::alone() const {
  scene::Solids result;
  result.bodies = {&body_, 1};
  result.materials = {&material_, 1};
  result.max_frequency = max_frequency_;
  return result;
}

FrequencyModel StrainedBody::model(const scene::Material& material, double up_to) {
  material_ = material;
  std::vector<StrainedMode> modes;
  for (const eigenmodes::Mode& mode :
       eigenmodes::find_modes(alone(), part_, attachments_, {.count = 1, .up_to = up_to, .mass = mass_}, MPI_COMM_SELF)
           .modes) {
    modes.push_back({mode.frequency, strain_products(part_, mode.shape)});
  }
  std::ranges::sort(modes, {}, &StrainedMode::frequency);  // a loss factor shifts each a little
  return {modes, material, body_.material_axes()};
}

}  // namespace idiophone::fitting
