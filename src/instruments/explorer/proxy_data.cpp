#include "proxy_data.hpp"

#include <Eigen/LU>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/foundation/web/web_page.hpp"

namespace idiophone::explorer {

nlohmann::json proxy_data(const proxies::Lattice& lattice) {
  if (lattice.is_under_tension() || !lattice.is_damped_evenly()) {
    throw std::runtime_error(
        "the page computes no springs with a length or a damping of their own; leave the views spring_length and "
        "spring_damping out of the mesh, and such values out of bodies.NAME.springs");
  }
  std::vector<double> nodes, inverse_masses, stiffness;
  for (std::size_t i = 0; i < lattice.masses().size(); ++i) {
    const Vector3& node = lattice.mesh().nodes[i];
    nodes.insert(nodes.end(), node.begin(), node.end());
    inverse_masses.push_back(lattice.pinned()[i] ? 0.0 : 1.0 / lattice.masses()[i]);
  }
  std::vector<std::uint32_t> a, b, surface;
  for (const proxies::Spring& spring : lattice.springs()) {
    a.push_back(static_cast<std::uint32_t>(spring.a));
    b.push_back(static_cast<std::uint32_t>(spring.b));
    stiffness.push_back(spring.stiffness);
  }
  for (const auto& triangle : lattice.mesh().surface) {
    surface.insert(surface.end(), triangle.begin(), triangle.end());
  }
  const proxies::Inertia& inertia = lattice.inertia();
  const Eigen::Matrix3d inverse = inertia_tensor(inertia.second).inverse();  // symmetric
  return {{"free", lattice.is_free()},
          {"centre", std::vector<double>(inertia.centre.begin(), inertia.centre.end())},
          {"inverseInertia", std::vector<double>(inverse.data(), inverse.data() + inverse.size())},
          {"damping", {{"mass", lattice.damping().mass}, {"stiffness", lattice.damping().stiffness}}},
          {"largest", lattice.largest_angular_frequency()},
          {"nodes", web::encoded(nodes)},
          {"mass", web::encoded(lattice.masses())},
          {"inverse_mass", web::encoded(inverse_masses)},
          {"a", web::encoded(a)},
          {"b", web::encoded(b)},
          {"stiffness", web::encoded(stiffness)},
          {"surface", web::encoded(surface)}};
}

}  // namespace idiophone::explorer
