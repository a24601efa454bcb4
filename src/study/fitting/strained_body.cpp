#include "strained_body.hpp"

#include <algorithm>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "strain_products.hpp"

namespace idiophone::fitting {

StrainedBody::StrainedBody(scene::Scene scene, eigenmodes::MassMatrix mass) : scene_(std::move(scene)), mass_(mass) {
  const std::vector<mesh::Mesh> meshes = {mesh::read_mesh(scene_.bodies.front())};
  volume_ = mesh::statistics(meshes.front()).volume;
  attachments_ = motion::attach(scene_, meshes);
  part_ = mesh::distribute(meshes, MPI_COMM_SELF);
}

FrequencyModel StrainedBody::model(const scene::Material& material, double up_to) {
  const scene::Body& body = scene_.bodies.front();
  scene_.materials[body.material] = material;
  std::vector<StrainedMode> modes;
  for (const eigenmodes::Mode& mode :
       eigenmodes::find_modes(scene_, part_, attachments_, {.count = 1, .up_to = up_to, .mass = mass_}, MPI_COMM_SELF)
           .modes) {
    modes.push_back({mode.frequency, strain_products(part_, mode.shape)});
  }
  std::ranges::sort(modes, {}, &StrainedMode::frequency);  // a loss factor shifts each a little
  return {modes, material, body.material_axes()};
}

}  // namespace idiophone::fitting
