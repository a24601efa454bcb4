#pragma once
// What a run will need: numbers of steps, memory, disk and time.

#include <mpi.h>

#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/study/advice/rehearsal.hpp"

namespace idiophone::advice {

/// What is measured before the costs are counted. Times are those of processors that no other program uses.
struct Measured {
  double preparation = 0.0;  ///< processor time from the deck to the initial state, s
  RehearsedSample sample;
  std::vector<ContactCost> contacts;  ///< [contacts]
};

struct RunCosts {
  double samples = 0.0;  ///< of audio
  double steps = 0.0;
  double memory = 0.0;        ///< of all ranks, bytes
  double sound = 0.0;         ///< in the result, bytes
  double frames = 0.0;        ///< in the result, bytes
  double recording = 0.0;     ///< of surface motion, bytes
  double step_seconds = 0.0;  ///< processor time of a step of the motion without contact, s
  double preparation = 0.0;   ///< processor time before the first step, s
  double motion = 0.0;        ///< processor time of the motion without contact, s
  double contact = 0.0;       ///< processor time of contact at the most, s
  double least = 0.0;         ///< processor time of the run with no more contact than is certain, s
  double most = 0.0;          ///< processor time of the run with contact at the most, s
  bool is_played = true;      ///< see RehearsedSample; false: a run takes longer than `least`, nobody knows how much
  int ranks = 1;
  std::string modal_proposal = {};  ///< empty: none

  /// Wall clock of the run, s: the geometric mean of both, so that it errs by the same factor in both directions.
  [[nodiscard]] double seconds() const { return std::sqrt(least * most); }
  [[nodiscard]] double disk() const { return sound + frames + recording; }  ///< bytes
};

/// @param memory  of all ranks, bytes
[[nodiscard]] RunCosts run_costs(const bodies::Preparation& ready, const Measured& measured, double memory,
                                 MPI_Comm communicator);

/// Bodies of finite elements that could be modal bodies, where the motion takes ten minutes or more, and what that
/// saves; empty where it would save less.
/// @param steps   [bodies] those that are held everywhere limit none, and take no time
/// @param motion  processor time of the motion without contact, s
[[nodiscard]] std::string modal_proposal(const scene::Scene& scene, std::span<const motion::StableStep> steps,
                                         double motion);

/// A time for people: seconds, minutes or hours.
[[nodiscard]] std::string duration_text(double seconds);

/// @param contacts  [contacts]
void report(const RunCosts& costs, const scene::Scene& scene, const std::vector<ContactCost>& contacts);

[[nodiscard]] nlohmann::json facts_of(const RunCosts& costs, const scene::Scene& scene,
                                      const std::vector<ContactCost>& contacts);

}  // namespace idiophone::advice
