#pragma once
// The largest stable step of the explicit motion.

#include <vector>

#include "idiophone/solids/contact/contact_surfaces.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// The supports' springs and dashpots. [local nodes]
[[nodiscard]] Supports supports_of(const mesh::Part& part, const Dynamics& dynamics);

/// What limits each body's step: BodyModel::stable_step with its supports. Runs on one rank, so that its numbers do not
/// depend on how many there are.
/// @param part      the whole mesh as one part
/// @param dynamics  of the whole mesh, on this rank alone
/// @return [bodies]
/// @throws std::runtime_error if the eigensolver fails
[[nodiscard]] std::vector<StableStep> find_stable_steps(const mesh::Part& part, const Dynamics& dynamics);

/// Chooses the stiffness of the contacts and lowers the steps of the bodies that they stiffen. The stiffness is that
/// between finite elements, whichever model the bodies have, so that the contact is the same.
/// @param finite_elements    all bodies as finite elements, of the whole mesh, on this rank alone
/// @param largest_frequency  of any of these, rad/s
/// @param dynamics           of the bodies as they move, likewise
void stiffen_by_contact(const scene::Scene& scene, const Dynamics& finite_elements, double largest_frequency,
                        const Dynamics& dynamics, contact::ContactSurfaces& contact_surfaces,
                        std::vector<StableStep>& steps);

/// m: whole steps per audio sample that make a stable step times the scene's safety factor, and resolve the bands of
/// loss factors (w dt <= 1), rounded up so that the surface can be read at even intervals; or the deck's own number.
/// @param step        the smallest of the bodies' stable steps, s
/// @param multiple_of  what m must be a multiple of
/// @throws std::runtime_error when the deck's own number makes the step larger than the stable one or is no such
/// multiple, saying which would do; when it has none and no body limits the step
[[nodiscard]] int choose_steps_per_sample(const scene::Scene& scene, double step, int multiple_of = 1);

}  // namespace idiophone::motion
