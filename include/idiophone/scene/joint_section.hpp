#pragma once
// Joints of a deck: what ties surfaces of bodies together.

#include <array>
#include <optional>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/body.hpp"

namespace idiophone::scene {

/// A surface that a joint holds.
struct JoinedSurface {
  std::size_t body = 0;  ///< index into Scene::bodies
  std::string group;     ///< physical group of surfaces of the body's mesh
  deck::Location where;
};

/// Stress over stretch of a thin elastic layer, Pa/m; or force over stretch of a spring or hinge, N/m.
struct JointStiffness {
  double normal = 0.0;      ///< of a layer: pressure or pull over the change of its thickness; of a spring: along it
  double tangential = 0.0;  ///< of a layer: shear stress over the shift of its two sides; of a spring: across it
};

/// Glue is a layer between whole surfaces. A bolt without a shank is a layer under a washer; one with a shank is a beam
/// between two washers. A spring acts between the middles of two surfaces. A hinge ties the two ends of an axis.
enum class JointType { glue, bolt, spring, hinge };

/// Of a hinge, or of the shank of a bolt.
struct JointAxis {
  Vector3 begin = Vector3::Zero();  ///< m
  Vector3 end = Vector3::Zero();    ///< m; another place
};

/// What resists the turning of a hinge: with the sine s of the angle, the moment is stiffness (s + damping s') times
/// its cosine.
struct HingeTurning {
  double stiffness = 0.0;  ///< N m/rad
  double damping = 0.0;    ///< relaxation time, s
};

/// A round beam from one end of the axis to the other one. It holds what lies under a washer at each end.
struct Shank {
  double radius = 0.0;   ///< m
  double washer = 0.0;   ///< radius of both washers, m
  double young = 0.0;    ///< Young's modulus, Pa
  double poisson = 0.0;  ///< Poisson's ratio
  double preload = 0.0;  ///< its pull at rest, N

  [[nodiscard]] double section() const;  ///< m2
};

/// What ties two surfaces together, without mass.
struct Joint {
  std::string name;
  JointType type = JointType::glue;
  std::array<JoinedSurface, 2> surfaces;
  std::optional<JointStiffness> stiffness;  ///< none: rigid, with a stiffness that the program chooses
  double damping = 0.0;                     ///< relaxation time: stress = stiffness (stretch + damping * its rate), s
  std::optional<double> reach;      ///< of a layer: up to this distance the surfaces are joined, m; chosen if omitted
  std::optional<PatchPlace> place;  ///< the washer of a bolt without a shank; the part of both surfaces that a spring
                                    ///< holds, if not all
  std::optional<HingeTurning> turning;  ///< of a hinge; none: it turns freely
  std::optional<Shank> shank;           ///< of a bolt; none: a layer under its washer
  JointAxis axis;                       ///< of a hinge or a shank
  deck::Location where;

  [[nodiscard]] bool is_layer() const { return type == JointType::glue || (type == JointType::bolt && !shank); }
};

}  // namespace idiophone::scene
