#pragma once
// The first moments of a run, played without a result: how long its parts take on this machine.

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/study/advice/touch.hpp"

namespace idiophone::advice {

/// Processor time of an audio sample at the start of a run.
struct RehearsedSample {
  double seconds = 0.0;    ///< motion and sound, s
  double motion = 0.0;     ///< part of it: of the bodies, contact included, s
  double radiation = 0.0;  ///< part of it: from emissions to listeners, s
  bool is_played = true;   ///< false: of the motion alone, without contacts and sound, whose times are not known
};

/// Advances bodies and air as a run does, for some tenths of a second. Where the steps of one audio sample take longer,
/// fewer are played between reads of the surface, unless the air acts on the bodies in each: the times are those of a
/// run, the sound is not. Collective.
/// @param step_seconds  processor time of a step on one rank, s
/// @throws std::runtime_error where the run would fail
[[nodiscard]] RehearsedSample rehearse(const bodies::Preparation& ready, double step_seconds, MPI_Comm communicator);

/// What a contact adds to the time of a run.
struct ContactCost {
  Gap gap;
  TouchingTime time;
  bool is_known = true;       ///< false of a body with itself: nobody knows before the run when its parts touch; and
                              ///< of unknown_costs()
  double steps = 0.0;         ///< that it can act in
  double step_seconds = 0.0;  ///< what such a step takes more than one without contact, s
  [[nodiscard]] double seconds() const { return steps * step_seconds; }
};

/// Pushes the two sides of each contact together, into each other by a twentieth of the thinnest cell of their skins,
/// and takes some steps there. A body that may lie down on an obstacle does so, too, with its thinnest direction
/// upright, and the longer of both counts. After some seconds, the contacts that are left count as long as the mean of
/// the others. Contacts of a body with itself are left out: pushing cannot bring its parts together. Collective.
/// @param step_seconds  processor time of a step of the rehearsal, s
/// @return [contacts]
[[nodiscard]] std::vector<ContactCost> contact_costs(const bodies::Preparation& ready, double step_seconds,
                                                     MPI_Comm communicator);

/// What stands for contact_costs() where the run does not fit into the memory. [contacts]
[[nodiscard]] std::vector<ContactCost> unknown_costs(const scene::Scene& scene);

}  // namespace idiophone::advice
