#include "idiophone/run/loop/facts.hpp"

#include <fmt/format.h>
#include <gmsh.h>
#include <hdf5.h>
#include <petscversion.h>
#include <slepcversion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <string>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/solids/accuracy/recommendation.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::loop {

namespace {

constexpr std::size_t hash_digits = 16;  // of a mesh

std::string mpi_version() {
  const std::string all = parallel::library_version();
  return all.substr(0, all.find_first_of(",\n"));
}

nlohmann::json versions() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {{"idiophone", program_version},
          {"compiler", __VERSION__},
          {"mpi", mpi_version()},
          {"petsc", fmt::format("{}.{}.{}", PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"slepc", fmt::format("{}.{}.{}", SLEPC_VERSION_MAJOR, SLEPC_VERSION_MINOR, SLEPC_VERSION_SUBMINOR)},
          {"hdf5", fmt::format("{}.{}.{}", major, minor, release)},
          {"gmsh", GMSH_API_VERSION}};
}

/// What its materials are where it has several, by the numbers of the regions from 1 on.
void add_regions(nlohmann::json& facts, const bodies::Preparation& ready, std::size_t body) {
  const std::vector<double>& volumes = ready.statistics[body].volumes;
  for (std::size_t r = 0; r < volumes.size(); ++r) {
    const scene::MaterialRegion& region = ready.scene.bodies[body].regions[r];
    const scene::Material& material = ready.scene.materials[region.material];
    facts["regions"][std::to_string(r + 1)] = {
        {"name", region.name}, {"material", material.name}, {"mass", material.density * volumes[r]}};
  }
}

nlohmann::json body_facts(const bodies::Preparation& ready, std::size_t body) {
  const auto& mesh = ready.statistics[body];
  const auto& limit = ready.initial_state.steps[body];
  const auto& scaling = ready.initial_state.scaling[body];
  nlohmann::json facts = {{"nodes", mesh.nodes},
                          {"elements", mesh.elements},
                          {"triangles", mesh.triangles},
                          {"element", std::string(element::name(ready.scene.bodies[body].element))},
                          {"mass", ready.initial_state.masses[body]},
                          {"volume", mesh.volume},
                          {"smallest_edge", mesh.smallest_edge},
                          {"largest_edge", mesh.largest_edge},
                          {"worst_quality", mesh.worst_quality},
                          {"mesh_hash", ready.mesh_hash.substr(hash_digits * body, hash_digits)}};
  if (limit.is_limited()) {
    facts["stable_step"] = limit.step;
    facts["largest_eigenfrequency"] = limit.largest_frequency / (2 * std::numbers::pi);
  }
  if (const auto limits = pitch_limits(ready, body)) {
    facts["highest_within_5_cents"] = limits->first;
    facts["highest_within_50_cents"] = limits->second;
  }
  add_order(facts, ready.scene.bodies[body].element);
  add_regions(facts, ready, body);
  if (ready.scene.bodies[body].mass_scaling) {
    facts["mass_scaling"] = {{"gain", scaling.gain}, {"shift", scaling.shift}};
  }
  return facts;
}

}  // namespace

std::optional<std::pair<double, double>> pitch_limits(const bodies::Preparation& ready, std::size_t b) {
  const auto& body = ready.scene.bodies[b];
  if (!ready.initial_state.steps[b].is_limited() || accuracy::without_rules(body, ready.statistics[b])) {
    return {};
  }
  const auto& material = ready.scene.materials[body.material];
  const accuracy::Extents extents = accuracy::extents(ready.statistics[b]);
  switch (body.element.kind) {
    case element::Kind::tet4:
      return {};  // no pitch to promise
    case element::Kind::tet10:
    case element::Kind::hex: {
      const auto limit = [&](double cents) {
        return accuracy::highest_frequency(accuracy::cells_of(ready.statistics[b], body.element), extents, material,
                                           cents);
      };
      return std::pair{limit(5), limit(50)};
    }
  }
  element::unknown_kind();
}

nlohmann::json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

void add_order(nlohmann::json& facts, element::Type type) {
  if (element::has_choice_of_orders(type)) {
    const auto [plane, thickness] = element::orders(type);
    facts["order"] = {{"plane", plane}, {"thickness", thickness}};
  }
}

nlohmann::json size_facts(const bodies::Preparation& ready) {
  const auto& masses = ready.initial_state.masses;
  nlohmann::json facts = {{"step", ready.step()},
                          {"steps_per_sample", ready.steps_per_sample},
                          {"steps_per_read", ready.steps_per_read},
                          {"nodes", ready.part.global_nodes},
                          {"elements", ready.part.global_elements},
                          {"triangles", ready.part.global_triangles},
                          {"mass", std::accumulate(masses.begin(), masses.end(), 0.0)},
                          {"mesh_hash", ready.mesh_hash}};
  for (std::size_t body = 0; body < ready.scene.bodies.size(); ++body) {
    facts["bodies"][ready.scene.bodies[body].name] = body_facts(ready, body);
  }
  for (const auto& [body, basis] : ready.modal_bases) {
    facts["bodies"][ready.scene.bodies[body].name]["modes"] = {
        {"count", basis.modes()},
        {"highest", basis.frequencies.back() / (2 * std::numbers::pi)},
        {"rigid_motion", basis.is_free ? "free" : "held"}};
  }
  return facts;
}

nlohmann::json run_facts(const bodies::Preparation& ready, MPI_Comm communicator) {
  nlohmann::json facts;
  parallel::on_root(communicator, [&] {
    facts = size_facts(ready);
    facts["deck"] = scene::resolved_deck(ready.scene.deck, ready.scene.overrides);
  });
  return facts;
}

nlohmann::json listening_facts(const surface::RecordingHeader& recording, const propagation::AudibleSurface& surface,
                               const std::string& deck) {
  nlohmann::json facts = {
      {"recorded_run", recording.origin.name}, {"triangles", surface.global_triangles()}, {"deck", deck}};
  for (std::size_t body = 0; body < recording.bodies.size(); ++body) {
    facts["bodies"][recording.bodies[body].name]["triangles"] =
        surface.first_triangle[body + 1] - surface.first_triangle[body];
  }
  return facts;
}

nlohmann::json part_facts(const mesh::PartSize& largest, motion::Halo halo) {
  return {{"elements", largest.elements},
          {"ghost_elements", largest.ghost_elements},
          {"nodes", largest.nodes},
          {"ghost_nodes", largest.ghost_nodes},
          {"triangles", largest.triangles},
          {"neighbours", largest.neighbours},
          {"halo_bytes", motion::halo_bytes(largest, halo)}};
}

mesh::PartSize largest_part(const mesh::Part& part, MPI_Comm communicator) {
  mesh::PartSize largest;
  for (const mesh::PartSize& size : parallel::gather(mesh::size_of(part), communicator)) {
    largest = mesh::largest(largest, size);
  }
  return largest;
}

MemoryPeaks memory_peaks(MPI_Comm communicator) {
  const std::vector<double> peaks = parallel::gather(peak_memory(), communicator);
  return {.root = peaks.front(), .largest = *std::max_element(peaks.begin() + (peaks.size() > 1 ? 1 : 0), peaks.end())};
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "generic";
#endif
}

void require_one_instruction_set(const std::string& own, MPI_Comm communicator) {
  const std::string of_root = parallel::from_root(own, communicator);
  parallel::agree(
      communicator,
      own == of_root ? std::string()
                     : fmt::format("rank {} runs a program for {} and rank 0 one for {}, which differ in the last bits "
                                   "of the sound: start all with mpirun -x IDIOPHONE_INSTRUCTION_SET=x86-64-v3",
                                   parallel::rank_of(communicator), own, of_root));
}

nlohmann::json job_facts(std::int64_t first_sample, int ranks) {
  return {{"first_sample", first_sample},
          {"ranks", ranks},
          {"instruction_set", instruction_set()},
          {"versions", versions()}};
}

nlohmann::json end_facts(const JobEnd& end, const parallel::Stages& stages) {
  nlohmann::json facts = {{"last_sample", end.last_sample},
                          {"elapsed", end.elapsed},
                          {"processor_time", end.processor_time},
                          {"memory_bytes", end.memory.largest},
                          {"root_memory_bytes", end.memory.root}};
  if (end.element_steps) {
    facts["elements_per_second"] = *end.element_steps / end.elapsed;
  }
  for (std::size_t stage = 0; stage < parallel::stage_count; ++stage) {
    facts["stages"][parallel::stage_names[stage]] = stages.seconds(static_cast<parallel::Stage>(stage));
  }
  return facts;
}

}  // namespace idiophone::loop
