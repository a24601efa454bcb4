#include "idiophone/study/advice/run_costs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/run/record/surface_recorder.hpp"

namespace idiophone::advice {

namespace {

constexpr double mega_byte = 1e6;
constexpr double files = 1.05;  // what files add to the time of motion and sound, by measurements

/// Whether a body of finite elements keeps to what modal bodies can do (docs/use/modal_bodies.md).
bool can_be_modal(const scene::Body& body) {
  const auto holds_all = [](const scene::FixedGroup& group) {
    return !group.hinge && group.axes == scene::Axes{true, true, true};
  };
  return !body.modal && body.fracture.empty() && body.driven.empty() && std::ranges::all_of(body.fixed, holds_all);
}

/// Of a contact whose cost is not known.
std::string why_unknown(const scene::Scene& scene, const scene::Contact& contact) {
  if (contact.other == contact.body) {
    return fmt::format("nobody knows before the run when parts of {} touch", scene.bodies[contact.body].name);
  }
  return "the run does not fit into this memory, so nothing was played";
}

}  // namespace

RunCosts run_costs(const bodies::Preparation& ready, const Measured& measured, double memory, MPI_Comm communicator) {
  const scene::Scene& scene = ready.scene;
  double channels = 0.0;
  for (const auto& listener : scene.listeners) {
    channels += static_cast<double>(listener.receivers.size());
  }
  RunCosts costs;
  costs.samples = scene.time.duration * scene.audio.rate;
  costs.steps = costs.samples * ready.steps_per_sample;
  costs.memory = memory;
  costs.sound = costs.samples * channels * sizeof(double);
  costs.frames = scene.time.duration * scene.output.frames_per_second * ready.part.global_nodes * 3 * sizeof(float);
  costs.recording = scene.output.surface_motion ? record::recorded_bytes_per_sample(ready) * costs.samples : 0.0;
  costs.step_seconds = measured.sample.motion / ready.steps_per_sample;
  costs.preparation = measured.preparation;
  costs.motion = costs.samples * measured.sample.motion;
  costs.least = costs.preparation + files * costs.samples * measured.sample.seconds;
  for (const ContactCost& contact : measured.contacts) {
    costs.contact += contact.seconds();
    costs.least += contact.time.is_certain ? contact.seconds() : 0.0;
  }
  costs.most = costs.preparation + files * costs.samples * measured.sample.seconds + costs.contact;
  costs.is_played = measured.sample.is_played;
  costs.ranks = parallel::size_of(communicator);
  costs.modal_proposal = modal_proposal(scene, ready.initial_state.steps, costs.motion);
  return costs;
}

std::string modal_proposal(const scene::Scene& scene, std::span<const motion::StableStep> steps, double motion) {
  constexpr double least = 600.0;              // s
  constexpr double highest_audible = 20000.0;  // Hz
  std::vector<std::string> names;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (can_be_modal(scene.bodies[b]) && steps[b].is_limited()) {
      names.push_back(scene.bodies[b].name);
    }
  }
  if (motion < least || names.empty() || !scene.joints.empty()) {  // which can limit the step of modal bodies, too
    return {};
  }
  return fmt::format(
      "the motion takes {}; model: {{type: modal, up_to: {:.0f}}} for {} saves nearly all of the time of these bodies, "
      "and is right for vibrations up to a tenth of their thickness (docs/use/modal_bodies.md)",
      duration_text(motion), std::min(highest_audible, scene.audio.max_frequency), fmt::join(names, ", "));
}

std::string duration_text(double seconds) {
  if (seconds < 10) {
    return fmt::format("{:.2g} s", seconds);
  }
  if (seconds < 120) {
    return fmt::format("{:.0f} s", seconds);
  }
  return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void report(const RunCosts& costs, const scene::Scene& scene, const std::vector<ContactCost>& contacts) {
  spdlog::info("{:.0f} audio samples, {:.4g} steps", costs.samples, costs.steps);
  spdlog::info("about {:.0f} MB of memory in all; result of {:.1f} MB, {:.1f} MB of it frames",
               costs.memory / mega_byte, (costs.sound + costs.frames) / mega_byte, costs.frames / mega_byte);
  if (costs.recording > 0) {
    spdlog::info("recorded surface motion: {:.1f} MB for each second of sound, {:.1f} MB in all",
                 costs.recording / scene.time.duration / mega_byte, costs.recording / mega_byte);
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactCost& cost = contacts[c];
    if (!cost.is_known) {
      spdlog::info("contact {}: its time is not counted: {}", scene.contacts[c].name,
                   why_unknown(scene, scene.contacts[c]));
      continue;
    }
    spdlog::info("contact {}: acts in at most {:.4g} steps, from {:.4g} s on; each takes {:.3g} ms more, {} in all",
                 scene.contacts[c].name, cost.steps, cost.time.begin, 1e3 * cost.step_seconds,
                 duration_text(cost.seconds()));
  }
  if (!costs.modal_proposal.empty()) {
    spdlog::info(costs.modal_proposal);
  }
  spdlog::info("{} {} on {} rank{} ({} of it preparation; a step takes {:.3g} ms without contact)",
               costs.is_played ? "about" : "more than", duration_text(costs.seconds()), costs.ranks,
               costs.ranks == 1 ? "" : "s", duration_text(costs.preparation), 1e3 * costs.step_seconds);
  if (costs.most > 1.2 * costs.least) {
    spdlog::info("  from {} with little contact to {} if all contacts act as long as they can",
                 duration_text(costs.least), duration_text(costs.most));
  }
}

nlohmann::json facts_of(const RunCosts& costs, const scene::Scene& scene, const std::vector<ContactCost>& contacts) {
  const auto if_played = [&](double seconds) { return costs.is_played ? nlohmann::json(seconds) : nlohmann::json(); };
  nlohmann::json facts = {{"samples", costs.samples},
                          {"steps", costs.steps},
                          {"memory_bytes", costs.memory},
                          {"sound_bytes", costs.sound},
                          {"frames_bytes", costs.frames},
                          {"recording_bytes", costs.recording},
                          {"step_seconds", costs.step_seconds},
                          {"preparation_seconds", costs.preparation},
                          {"motion_seconds", costs.motion},
                          {"played", costs.is_played},
                          {"contact_seconds", if_played(costs.contact)},
                          {"seconds", if_played(costs.seconds())},
                          {"least_seconds", costs.least},
                          {"most_seconds", if_played(costs.most)},
                          {"ranks", costs.ranks},
                          {"modal_proposal", costs.modal_proposal},
                          {"contacts", nlohmann::json::object()}};
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    nlohmann::json& contact = facts["contacts"][scene.contacts[c].name];  // null if nothing is known
    if (contacts[c].is_known) {
      contact = {{"begin", contacts[c].time.begin},
                 {"steps", contacts[c].steps},
                 {"certain", contacts[c].time.is_certain},
                 {"step_seconds", contacts[c].step_seconds}};
    }
  }
  return facts;
}

}  // namespace idiophone::advice
