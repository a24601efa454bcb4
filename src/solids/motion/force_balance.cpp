#include "force_balance.hpp"

#include <algorithm>

namespace idiophone::motion {

using parallel::petsc;

ForceBalance::ForceBalance(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
                           const FiniteElementDynamics& dynamics, std::vector<std::size_t> bodies, bool is_loaded)
    : part_(part),
      dynamics_(dynamics),
      bodies_(std::move(bodies)),
      material_(solids.materials[solids.bodies[bodies_.front()].material]),
      support_(part.node_ids.size()),
      places_(part.node_ids.size()),
      state_(part.node_ids.size()),
      force_(part.node_ids.size()) {
  number_components();
  load_.resize(place_of_unknown_.size());
  dynamics.loads().add_support_stiffness(support_);
  if (is_loaded) {
    add_gravity(solids.gravity);
    for (std::size_t p = 0; p < solids.plucks.size(); ++p) {
      if (std::ranges::binary_search(bodies_, solids.plucks[p].body)) {
        add_pluck(attachments.plucks[p], solids.plucks[p].force);
      }
    }
  }
  dynamics.constraints().place(0.0, places_);
  for (const std::size_t body : bodies_) {
    for (const Index component : dynamics.constraints().held_components(body)) {
      held_.push_back(components_.number[component]);
    }
  }
}

void ForceBalance::number_components() {
  components_.number.assign(3 * part_.node_ids.size(), -1);
  for (const std::size_t body : bodies_) {
    for (Index c = 3 * part_.bodies[body].owned_begin; c < 3 * part_.bodies[body].owned_end; ++c) {
      components_.number[c] = components_.end++;
      place_of_unknown_.push_back(c);
    }
  }
}

bool ForceBalance::is_held() const {
  return held_.size() >= 6 ||
         std::ranges::any_of(place_of_unknown_, [&](Index component) { return support_[component / 3] > 0; });
}

double ForceBalance::load_norm() const {
  return Eigen::Map<const Eigen::VectorXd>(load_.data(), std::ssize(load_)).norm();
}

void ForceBalance::residual(std::span<const double> u, std::span<double> unbalanced) {
  set_displacements(u);
  std::ranges::fill(force_, NodeForce{});
  for (const std::size_t body : bodies_) {
    dynamics_.solid(body).add_internal_force(state_, force_);
  }
  dynamics_.joints().add_force(state_, force_);
  for (std::size_t c = 0; c < size(); ++c) {
    const Index node = place_of_unknown_[c] / 3;
    unbalanced[c] = support_[node] * u[c] - force_[node].component[place_of_unknown_[c] % 3] - fraction_ * load_[c];
  }
  for (const Index c : held_) {
    const double place = places_[place_of_unknown_[c] / 3].displacement[place_of_unknown_[c] % 3];
    unbalanced[c] = stiffness_scale() * (u[c] - fraction_ * place);
  }
}

void ForceBalance::jacobian(std::span<const double> u, Mat matrix) {
  petsc(MatZeroEntries(matrix));
  set_displacements(u);
  for (const std::size_t body : bodies_) {
    add_tangent_stiffness(part_, part_.bodies[body], dynamics_.solid(body), &solid::Solid::relaxed_elasticity, state_,
                          components_, matrix);
  }
  add_joint_stiffness(dynamics_.joints(), state_, components_, matrix);
  for (std::size_t c = 0; c < size(); ++c) {
    const double stiffness = support_[place_of_unknown_[c] / 3];
    petsc(MatSetValue(matrix, static_cast<PetscInt>(c), static_cast<PetscInt>(c), stiffness, ADD_VALUES));
  }
  petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatZeroRows(matrix, static_cast<PetscInt>(held_.size()), held_.data(), stiffness_scale(), nullptr, nullptr));
}

parallel::Handle<Mat> ForceBalance::create_tangent() const {
  parallel::Handle<Mat> tangent = create_matrix(part_.bodies, components_, Coupling::of_all_axes, PETSC_COMM_SELF,
                                                joints::coupled_nodes(dynamics_.joints().all()));
  petsc(MatSetOption(tangent, MAT_KEEP_NONZERO_PATTERN, PETSC_TRUE));
  return tangent;
}

void ForceBalance::add_gravity(const Vector3& gravity) {
  for (const std::size_t body : bodies_) {
    const std::span<const double> masses = dynamics_.model(body).masses();
    const PetscInt first = components_.number[3UL * part_.bodies[body].owned_begin];
    for (std::size_t c = 0; c < 3 * masses.size(); ++c) {
      load_[first + c] += masses[c / 3] * gravity[static_cast<Eigen::Index>(c % 3)];
    }
  }
}

void ForceBalance::add_pluck(const mesh::Patch& patch, const Vector3& force) {
  for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
    for (int i = 0; i < 3; ++i) {
      load_[components_.number[3UL * patch.nodes[n] + i]] += patch.shares[n] * force[i];
    }
  }
}

void ForceBalance::set_displacements(std::span<const double> u) {
  for (std::size_t c = 0; c < size(); ++c) {
    state_[place_of_unknown_[c] / 3].displacement[place_of_unknown_[c] % 3] = u[c];
  }
}

double ForceBalance::stiffness_scale() const {
  const auto& first = std::span(part_.bodies[bodies_.front()].elements);
  return material_.young * (part_.reference[first[0]] - part_.reference[first[1]]).norm();
}

}  // namespace idiophone::motion
