#include "preparation_report.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <numbers>
#include <string>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "idiophone/solids/joints/beam_stiffness.hpp"
#include "idiophone/solids/solid/relaxation.hpp"
#include "steps.hpp"

namespace idiophone::bodies {

namespace {

/// @param number  of the body
void report_modes(const Preparation& ready, std::size_t number, const modal_bodies::ModalBasis& basis) {
  if (basis.common_with && *basis.common_with != number) {
    spdlog::info("  moves by the modes of body {}, which joints tie to it",
                 ready.scene.bodies[*basis.common_with].name);
    return;
  }
  constexpr double turn = 2 * std::numbers::pi;
  const std::size_t own = basis.modes() - basis.further;
  spdlog::info("  {}, {} modes from {:.5g} to {:.5g} Hz", basis.is_free ? "rigid motion" : "held", own,
               basis.frequencies.front() / turn, basis.frequencies[own - 1] / turn);
  if (basis.further > 0) {
    spdlog::info("  {} further modes for its joints, up to {:.5g} Hz", basis.further, basis.frequencies.back() / turn);
  }
  if (basis.stretching.exists()) {
    spdlog::info("  large amplitudes: {} strains, {:.3g} MB of coefficients", basis.stretching.terms(),
                 static_cast<double>(basis.stretching.quadratic.size() * sizeof(double)) / 1e6);
  }
}

/// The principal stresses of the undeformed body, and how fast waves travel along the largest as on a string or a
/// membrane.
/// @param density  mean, kg/m3
void report_prestress(const scene::Body& body, double density) {
  if (body.prestress->temperature != 0.0) {
    spdlog::info("  prestress: the temperature changed by {:.6g} K", body.prestress->temperature);
  }
  if (body.prestress->stress.isZero(0.0)) {
    return;
  }
  const Eigen::Vector3d stresses = dense::eigenpairs(Eigen::MatrixXd(body.initial_stress())).values;
  spdlog::info("  prestress: principal stresses of {:.6g}, {:.6g} and {:.6g} Pa", stresses[2], stresses[1],
               stresses[0]);
  if (stresses[2] > 0) {
    spdlog::info("  transverse waves along the largest travel at {:.5g} m/s without stiffness",
                 std::sqrt(stresses[2] / density));
  }
}

/// One line for the shank, not one for each direction in which it resists turning.
void report_shank(const scene::Joint& joint, const joints::MeshedJoint& meshed) {
  if (meshed.resists_turning) {
    return;
  }
  const double length = (joint.axis.end - joint.axis.begin).norm();
  const joints::BeamStiffness beam = joints::beam_stiffness(*joint.shank, length);
  spdlog::info(
      "joint {}: a bolt of {:.4g} m under {:.4g} N; stiffness {:.4g} N/m axial, {:.4g} N/m lateral, {:.4g} N m/rad in "
      "bending, {:.4g} N m/rad in torsion",
      joint.name, length, joint.shank->preload, beam.axial, beam.lateral, beam.bending, beam.torsion);
}

/// That of a layer can come from its material, and shorten the step.
std::string damping_in_words(const joints::MeshedJoint& meshed) {
  return meshed.damping > 0 ? fmt::format(", damping {:.4g} s", meshed.damping) : "";
}

void report_joint(const scene::Joint& joint, const joints::MeshedJoint& meshed) {
  switch (joint.type) {
    case scene::JointType::bolt:
      if (joint.shank) {
        report_shank(joint, meshed);
        break;
      }
      [[fallthrough]];
    case scene::JointType::glue:
      spdlog::info(
          "joint {}: {:.4g} m2 joined, at most {:.3g} m apart; stiffness {:.4g} Pa/m normal, {:.4g} Pa/m tangential{}",
          joint.name, meshed.area(), meshed.largest_distance(), meshed.normal, meshed.tangential,
          damping_in_words(meshed));
      break;
    case scene::JointType::spring:
      spdlog::info("joint {}: a spring of {:.4g} m; stiffness {:.4g} N/m axial, {:.4g} N/m lateral{}", joint.name,
                   meshed.largest_distance(), meshed.normal, meshed.tangential, damping_in_words(meshed));
      break;
    case scene::JointType::hinge:
      if (meshed.resists_turning) {
        spdlog::info("joint {}: stiffness {:.4g} N m/rad against turning", joint.name, meshed.normal);
        break;
      }
      spdlog::info("joint {}: a hinge of {:.4g} m; stiffness {:.4g} N/m at each end", joint.name,
                   (joint.axis.end - joint.axis.begin).norm(), meshed.normal);
      break;
  }
}

/// Regions with their materials, and loss factors, or that there is no damping.
void report_materials(const Preparation& ready, std::size_t b) {
  const scene::Body& body = ready.scene.bodies[b];
  for (std::size_t r = 0; r < body.regions.size(); ++r) {
    const scene::Material& material = ready.scene.materials[body.regions[r].material];
    spdlog::info("  {} {}: {}, {:.6g} kg", body.has_layers() ? "layer" : "group", body.regions[r].name, material.name,
                 material.density * ready.statistics[b].volumes[r]);
  }
  for (const scene::MaterialRegion& region : body.all_regions()) {
    if (const auto& loss = ready.scene.materials[region.material].damping.loss) {
      const solid::Relaxation relaxation = solid::fit_relaxation(*loss);
      spdlog::info("  loss factor {}{:.4g} from {:.6g} to {:.6g} Hz by {} mechanisms{}",
                   loss->curve.empty() && !loss->directions ? "" : "up to ", loss->value, loss->band[0], loss->band[1],
                   relaxation.mechanisms.size(),
                   loss->curve.empty() ? "" : fmt::format(", within {:.1f} %", 100 * relaxation.deviation));
    }
  }
  if (!is_held_everywhere(ready, b) && scene::is_undamped(body, ready.scene.materials)) {
    spdlog::info("  {}", scene::undamped_in_words);
  }
}

}  // namespace

void report(const Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& body = ready.scene.bodies[b];
    const auto& mesh = ready.statistics[b];
    const auto& limit = ready.initial_state.steps[b];
    spdlog::info("body {}: {} nodes, {} {} elements, {} surface triangles, {:.6g} kg", body.name, mesh.nodes,
                 mesh.elements, element::name(body.element), mesh.triangles, ready.initial_state.masses[b]);
    report_materials(ready, b);
    if (body.prestress) {
      report_prestress(body, ready.initial_state.masses[b] / mesh.volume);
    }
    if (const auto basis = ready.modal_bases.find(b); basis != ready.modal_bases.end()) {
      report_modes(ready, b, basis->second);
      continue;
    }
    if (is_held_everywhere(ready, b)) {
      spdlog::info("  held everywhere: it keeps its shape and does not limit the step");
      continue;
    }
    spdlog::info(
        "  largest eigenfrequency {:.5g} Hz allows steps of {:.4g} s; element {} at ({:.4g}, {:.4g}, {:.4g}) limits it",
        limit.largest_frequency / (2 * std::numbers::pi), limit.step, limit.element - ready.offsets.elements[b],
        limit.centre[0], limit.centre[1], limit.centre[2]);
    if (!body.fracture.empty()) {
      spdlog::info("  can break along {} faces", ready.attachments.bodies[b].fracture.size());
    }
    if (body.mass_scaling) {
      const auto [gain, shift] = ready.initial_state.scaling[b];
      spdlog::info(
          "  mass scaling: steps {:.2f} times as long; it lowers no audible pitch by more than about {:.2g} cents",
          gain, shift);
    }
  }
  for (std::size_t c = 0; c < ready.scene.contacts.size(); ++c) {
    spdlog::info("contact {}: stiffness {:.4g} Pa/m", ready.scene.contacts[c].name,
                 ready.contact_surfaces.stiffness[c]);
  }
  for (const joints::MeshedJoint& joint : ready.attachments.joints) {
    report_joint(ready.scene.joints[joint.joint], joint);
  }
  if (ready.scene.radiation.grid.back && std::isfinite(lightest_surface(ready))) {
    spdlog::info("air acts on the bodies: their lightest surface, {:.3g} kg/m2, lowers the largest step to {:.4g} s",
                 lightest_surface(ready), stable_step_in_air(ready));
  }
  spdlog::info("step {:.4g} s: {} steps per audio sample, surface read every {}", ready.step(), ready.steps_per_sample,
               ready.steps_per_read);
}

}  // namespace idiophone::bodies
