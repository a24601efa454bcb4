#pragma once
// One body on one mesh, whose modes are computed with one material after the other.

#include <optional>
#include <vector>

#include "frequency_model.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "strain_products.hpp"

namespace idiophone::fitting {

class StrainedBody {
 public:
  /// Makes the mesh. @param solids  one body
  StrainedBody(const scene::Solids& solids, eigenmodes::MassMatrix mass);

  /// The same body with elements of one order less, for first fits that are a quarter of the work. None for orders
  /// below 5, whose modes would be too far away, for elements of one order only, and for a body that is stretched or
  /// reduced.
  /// @throws as the constructor
  [[nodiscard]] std::optional<StrainedBody> coarser() const;

  /// The same body with one side longer or shorter, and its mesh stretched with it. What holds it goes along. The grain
  /// keeps its direction.
  /// @param side  0 for the longest, to 2 for the shortest: mesh::Statistics::axes
  /// @throws deck::DeckError where a support is no longer on the surface
  [[nodiscard]] StrainedBody stretched(int side, double factor) const;

  /// The same body, which can only move as combinations of its lowest modes with its present material: with every other
  /// material its modes are found among these at once, and the mesh has no error. No fit of a measured body needs it.
  /// The test that counts how often the intervals hold the truth does: it fits a thousand synthetic bodies, by the same
  /// code as measured ones.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] StrainedBody reduced(int modes) const;

  [[nodiscard]] const TurnedMaterial& material() const { return material_; }    ///< of the last model, or of the scene
  [[nodiscard]] double volume() const { return statistics_.volume; }            ///< m3
  [[nodiscard]] const Vector3& extents() const { return statistics_.extents; }  ///< mesh::Statistics::extents
  [[nodiscard]] Vector3 direction(int side) const { return statistics_.axes.col(side); }
  [[nodiscard]] const Eigen::Matrix3d& directions() const { return statistics_.axes; }

  /// All modes up to a frequency (Hz) with a material, as a model for similar materials.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] FrequencyModel model(const TurnedMaterial& material, double up_to);

  /// The lowest modes with a material; fewer than `count` on a mesh with little room.
  /// @throws what eigenmodes::find_modes() throws
  [[nodiscard]] FrequencyModel lowest(const TurnedMaterial& material, int count);

  /// The same modes with a similar material, without another eigenvalue problem: the best ones in the space of the
  /// modes that were solved last (Rayleigh and Ritz). Exact for a common factor of all moduli; else, frequencies are
  /// too high by the square of the change times what modes beyond the last one take part.
  [[nodiscard]] FrequencyModel nearby(const TurnedMaterial& material);

  /// The frequencies of these modes alone, ascending, Hz. [modes]
  [[nodiscard]] Eigen::VectorXd frequencies_nearby(const TurnedMaterial& material) const;

  /// The axes of a material that is not turned, in the columns.
  [[nodiscard]] Eigen::Matrix3d axes() const { return body_.turn() * grain_; }

  /// Body::grain of a material with its turns.
  [[nodiscard]] Eigen::Matrix3d grain_of(const TurnedMaterial& material) const { return grain_ * material.turn(); }

  struct Antinode {
    Vector3 place;      ///< m
    Vector3 direction;  ///< of the motion, of length 1
  };
  /// Where the surface moves most in the modes of a multiplet together.
  /// @param multiplet  of the last model that this body made
  [[nodiscard]] Antinode antinode(const Multiplet& multiplet) const;

  /// Cents by which the mesh makes the multiplets of a model wrong, at most 100. [multiplets] Estimated
  /// for modes that are spread over the model (eigenmodes::spread_mesh_errors()), and filled_errors() for the others.
  /// By rule (accuracy::pitch_error()) where the elements can't be refined.
  /// @param model  the last one that this body made
  [[nodiscard]] std::vector<double> mesh_errors(const FrequencyModel& model) const;

 private:
  StrainedBody(scene::Body body, scene::Material material, double max_frequency, eigenmodes::MassMatrix mass,
               mesh::Mesh mesh);

  /// The body by itself, of the present material.
  [[nodiscard]] scene::Solids alone() const;
  [[nodiscard]] FrequencyModel solve(const TurnedMaterial& material, const eigenmodes::Options& options);
  [[nodiscard]] solid::StiffnessMatrix stiffness_of(const TurnedMaterial& material) const;
  [[nodiscard]] Eigen::MatrixXd energies_of(const TurnedMaterial& material) const;
  void take(const TurnedMaterial& material);
  [[nodiscard]] scene::Body unturned() const;

  scene::Body body_;
  Eigen::Matrix3d grain_;  ///< of the body in the deck; body_ has the present one
  TurnedMaterial material_;
  double max_frequency_;  ///< Hz
  eigenmodes::MassMatrix mass_;
  mesh::Mesh mesh_;
  mesh::Statistics statistics_;
  mesh::Part part_;
  motion::Attachments attachments_;
  Eigen::MatrixXd shapes_;            ///< of the modes that were solved last, [3 x nodes, modes]
  Eigen::VectorXd squares_;           ///< their w^2, (rad/s)^2
  solid::StiffnessMatrix stiffness_;  ///< of their material, turned as it was
  StrainProducts products_;           ///< of their shapes
  bool is_reduced_ = false;           ///< to these modes
  bool is_stretched_ = false;         ///< so that the deck's mesh is that of another body
  Eigen::MatrixXd factors_;           ///< the shapes of the last model are shapes_ times these
};

}  // namespace idiophone::fitting
