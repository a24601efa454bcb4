#include "modal_shapes.hpp"

namespace idiophone::motion {

ModalShapes::ModalShapes(const ModalBasis& basis)
    : modes_(basis.modes()), packs_((basis.nodes() + solid::lanes - 1) / solid::lanes), shapes_(packs_ * modes_) {
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        shapes_[node / solid::lanes * modes_ + mode].at(axis)[node % solid::lanes] =
            basis.shapes[3 * (mode * basis.nodes() + node) + axis];
      }
    }
  }
}

ModalShapes::Vibration ModalShapes::vibration(std::size_t pack, std::span<const double> places,
                                              std::span<const double> rates) const {
  Pack x = {}, y = {}, z = {}, u = {}, v = {}, w = {};  // in registers
  const PackVector* shape = &shapes_[pack * modes_];
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    const auto& [a, b, c] = shape[mode];
    x += places[mode] * a;
    y += places[mode] * b;
    z += places[mode] * c;
    u += rates[mode] * a;
    v += rates[mode] * b;
    w += rates[mode] * c;
  }
  return {{x, y, z}, {u, v, w}};
}

void ModalShapes::add_products(std::size_t pack, const PackVector& force, std::span<Pack> sums) const {
  const PackVector* shape = &shapes_[pack * modes_];
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    sums[mode] += shape[mode][0] * force[0] + shape[mode][1] * force[1] + shape[mode][2] * force[2];
  }
}

Vector3 ModalShapes::at(std::size_t mode, std::size_t node) const {
  const PackVector& shape = shapes_[node / solid::lanes * modes_ + mode];
  const std::size_t lane = node % solid::lanes;
  return {shape[0][lane], shape[1][lane], shape[2][lane]};
}

}  // namespace idiophone::motion
