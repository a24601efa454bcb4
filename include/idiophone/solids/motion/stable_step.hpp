#pragma once
// The largest stable step of the explicit motion.

#include <mpi.h>

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "idiophone/scene/settings.hpp"
#include "idiophone/solids/contact/contact_surfaces.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// The supports' springs and dashpots, and those that bound bows and joints. [local nodes]
[[nodiscard]] Supports supports_of(const mesh::Part& part, const Dynamics& dynamics);

/// What limits each body's step, the same bits on any number of ranks. A body that lies on one rank is that rank's
/// work, so that many bodies are solved at once; the others follow, one after another, by all ranks together.
/// Collective.
/// @param part     of this rank
/// @param of_body  BodyModel::stable_step of a body, on the ranks given
/// @return [bodies]
/// @throws std::runtime_error if the eigensolver fails
[[nodiscard]] std::vector<StableStep> find_stable_steps(
    const mesh::Part& part, const std::function<StableStep(std::size_t body, const BodyRanks& ranks)>& of_body,
    MPI_Comm communicator);

/// The same of the dynamics' models, with their supports and joints.
[[nodiscard]] std::vector<StableStep> find_stable_steps(const mesh::Part& part, const Dynamics& dynamics,
                                                        MPI_Comm communicator = MPI_COMM_SELF);

/// BodyModel::inverse_masses of all bodies one after the other, 1/kg. [nodes of the whole mesh]
struct InverseMasses {
  std::vector<double> of_mesh;   ///< as finite elements
  std::vector<double> of_model;  ///< as the bodies move

  /// Adds those of the next body. [nodes of the body]
  void add(std::span<const double> mesh, std::span<const double> model);
};

/// Chooses the stiffness of the contacts and lowers the steps of the bodies that they stiffen. The stiffness is that
/// between finite elements, whichever model the bodies have, so that the contact is the same.
/// @param step               that the deck asks for, s; none where the program chooses it
/// @param largest_frequency  of any body as finite elements, rad/s
void stiffen_by_contact(const scene::Solids& solids, std::optional<double> step, const InverseMasses& inverse_masses,
                        double largest_frequency, contact::ContactSurfaces& contact_surfaces,
                        std::vector<StableStep>& steps);

/// m: whole steps per audio sample that make a stable step times the scene's safety factor, and resolve the bands of
/// loss factors (w dt <= 1), rounded up so that the surface can be read at even intervals; or the deck's own number.
/// @param step          the smallest of the bodies' stable steps, s
/// @param highest_loss  the highest frequency at which a body's loss factor is to hold, Hz; 0 where there is none
/// @param multiple_of   what m must be a multiple of
/// @param cause         a sentence about what makes the stable step short, for messages; none: the elements
/// @throws std::runtime_error when the deck's own number makes the step larger than the stable one or is no such
/// multiple, saying which would do; when it has none and no body limits the step
[[nodiscard]] int choose_steps_per_sample(const scene::Time& time, const scene::Audio& audio, double step,
                                          double highest_loss, int multiple_of = 1, std::string_view cause = {});

}  // namespace idiophone::motion
