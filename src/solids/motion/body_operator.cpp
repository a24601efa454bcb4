#include "body_operator.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "state_exchange.hpp"

namespace idiophone::motion {

void BodyOperator::leave_out_held(std::span<double> values) const {
  for (std::size_t c = 0; c < size(); ++c) {
    values[c] = held[c] != 0 ? 0.0 : values[c];
  }
}

void BodyOperator::apply_factor(std::span<double> x) const {
  mass.apply_inverse_factor(x);
  leave_out_held(x);
}

void BodyOperator::receive_ghosts() {
  if (ghosts != nullptr) {
    StateExchange(part, ghosts).receive(state);
  }
}

void BodyOperator::displace(std::span<const double> moved, double factor) {
  std::ranges::fill(state, solid::NodeState{});
  for (std::size_t c = 0; c < size(); ++c) {
    node(c).displacement[c % 3] = moved[c] * factor;
  }
  receive_ghosts();
}

void BodyOperator::apply(std::span<const double> x, std::span<double> result) {
  std::ranges::copy(x, result.begin());
  apply_factor(result);
  for (std::size_t c = 0; c < size(); ++c) {
    node(c).velocity[c % 3] = result[c];
  }
  receive_ghosts();
  std::ranges::fill(force, solid::NodeForce{});
  solid.add_linear_stiffness_force(state, force);
  for (std::size_t c = 0; c < size(); ++c) {
    const std::size_t node = body.owned_begin + c / 3;
    result[c] = stiffness[node] * state[node].velocity[c % 3] - force[node].component[c % 3];
  }
  leave_out_held(result);
  mass.apply_transposed_inverse_factor(result);
}

SharedOperator::SharedOperator(BodyOperator& own, const BodyRows& rows, MPI_Comm communicator)
    : own_(own), rows_(rows), communicator_(communicator) {
  if (!rows.is_whole()) {
    x_.resize(own.size());
    y_.resize(own.size());
  }
}

void SharedOperator::apply(std::span<const double> x, std::span<double> y) {
  if (rows_.is_whole()) {
    own_.apply(x, y);
    return;
  }
  static_cast<void>(parallel::from_root(true, communicator_));
  apply_share(x, y);
}

void SharedOperator::help() {
  if (parallel::is_root(communicator_)) {
    return;
  }
  while (parallel::from_root(false, communicator_)) {
    apply_share({}, {});
  }
}

SharedOperator::End::~End() {
  static_cast<void>(parallel::from_root(false, communicator_));
}

void SharedOperator::apply_share(std::span<const double> x, std::span<double> y) {
  rows_.scatter(x, x_);
  own_.apply(x_, y_);
  rows_.gather(y_, y);
}

}  // namespace idiophone::motion
