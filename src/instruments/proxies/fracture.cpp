#include "idiophone/instruments/proxies/fracture.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "pieces.hpp"

namespace idiophone::proxies {

namespace {

Vector3 direction_of(const TetrahedralMesh& mesh, const Spring& spring) {
  return (mesh.nodes[spring.b] - mesh.nodes[spring.a]).normalized();
}

/// m
double extension_of(const Fragment& fragment, const Spring& spring) {
  return direction_of(fragment.lattice->mesh(), spring)
      .dot(fragment.displacement[spring.b] - fragment.displacement[spring.a]);
}

/// A spring as a mass has it.
struct Pull {
  Vector3 direction;     // away from the mass
  double stress = 0.0;   // over the strength; negative: it is pressed
  double section = 0.0;  // m2
};

/// Stresses of all springs over the strength.
std::vector<double> stresses_of(const Fragment& fragment, const Strength& strength) {
  std::vector<double> stresses;
  for (const Spring& spring : fragment.lattice->springs()) {
    stresses.push_back(spring.stiffness * extension_of(fragment, spring) / (spring.section * strength.tensile));
  }
  return stresses;
}

/// Of the masses that have a spring with at least half the strength.
std::map<Index, std::vector<Pull>> pulls_of(const Lattice& lattice, std::span<const double> stresses) {
  constexpr double least_stress = 0.5;
  std::map<Index, std::vector<Pull>> pulls;
  for (std::size_t s = 0; s < stresses.size(); ++s) {
    if (stresses[s] >= least_stress) {
      pulls[lattice.springs()[s].a] = pulls[lattice.springs()[s].b] = {};
    }
  }
  for (std::size_t s = 0; s < stresses.size() && !pulls.empty(); ++s) {
    const Spring& spring = lattice.springs()[s];
    const Vector3 direction = direction_of(lattice.mesh(), spring);
    for (const auto& [mass, away] : {std::pair(spring.a, direction), std::pair(spring.b, Vector3(-direction))}) {
      if (const auto found = pulls.find(mass); found != pulls.end()) {
        found->second.push_back({.direction = away, .stress = stresses[s], .section = spring.section});
      }
    }
  }
  return pulls;
}

/// None for a mass that is not pulled to both sides.
std::optional<Overload> overload_of(std::span<const Pull> pulls, Index mass) {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const Pull& pull : pulls) {
    tensor += std::max(pull.stress, 0.0) * pull.section * pull.direction * pull.direction.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
  const Vector3 normal = solver.eigenvectors().col(2);
  double forwards = 0.0, backwards = 0.0, borne = 0.0;  // over the strength, m2
  for (const Pull& pull : pulls) {
    const double along = std::max(pull.stress, 0.0) * pull.section * pull.direction.dot(normal);
    (along > 0.0 ? forwards : backwards) += std::abs(along);
    borne += pull.section * std::pow(std::abs(pull.direction.dot(normal)), 3);
  }
  if (forwards == 0.0 || backwards == 0.0) {
    return {};
  }
  return Overload{.a = mass, .b = mass, .direction = normal, .ratio = (forwards + backwards) / borne};
}

/// Those that share no tetrahedron with one before them.
std::vector<Overload> greatest_apart(const Lattice& lattice, std::span<const Overload> all) {
  std::vector<Overload> chosen;
  std::vector<bool> is_near(lattice.masses().size());  // a chosen one
  for (const Overload& overload : all) {
    if (is_near[overload.a] || is_near[overload.b] || (overload.a == overload.b && !can_split(lattice, overload))) {
      continue;
    }
    chosen.push_back(overload);
    for (const auto& tetrahedron : lattice.mesh().tetrahedra) {
      if (std::ranges::any_of(tetrahedron, [&](Index mass) { return mass == overload.a || mass == overload.b; })) {
        for (const Index mass : tetrahedron) {
          is_near[mass] = true;
        }
      }
    }
  }
  return chosen;
}

}  // namespace

FragmentSums sums_of(const Fragment& fragment) {
  const Lattice& lattice = *fragment.lattice;
  FragmentSums sums;
  for (std::size_t i = 0; i < lattice.masses().size(); ++i) {
    const Vector3 momentum = lattice.masses()[i] * fragment.velocity[i];
    sums.mass += lattice.masses()[i];
    sums.momentum += momentum;
    sums.angular_momentum += lattice.mesh().nodes[i].cross(momentum);
    sums.kinetic_energy += 0.5 * momentum.dot(fragment.velocity[i]);
  }
  for (const Spring& spring : lattice.springs()) {
    sums.elastic_energy += 0.5 * spring.stiffness * std::pow(extension_of(fragment, spring), 2);
  }
  return sums;
}

std::vector<Overload> overloads(const Fragment& fragment, const Strength& strength) {
  const Lattice& lattice = *fragment.lattice;
  std::vector<Overload> all;
  const std::vector<double> stresses = stresses_of(fragment, strength);
  for (std::size_t s = 0; s < stresses.size(); ++s) {
    const Spring& spring = lattice.springs()[s];
    const double length = (lattice.mesh().nodes[spring.b] - lattice.mesh().nodes[spring.a]).norm();
    if (stresses[s] > 1.0 && length >= 2.0 * strength.shortest_spring) {
      all.push_back(
          {.a = spring.a, .b = spring.b, .direction = direction_of(lattice.mesh(), spring), .ratio = stresses[s]});
    }
  }
  for (const auto& [mass, pulls] : pulls_of(lattice, stresses)) {
    if (const std::optional<Overload> found = overload_of(pulls, mass); found && found->ratio > 1.0) {
      all.push_back(*found);
    }
  }
  std::ranges::stable_sort(all, std::greater(), &Overload::ratio);
  return greatest_apart(lattice, all);
}

std::vector<Fragment> broken(const Fragment& fragment, std::span<const Overload> overloads) {
  Pieces pieces(fragment);
  for (const Overload& overload : overloads) {
    overload.a == overload.b ? pieces.split_mass(overload.a, overload.direction)
                             : pieces.split_spring(overload.a, overload.b);
  }
  pieces.open_hinges();
  return pieces.fragments();
}

RigidVelocity take_rigid_motion(Fragment& fragment) {
  const Lattice& lattice = *fragment.lattice;
  if (!lattice.is_free()) {
    return {};
  }
  const Inertia& inertia = lattice.inertia();
  const Eigen::Matrix3d tensor = inertia_tensor(inertia.second);
  const auto rigid_part = [&](std::vector<Vector3>& field) {
    RigidVelocity rigid;
    Vector3 moment = Vector3::Zero();
    for (std::size_t i = 0; i < field.size(); ++i) {
      rigid.velocity += lattice.masses()[i] / inertia.mass * field[i];
      moment += lattice.masses()[i] * (lattice.mesh().nodes[i] - inertia.centre).cross(field[i]);
    }
    rigid.angular_velocity = tensor.inverse() * moment;
    for (std::size_t i = 0; i < field.size(); ++i) {
      field[i] -= rigid.velocity + rigid.angular_velocity.cross(lattice.mesh().nodes[i] - inertia.centre);
    }
    return rigid;
  };
  static_cast<void>(rigid_part(fragment.displacement));
  return rigid_part(fragment.velocity);
}

}  // namespace idiophone::proxies
