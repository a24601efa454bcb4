#pragma once
// Bodies of a deck: their meshes, constraints, supports and initial motion.

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/meshing_settings.hpp"
#include "idiophone/scene/signal.hpp"

namespace idiophone::scene {

/// Which directions a constraint holds: x, y, z.
using Axes = std::array<bool, 3>;

/// A physical group of the mesh held still in some directions.
struct FixedGroup {
  std::string group;
  Axes axes = {true, true, true};
  bool hinge = false;  ///< its nodes must lie on one straight line, about which the body is free to turn
  deck::Location where;
};

/// A group driven along a path: turned about an axis by rotation * signal(t), then displaced by displacement *
/// signal(t); only the named axes are constrained, and all of them if it rotates.
struct DrivenGroup {
  std::string group;
  Vector3 displacement = Vector3::Zero();  ///< m
  Vector3 rotation = Vector3::Zero();      ///< axis times angle, rad
  Vector3 pivot = Vector3::Zero();         ///< a point of the axis, m
  Axes axes = {true, true, true};
  Signal signal;
  deck::Location where;

  /// Whether the group moves; if not, it is fixed.
  [[nodiscard]] bool moves() const { return !displacement.isZero(0.0) || !rotation.isZero(0.0); }
};

/// A patch of the surface: all within `radius` of the point, or the one surface triangle at the point if it is 0.
struct PatchPlace {
  Vector3 at = Vector3::Zero();  ///< m, in the body's reference configuration
  double radius = 0.0;           ///< m
  deck::Location where;
};

/// A spring and a dashpot in parallel, from a patch to the ground; they act in all directions.
struct Support {
  std::string name;
  PatchPlace place;
  double stiffness = 0.0;  ///< N/m, of the whole patch
  double damping = 0.0;    ///< N s/m, of the whole patch
};

/// A surface inside the body, a physical group of the mesh, along which it breaks.
struct FractureSurface {
  std::string group;
  double strength = 0.0;                                            ///< tensile stress across it at which it breaks, Pa
  double shear_strength = std::numeric_limits<double>::infinity();  ///< shear stress in it at which it breaks, Pa
  double energy = 0.0;                                              ///< that breaking takes, J/m2; 0: it breaks at once
  bool contact = false;  ///< broken faces press on each other where they close
  deck::Location where;
};

/// Selective mass scaling of a body of hexahedra (solid/added_mass.hpp).
struct MassScalingLimit {
  double shift = 0.0;  ///< by which it may lower audible frequencies, cents
};

/// The body moves as a rigid body and by its modes (modal_bodies/modal_basis.hpp). Either `up_to` or `count` is set.
struct ModalModel {
  std::optional<double> up_to;  ///< all modes up to this frequency, Hz
  std::optional<int> count;     ///< or so many, the lowest
  /// Vibrations may be large: this share of the energy of stretching may be left out. None: they are small.
  std::optional<double> stretching_tolerance = std::nullopt;
  deck::Location where;
};

/// A part of a body with a material of its own: a physical group of elements of the mesh, or a layer of a thin body.
struct MaterialRegion {
  std::string name;                                     ///< the group's; of a layer, its number from 1
  std::size_t material = 0;                             ///< index into Scene::materials
  Eigen::Matrix3d grain = Eigen::Matrix3d::Identity();  ///< as Body::grain
  double thickness = 0.0;                               ///< of a layer, m; 0 of a group
  deck::Location where;
};

/// A fixed group that is held away from its place.
struct StretchedGroup {
  std::string group;
  Vector3 displacement = Vector3::Zero();  ///< m
};

/// What strains a body before it vibrates. It rests where its elastic forces are in equilibrium.
struct Prestress {
  /// The same in all of the undeformed body: Pa, symmetric, positive where it pulls; axes of the mesh file.
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  deck::Location where;
  double temperature = 0.0;               ///< change since the body was without stress, K
  std::optional<StretchedGroup> stretch;  ///< none: the fixed groups are in their places
};

/// One deformable body.
struct Body {
  std::string name;
  std::filesystem::path mesh;         ///< absolute or from the working directory; docs/use/meshes.md lists the formats
  std::optional<std::string> object;  ///< of a file with several, its name; none: the whole file
  std::optional<double> file_mass;    ///< that a glTF file gives the object, kg
  std::map<std::string, double> parameters;  ///< for a .geo file's DefineConstant names; `size` for the others but .msh
  Vector3 rotation = Vector3::Zero();        ///< of the mesh about its file's origin, axis times angle, rad
  Vector3 position = Vector3::Zero();        ///< of the mesh's origin after the rotation, m
  element::Type element = element::tet10;
  std::optional<double> thickness;  ///< m: the mesh is the middle surface of a wall; of all its layers
  std::optional<MassScalingLimit> mass_scaling;
  MeshingSettings meshing;
  std::optional<ModalModel> modal;  ///< none: finite elements
  std::size_t material = 0;         ///< index into Scene::materials; of the first region where there are regions
  Eigen::Matrix3d grain =
      Eigen::Matrix3d::Identity();  ///< columns: the axes of a material that is not isotropic, in the mesh file
  /// Every element lies in one of them; layers are in the order of the surface's normal. Empty: `material` everywhere.
  std::vector<MaterialRegion> regions;
  std::optional<Prestress> prestress;
  std::vector<FixedGroup> fixed;
  std::vector<DrivenGroup> driven;
  std::vector<Support> supports;
  std::vector<FractureSurface> fracture;         ///< empty: it cannot break
  std::optional<std::filesystem::path> springs;  ///< CSV file with values of single springs of its proxy
  Vector3 velocity = Vector3::Zero();            ///< initial, m/s
  Vector3 spin = Vector3::Zero();                ///< initial angular velocity about the centre of mass, rad/s
  deck::Location where;
  deck::Location mesh_where;
  deck::Location object_where;
  deck::Location thickness_where;
  std::map<std::string, deck::Location> parameters_where;

  /// The rotation as a matrix.
  [[nodiscard]] Eigen::Matrix3d turn() const;

  /// The material's axes in the undeformed body, in the columns.
  [[nodiscard]] Eigen::Matrix3d material_axes() const { return turn() * grain; }

  /// The stress that its prestress gives to the undeformed body, Pa, in the axes of the scene; zero without. That of a
  /// change of temperature is left out.
  [[nodiscard]] Eigen::Matrix3d initial_stress() const;

  /// Whether it is a wall of layers.
  [[nodiscard]] bool has_layers() const { return !regions.empty() && regions.front().thickness > 0; }

  /// Whether one material without prestress fills it. The rules for meshes hold for such bodies only.
  [[nodiscard]] bool is_one_material_at_rest() const { return regions.empty() && !prestress; }

  /// The regions, or all of the body as one without a name.
  [[nodiscard]] std::vector<MaterialRegion> all_regions() const;
};

/// A body with a recorded motion of its surface. It radiates and occludes, but takes part in no contact.
struct RecordedBody {
  std::string name;
  std::filesystem::path recording;  ///< NAME_surface.h5 of a run, or another simulator's
  deck::Location where;             ///< of the file's name
};

}  // namespace idiophone::scene
