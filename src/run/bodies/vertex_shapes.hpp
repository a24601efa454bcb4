#pragma once
// The shapes of modes at the vertices of a surface. They are the largest part of a modal body, and each audio sample
// reads them: once, in the order of the memory, for displacements and velocities together.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "idiophone/foundation/vector_register.hpp"

namespace idiophone::bodies {

/// In single precision, which rounds a vibration by 1e-7 of its loudest mode.
class VertexShapes {
 public:
  VertexShapes() = default;
  /// @param shapes  [3 x vertices, modes] kg^-1/2
  explicit VertexShapes(const Eigen::MatrixXd& shapes);

  /// Finds the vibration of the vertices.
  /// @param places  [modes] kg^1/2 m
  /// @param rates   [modes] kg^1/2 m/s
  void find(const Eigen::Ref<const Eigen::VectorXd>& places, const Eigen::Ref<const Eigen::VectorXd>& rates);

  using Field = Eigen::Map<const Eigen::Matrix3Xf>;
  [[nodiscard]] Field displacements() const { return {displacements_.data(), 3, vertices_}; }  ///< m
  [[nodiscard]] Field velocities() const { return {velocities_.data(), 3, vertices_}; }        ///< m/s

 private:
  using Pack = float __attribute__((vector_size(register_size)));
  static constexpr Eigen::Index numbers_in_pack = register_size / sizeof(float);
  /// Components of vertices that are computed at once, so that no sum waits for its last term.
  using Block = std::array<Pack, 4>;
  static constexpr Eigen::Index numbers_in_block = 4 * numbers_in_pack;

  Eigen::Index vertices_ = 0, modes_ = 0;
  std::vector<Block> shapes_;                      // [blocks][modes]
  std::vector<float> displacements_, velocities_;  // [3 x vertices, and zeros up to whole blocks]
};

}  // namespace idiophone::bodies
