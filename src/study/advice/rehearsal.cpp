#include "idiophone/study/advice/rehearsal.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "idiophone/air/propagation/audio_path.hpp"
#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/study/advice/processor_clock.hpp"

namespace idiophone::advice {

namespace {

constexpr double long_enough = 0.3;     // s, of a rehearsal, and of the steps of an audio sample in it
constexpr double contact_budget = 3.0;  // s, for the contacts of a scene
constexpr int contact_steps = 40;
constexpr double near = 0.05;  // of the thinnest cell: a gap that is none, and an overlap

/// Undeformed positions of all nodes on every rank, [global nodes] m. Collective.
std::vector<Vector3> all_positions(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<double> numbers(3 * static_cast<std::size_t>(part.global_nodes));
  for (Index node = 0; node < part.owned_nodes; ++node) {
    std::copy_n(part.reference[node].data(), 3, &numbers[3 * static_cast<std::size_t>(part.node_ids[node])]);
  }
  parallel::reduce(numbers, MPI_SUM, communicator);  // zero on all ranks but one
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    positions.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return positions;
}

/// Height of the thinnest cell in the skins of a contact's sides, m.
double thinnest_cell(const scene::Contact& contact, const contact::ContactSurfaces& surfaces) {
  const double first = surfaces.skins[contact.body].thinnest;
  return contact.other ? std::min(first, surfaces.skins[*contact.other].thinnest) : first;
}

/// Positions after a body has turned about its centre of mass.
std::vector<Vector3> turned(const bodies::Preparation& ready, std::vector<Vector3> positions, std::size_t body,
                            const Eigen::Matrix3d& turn) {
  const Vector3& centre = ready.initial_state.centres[body];
  for (Index node = ready.offsets.nodes[body]; node < ready.offsets.nodes[body + 1]; ++node) {
    positions[node] = centre + turn * (positions[node] - centre);
  }
  return positions;
}

/// The turn that makes a body lie on its flat side: its thinnest direction becomes the normal of what it lies on.
Eigen::Matrix3d turn_to_lie(const bodies::Preparation& ready, std::size_t body, const Vector3& normal) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(ready.initial_state.moments[body]);
  return Eigen::Quaterniond::FromTwoVectors(axes.eigenvectors().col(0), normal).toRotationMatrix();
}

/// What a contact is measured with.
struct Pose {
  std::span<const Vector3> undeformed;  ///< [global nodes] m
  std::vector<Vector3> positions;       ///< [global nodes] m
  Gap gap;
};

/// Wall clock of a step in which a contact acts, s. Collective.
double touching_step(const bodies::Preparation& ready, const scene::Contact& contact, const Pose& pose,
                     MPI_Comm communicator) {
  // A body that is fixed stays where it is if its partner can come to it.
  const bool moves_partner = contact.other && !ready.scene.bodies[contact.body].fixed.empty();
  const std::size_t moved = moves_partner ? *contact.other : contact.body;
  const Vector3 shift = (moves_partner ? -1.0 : 1.0) *
                        (pose.gap.across - near * thinnest_cell(contact, ready.contact_surfaces) * pose.gap.normal);
  std::vector<double> displacement(3 * pose.positions.size());
  for (Index node = ready.offsets.nodes[moved]; node < ready.offsets.nodes[moved + 1]; ++node) {
    const Vector3 way = pose.positions[node] - pose.undeformed[node] + shift;
    std::copy_n(way.data(), 3, &displacement[3 * static_cast<std::size_t>(node)]);
  }
  motion::Motion motion(ready.scene, ready.part, ready.attachments, ready.contact_surfaces, ready.step(),
                        ready.steps_per_sample, communicator, ready.models());
  motion.start(ready.initial_state.centres, displacement);
  motion.advance();
  const double start = processor_clock();
  for (int i = 0; i < contact_steps; ++i) {
    motion.advance();
  }
  return parallel::largest((processor_clock() - start) / contact_steps, communicator);
}

/// See touching_share; of the body that the contact names first.
double resting_share(const bodies::Preparation& ready, const scene::Contact& contact,
                     std::span<const Vector3> positions) {
  const Index first = ready.offsets.nodes[contact.body], last = ready.offsets.nodes[contact.body + 1];
  const Eigen::AlignedBox3d box = bounding_box(positions.subspan(first, last - first));
  double share = 0.0;
  for (const scene::MaterialRegion& region : ready.scene.bodies[contact.body].all_regions()) {
    share = std::max(share, touching_share(ready.scene.materials[region.material], ready.scene.gravity.norm(),
                                           box.sizes().maxCoeff()));
  }
  return share;
}

/// Time and steps of a contact. Collective.
ContactCost cost_of(const bodies::Preparation& ready, const scene::Contact& contact,
                    std::span<const Vector3> undeformed, double step_seconds, MPI_Comm communicator) {
  Pose pose{undeformed, {undeformed.begin(), undeformed.end()}, {}};
  pose.gap = find_gap(contact, ready.contact_surfaces, pose.positions);
  ContactCost cost{
      .gap = pose.gap,
      .time = touching_time(ready.scene, contact, pose.gap, near * thinnest_cell(contact, ready.contact_surfaces),
                            ready.scene.time.duration)};
  double seconds = touching_step(ready, contact, pose, communicator);
  if (cost.time.is_pressed && !contact.other && !cost.time.is_certain) {
    const Eigen::Matrix3d turn = turn_to_lie(ready, contact.body, pose.gap.normal);
    pose.positions = turned(ready, std::move(pose.positions), contact.body, turn);
    pose.gap = find_gap(contact, ready.contact_surfaces, pose.positions);
    seconds = std::max(seconds, touching_step(ready, contact, pose, communicator));
  }
  cost.step_seconds = std::max(0.0, seconds - step_seconds);
  const double share = cost.time.is_pressed && !cost.time.is_certain ? resting_share(ready, contact, undeformed) : 1.0;
  cost.steps = share * cost.time.duration / ready.step();
  return cost;
}

/// After how many steps the surface is read.
int rehearsed_steps_per_read(const bodies::Preparation& ready, double step_seconds) {
  const double share = long_enough / (ready.steps_per_sample * step_seconds);
  return static_cast<int>(std::clamp(share * ready.steps_per_read, 1.0, static_cast<double>(ready.steps_per_read)));
}

}  // namespace

RehearsedSample rehearse(const bodies::Preparation& ready, double step_seconds, MPI_Comm communicator) {
  parallel::Stages stages;
  bodies::FiniteElementSource source(ready, stages, communicator);
  propagation::AudioPath air(ready.scene, source.surface(), source.first_sample(), stages, communicator);
  if (propagation::AirLoad* const load = air.load()) {
    source.couple(*load);
  } else {
    source.read_after(rehearsed_steps_per_read(ready, parallel::largest(step_seconds, communicator)));
  }
  surface::SurfaceMotion motion;
  source.start(motion);
  air.start(motion);
  constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
  const auto advance = [&](int samples) {
    for (int i = 0; i < samples; ++i) {
      source.advance(motion);
      air.hear(motion);
    }
    air.check();
    static_cast<void>(air.take(no_limit));
  };
  advance(1);
  const parallel::Stages before = stages;
  const std::int64_t first_step = source.motion().step_number();
  const double begun = processor_clock(), wall_begun = parallel::wall_time();
  double passed = 0.0;
  int samples = 0;
  for (int block = 1; passed < long_enough && samples < bodies::sound_samples(ready.scene); block *= 2) {
    advance(block);
    samples += block;
    passed = parallel::largest(processor_clock() - begun, communicator);
  }
  // The stages have clocks on the wall; other programs delay all of them alike.
  const double share = (processor_clock() - begun) / (parallel::wall_time() - wall_begun) / samples;
  const auto of = [&](parallel::Stage stage) {
    return parallel::largest(share * (stages.seconds(stage) - before.seconds(stage)), communicator);
  };
  const double rehearsed = of(parallel::Stage::motion) + of(parallel::Stage::contact);
  const auto steps = static_cast<double>(source.motion().step_number() - first_step);
  const double motion_of_all = rehearsed * (static_cast<double>(samples) * ready.steps_per_sample / steps);
  return {.seconds = passed / samples - rehearsed + motion_of_all,
          .motion = motion_of_all,
          .radiation = of(parallel::Stage::radiation)};
}

std::vector<ContactCost> contact_costs(const bodies::Preparation& ready, double step_seconds, MPI_Comm communicator) {
  std::vector<ContactCost> costs;
  if (ready.scene.contacts.empty()) {
    return costs;
  }
  const std::vector<Vector3> positions = all_positions(ready.part, communicator);
  const double begun = processor_clock();
  double sum = 0.0;
  std::size_t measured = 0;
  for (const scene::Contact& contact : ready.scene.contacts) {
    if (contact.other == contact.body) {
      costs.emplace_back().is_known = false;
    } else if (parallel::largest(processor_clock() - begun, communicator) < contact_budget) {
      costs.push_back(cost_of(ready, contact, positions, step_seconds, communicator));
      sum += costs.back().step_seconds;
      ++measured;
    } else {
      ContactCost& cost = costs.emplace_back();
      cost.time.duration = ready.scene.time.duration;
      cost.step_seconds = sum / static_cast<double>(measured);  // the first one is always measured
      cost.steps = cost.time.duration / ready.step();
    }
  }
  return costs;
}

std::vector<ContactCost> unknown_costs(const scene::Scene& scene) {
  ContactCost unknown;
  unknown.is_known = false;
  return std::vector(scene.contacts.size(), unknown);
}

}  // namespace idiophone::advice
