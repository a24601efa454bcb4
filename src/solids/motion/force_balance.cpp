#include "force_balance.hpp"

#include <algorithm>
#include <numeric>

namespace idiophone::motion {

using parallel::petsc;

namespace {

std::size_t size_of(const mesh::BodyPart& body) {
  return body.owned_end - body.owned_begin;
}

}  // namespace

ForceBalance::ForceBalance(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
                           const FiniteElementDynamics& dynamics, std::size_t body, bool is_loaded)
    : part_(part),
      body_(part.bodies[body]),
      material_(solids.materials[solids.bodies[body].material]),
      solid_(dynamics.solid(body)),
      support_(part.node_ids.size()),
      load_(3 * size_of(body_)),
      state_(part.node_ids.size()),
      force_(part.node_ids.size()) {
  components_.end = static_cast<PetscInt>(load_.size());
  components_.number.assign(3 * part.node_ids.size(), -1);
  const auto own = std::span(components_.number).subspan(3UL * body_.owned_begin, load_.size());
  std::iota(own.begin(), own.end(), 0);
  dynamics.loads().add_support_stiffness(support_);
  if (is_loaded) {
    add_gravity(dynamics.model(body).masses(), solids.gravity);
    for (std::size_t p = 0; p < solids.plucks.size(); ++p) {
      if (solids.plucks[p].body == body) {
        add_pluck(attachments.plucks[p], solids.plucks[p].force);
      }
    }
  }
  dynamics.constraints().place(0.0, state_);
  for (const Index component : dynamics.constraints().held_components()) {
    if (component >= 3 * body_.owned_begin && component < 3 * body_.owned_end) {
      held_.push_back(component - 3 * body_.owned_begin);
    }
  }
}

bool ForceBalance::is_held() const {
  return held_.size() >= 6 || std::ranges::any_of(support_, [](double stiffness) { return stiffness > 0; });
}

double ForceBalance::load_norm() const {
  return Eigen::Map<const Eigen::VectorXd>(load_.data(), std::ssize(load_)).norm();
}

void ForceBalance::residual(std::span<const double> u, std::span<double> unbalanced) {
  const std::vector<NodeState> places = state_;
  set_displacements(u);
  std::ranges::fill(force_, NodeForce{});
  solid_.add_internal_force(state_, force_);
  for (std::size_t c = 0; c < size(); ++c) {
    const std::size_t node = body_.owned_begin + c / 3;
    unbalanced[c] = support_[node] * u[c] - force_[node].component[c % 3] - fraction_ * load_[c];
  }
  state_ = places;
  for (const Index c : held_) {
    const Index node = body_.owned_begin + c / 3;
    unbalanced[c] = stiffness_scale() * (u[c] - fraction_ * state_[node].displacement[c % 3]);
  }
}

void ForceBalance::jacobian(std::span<const double> u, Mat matrix) {
  petsc(MatZeroEntries(matrix));
  const std::vector<NodeState> places = state_;
  set_displacements(u);
  add_tangent_stiffness(part_, body_, solid_, &solid::Solid::relaxed_elasticity, state_, components_, matrix);
  state_ = places;
  for (std::size_t c = 0; c < size(); ++c) {
    const double stiffness = support_[body_.owned_begin + c / 3];
    petsc(MatSetValue(matrix, static_cast<PetscInt>(c), static_cast<PetscInt>(c), stiffness, ADD_VALUES));
  }
  petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatZeroRows(matrix, static_cast<PetscInt>(held_.size()), held_.data(), stiffness_scale(), nullptr, nullptr));
}

parallel::Handle<Mat> ForceBalance::create_tangent() const {
  parallel::Handle<Mat> tangent = create_matrix(std::span(&body_, 1), components_, PETSC_COMM_SELF);
  petsc(MatSetOption(tangent, MAT_KEEP_NONZERO_PATTERN, PETSC_TRUE));
  return tangent;
}

void ForceBalance::add_gravity(std::span<const double> masses, const Vector3& gravity) {
  for (std::size_t c = 0; c < load_.size(); ++c) {
    load_[c] += masses[c / 3] * gravity[static_cast<Eigen::Index>(c % 3)];
  }
}

void ForceBalance::add_pluck(const mesh::Patch& patch, const Vector3& force) {
  for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
    for (int i = 0; i < 3; ++i) {
      const Index component = 3 * (patch.nodes[n] - body_.owned_begin) + i;
      load_[component] += patch.shares[n] * force[i];
    }
  }
}

void ForceBalance::set_displacements(std::span<const double> u) {
  for (std::size_t c = 0; c < size(); ++c) {
    state_[body_.owned_begin + c / 3].displacement[c % 3] = u[c];
  }
}

double ForceBalance::stiffness_scale() const {
  const auto& first = std::span(body_.elements);
  return material_.young * (part_.reference[first[0]] - part_.reference[first[1]]).norm();
}

}  // namespace idiophone::motion
