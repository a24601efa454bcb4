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

/// Glue is a layer between whole surfaces, a bolt one under a washer. A spring acts between the middles of two
/// surfaces. A hinge ties the two ends of an axis.
enum class JointType { glue, bolt, spring, hinge };

struct HingeAxis {
  Vector3 begin = Vector3::Zero();  ///< m
  Vector3 end = Vector3::Zero();    ///< m; another place
};

/// What resists the turning of a hinge: with the sine s of the angle, the moment is stiffness (s + damping s') times
/// its cosine.
struct HingeTurning {
  double stiffness = 0.0;  ///< N m/rad
  double damping = 0.0;    ///< relaxation time, s
};

/// What ties two surfaces together, without mass.
struct Joint {
  std::string name;
  JointType type = JointType::glue;
  std::array<JoinedSurface, 2> surfaces;
  std::optional<JointStiffness> stiffness;  ///< none: rigid, with a stiffness that the program chooses
  double damping = 0.0;                     ///< relaxation time: stress = stiffness (stretch + damping * its rate), s
  std::optional<double> reach;      ///< of a layer: up to this distance the surfaces are joined, m; chosen if omitted
  std::optional<PatchPlace> place;  ///< a bolt's washer; the part of both surfaces that a spring holds, if not all
  std::optional<HingeTurning> turning;  ///< of a hinge; none: it turns freely
  HingeAxis axis;                       ///< of a hinge
  deck::Location where;

  [[nodiscard]] bool is_layer() const { return type == JointType::glue || type == JointType::bolt; }
};

}  // namespace idiophone::scene
