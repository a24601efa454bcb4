#include "vibration.hpp"

#include <algorithm>

namespace idiophone::proxies {

namespace {

/// Springs that pull for a velocity, times the largest damping, as the dampers do.
std::vector<Spring> dampers_of(const Lattice& lattice) {
  std::vector<Spring> dampers = lattice.springs();
  for (Spring& damper : dampers) {
    damper.stiffness *= damper.damping / lattice.damping().stiffness;
    damper.tension = 0.0;
  }
  return dampers;
}

}  // namespace

Vibration::Vibration(const Lattice& lattice)
    : lattice_(&lattice), springs_(lattice), rigid_motion_(lattice), damping_(lattice.damping()) {
  if (!lattice.is_damped_evenly() && damping_.stiffness > 0.0) {
    dampers_.emplace(lattice.mesh().nodes, dampers_of(lattice));
  }
  for (auto* field : {&inverse_mass_, &displacement_, &velocity_, &load_, &force_, &effective_, &first_velocity_,
                      &first_acceleration_, &damped_}) {
    field->resize(padded_rows(lattice.masses().size()));
  }
  for (std::size_t i = 0; i < lattice.masses().size(); ++i) {
    inverse_mass_[i] = lattice.pinned()[i] ? Row{} : row_of(Vector3::Constant(1.0 / lattice.masses()[i]));
  }
}

void Vibration::tune(double tension, const Damping& damping) {
  tension_ = tension;
  damping_ = damping;
  find_effective_displacement();
}

void Vibration::set_state(std::span<const Vector3> displacement, std::span<const Vector3> velocity) {
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const bool is_pinned = lattice_->pinned()[i];
    displacement_[i] = is_pinned ? Row{} : row_of(displacement[i]);
    velocity_[i] = is_pinned ? Row{} : row_of(velocity[i]);
  }
  find_effective_displacement();
}

void Vibration::stop() {
  for (auto* field : {&displacement_, &velocity_, &effective_}) {
    std::ranges::fill(*field, Row{});
  }
}

void Vibration::load(std::span<const PointForce> forces) {
  if (is_loaded_) {
    std::ranges::fill(load_, Row{});
  }
  is_loaded_ = !forces.empty();
  for (const PointForce& applied : forces) {
    for (std::size_t i = 0; i < 3; ++i) {
      load_[applied.contact.masses[i]].lanes += row_of(applied.contact.shares[i] * applied.force).lanes;
    }
  }
  if (is_loaded_ && lattice_->is_free()) {
    rigid_motion_.remove_from_forces(load_);
  }
}

void Vibration::remove_rigid_motion() {
  if (lattice_->is_free()) {
    rigid_motion_.remove_from_motion(displacement_);
    rigid_motion_.remove_from_motion(velocity_);
    find_effective_displacement();
  }
}

FourRows Vibration::effective_displacement(const FourRows& u, const FourRows& v) const {
  const auto tension = static_cast<float>(tension_);
  return dampers_ ? tension * u : tension * (u + static_cast<float>(damping_.stiffness) * v);
}

std::size_t Vibration::packs() const {
  return springs_.packs() + (dampers_ ? dampers_->packs() : 0);
}

/// For a new state, tension or damping.
void Vibration::find_effective_displacement() {
  for (std::size_t i = 0; i < effective_.size(); i += rows_at_once) {
    put_four_rows(effective_displacement(four_rows(displacement_, i), four_rows(velocity_, i)), effective_, i);
  }
}

void Vibration::find_forces(const Rows& velocity) {
  if (is_loaded_) {
    std::ranges::copy(load_, force_.begin());
  }
  springs_.add_forces(effective_, force_);
  if (dampers_) {
    const auto factor = static_cast<float>(tension_ * damping_.stiffness);
    for (std::size_t i = 0; i < damped_.size(); i += rows_at_once) {
      put_four_rows(factor * four_rows(velocity, i), damped_, i);
    }
    dampers_->add_forces(damped_, force_);
  }
}

void Vibration::step(Integrator integrator, double step) {
  const auto single = static_cast<float>(step);
  integrator == Integrator::symplectic_euler ? step_symplectic(single) : step_improved(single);
}

void Vibration::step_symplectic(float step) {
  find_forces(velocity_);
  const auto loss = static_cast<float>(damping_.mass);
  for (std::size_t i = 0; i < force_.size(); i += rows_at_once) {
    const FourRows before = four_rows(velocity_, i);
    const FourRows v = before + step * (four_rows(inverse_mass_, i) * four_rows(force_, i) - loss * before);
    const FourRows u = four_rows(displacement_, i) + step * v;
    put_four_rows(v, velocity_, i);
    put_four_rows(u, displacement_, i);
    put_four_rows(effective_displacement(u, v), effective_, i);
    put_four_rows(FourRows{}, force_, i);
  }
}

void Vibration::step_improved(float step) {
  const auto loss = static_cast<float>(damping_.mass);
  find_forces(velocity_);
  for (std::size_t i = 0; i < force_.size(); i += rows_at_once) {
    const FourRows v = four_rows(velocity_, i);
    const FourRows acceleration = four_rows(inverse_mass_, i) * four_rows(force_, i) - loss * v;
    const FourRows next = v + step * acceleration;
    put_four_rows(acceleration, first_acceleration_, i);
    put_four_rows(next, first_velocity_, i);
    put_four_rows(effective_displacement(four_rows(displacement_, i) + step * v, next), effective_, i);
    put_four_rows(FourRows{}, force_, i);
  }
  find_forces(first_velocity_);
  for (std::size_t i = 0; i < force_.size(); i += rows_at_once) {
    const FourRows first = four_rows(first_velocity_, i), before = four_rows(velocity_, i);
    const FourRows acceleration = four_rows(inverse_mass_, i) * four_rows(force_, i) - loss * first;
    const FourRows u = four_rows(displacement_, i) + 0.5F * step * (before + first);
    const FourRows v = before + 0.5F * step * (four_rows(first_acceleration_, i) + acceleration);
    put_four_rows(u, displacement_, i);
    put_four_rows(v, velocity_, i);
    put_four_rows(effective_displacement(u, v), effective_, i);
    put_four_rows(FourRows{}, force_, i);
  }
}

bool Vibration::moves(double limit, double interval) {
  const RowLanes least = RowLanes{} + static_cast<float>(limit);
  const auto duration = static_cast<float>(interval);
  for (std::size_t count = 0; count < displacement_.size(); ++count) {
    const RowLanes u = displacement_[moving_].lanes, moved = duration * velocity_[moving_].lanes;
    const auto significant = (u > least) | (u < -least) | (moved > least) | (moved < -least);
    if ((significant[0] | significant[1] | significant[2]) != 0) {
      return true;
    }
    moving_ = moving_ + 1 < displacement_.size() ? moving_ + 1 : 0;
  }
  return false;
}

}  // namespace idiophone::proxies
