#include "vertex_shapes.hpp"

#include <algorithm>
#include <cstring>

namespace idiophone::bodies {

VertexShapes::VertexShapes(const Eigen::MatrixXd& shapes)
    : vertices_(shapes.rows() / 3),
      modes_(shapes.cols()),
      shapes_((shapes.rows() + numbers_in_block - 1) / numbers_in_block * modes_),
      displacements_(shapes.rows() + numbers_in_block),
      velocities_(displacements_.size()) {
  for (Eigen::Index row = 0; row < shapes.rows(); ++row) {
    const Eigen::Index block = row / numbers_in_block, place = row % numbers_in_block;
    for (Eigen::Index mode = 0; mode < modes_; ++mode) {
      shapes_[block * modes_ + mode][place / numbers_in_pack][place % numbers_in_pack] =
          static_cast<float>(shapes(row, mode));
    }
  }
}

void VertexShapes::find(const Eigen::Ref<const Eigen::VectorXd>& places,
                        const Eigen::Ref<const Eigen::VectorXd>& rates) {
  const Eigen::VectorXf place = places.cast<float>(), rate = rates.cast<float>();
  const auto blocks = std::ssize(shapes_) / std::max<Eigen::Index>(modes_, 1);
  for (Eigen::Index block = 0; block < blocks; ++block) {
    Block moved{}, moving{};
    for (Eigen::Index mode = 0; mode < modes_; ++mode) {
      const Block& shape = shapes_[block * modes_ + mode];
      for (std::size_t i = 0; i < shape.size(); ++i) {
        moved[i] += place[mode] * shape[i];
        moving[i] += rate[mode] * shape[i];
      }
    }
    std::memcpy(&displacements_[block * numbers_in_block], &moved, sizeof(moved));
    std::memcpy(&velocities_[block * numbers_in_block], &moving, sizeof(moving));
  }
}

}  // namespace idiophone::bodies
