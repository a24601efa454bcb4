#pragma once
// The surface of a body that moves by its modes. The low-pass acts on the body's coordinates, which are few, and not on
// triangles and vertices: rigid motion and modes of the filtered coordinates give pressures and positions once in each
// audio sample. This leaves out the tilting of the normals by the vibration and the residual displacement, both of
// second order.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "idiophone/air/surface/low_pass.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "vertex_shapes.hpp"

namespace idiophone::bodies {

class ModalSurface {
 public:
  /// The undeformed surface of a body.
  struct Shape {
    std::vector<mesh::Triangle> triangles;  ///< as places among the vertices
    std::vector<std::size_t> nodes;         ///< [vertices] as nodes of the basis
    std::vector<Vector3> positions;         ///< [vertices] m
    Vector3 centre;                         ///< of mass, m
  };
  ModalSurface(const modal_bodies::ModalBasis& basis, const Shape& shape, const surface::Sampling& sampling);

  /// Begins with a steady motion, as surface::Surface does.
  /// @param pressure  [triangles] z v.n, Pa
  /// @param position  [3 x vertices] m
  void start(const motion::ModalState& state, std::span<double> pressure, std::span<double> position);

  /// Takes the state at the end of one more read.
  void read(const motion::ModalState& state);

  /// Ends an audio sample, after all its reads. Arguments as for start().
  void take(std::span<double> pressure, std::span<double> position);

  /// Largest displacement of a vertex by the modes since the start or a restart, m.
  [[nodiscard]] double largest_vibration() const { return std::sqrt(largest_square_); }

  /// Largest root mean square of the rotation angles in the body since then, where its basis has them, rad.
  [[nodiscard]] double largest_rotation() const { return std::sqrt(largest_rotation_square_); }

  /// Coordinates of a body: as many rows as the archive has.
  [[nodiscard]] static std::size_t coordinates(const modal_bodies::ModalBasis& basis);
  /// All that decides the future, between two audio samples.
  void archive(std::size_t coordinate, parallel::ArchiveRow& row);

 private:
  void find(const Eigen::VectorXd& rates, const Eigen::VectorXd& coordinates, std::span<double> pressure,
            std::span<double> position);
  void find_pressures(const Eigen::VectorXd& rates, std::span<double> pressure);
  void find_positions(const Eigen::VectorXd& coordinates, std::span<double> position);

  double read_rate_;  ///< reads per second
  VertexShapes vibration_;
  std::vector<Index> corners_;                  ///< see surface::corner_places()
  std::array<std::vector<double>, 3> normals_;  ///< [padded triangles] of the undeformed body, times z/3
  std::vector<double> velocities_;              ///< [3 x vertices, and one more value to read] in the body's frame, m/s
  std::vector<double> pressures_;               ///< [padded triangles] z times the mean normal velocity, Pa
  Eigen::Matrix3Xd arms_;                       ///< [vertices] X - C, m
  Eigen::Matrix3Xd reference_;                  ///< [vertices] X, m
  Eigen::MatrixXd rotation_;         ///< [modes x modes] modal_bodies::Stretching::rotation; empty where there is none
  Eigen::VectorXd before_;           ///< coordinates at the last read
  std::vector<double> coordinates_;  ///< [reads x padded coordinates] of this audio sample
  std::vector<double> rates_;        ///< likewise, means over each read
  std::size_t reads_ = 0;            ///< of this audio sample so far
  double largest_square_ = 0.0;      ///< of the vibration, m2
  double largest_rotation_square_ = 0.0;
  surface::LowPass coordinate_filter_;
  surface::LowPass rate_filter_;
};

}  // namespace idiophone::bodies
