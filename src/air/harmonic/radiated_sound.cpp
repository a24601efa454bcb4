#include "idiophone/air/harmonic/radiated_sound.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "grid_far_field.hpp"
#include "harmonic_kirchhoff.hpp"
#include "idiophone/air/harmonic/listener_pressures.hpp"
#include "idiophone/air/harmonic/sphere_rule.hpp"
#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "sound_message.hpp"
#include "surface_levels.hpp"

namespace idiophone::harmonic {

namespace {

using harmonic::BoundaryField;
using harmonic::Complex;

/// Vibrations of one frequency: [first, last).
struct FrequencyGroup {
  std::size_t first = 0, last = 0;
};

std::vector<FrequencyGroup> groups_of(const std::vector<Vibration>& vibrations) {
  std::vector<FrequencyGroup> groups;
  for (std::size_t v = 0; v < vibrations.size(); ++v) {
    if (v == 0 || vibrations[v].frequency != vibrations[v - 1].frequency) {
      groups.push_back({v, v});
    }
    groups.back().last = v + 1;
  }
  return groups;
}

/// Everything but the sounds.
harmonic::Radiation facts_of(const scene::Acoustics& acoustics, std::size_t part, const AcousticSurface& surface,
                             double highest) {
  harmonic::Radiation facts;
  facts.body = surface.parts[part];
  facts.bodies = surface.bodies;
  facts.parts = surface.parts;
  facts.first_triangle = surface.first_triangle;
  facts.surfaces = {surface.boundary};
  const double diameter = bounding_box(surface.boundary.vertices).diagonal().norm();
  const double phase = 2.0 * std::numbers::pi * highest / acoustics.radiation.air.speed * diameter / 2.0;
  constexpr double fewest_rings = 16, most_rings = 64;
  facts.rings = std::lround(std::clamp(std::ceil(phase) + 6.0, fewest_rings, most_rings));
  harmonic::SphereRule sphere = harmonic::sphere_rule(static_cast<unsigned>(facts.rings));
  facts.directions = std::move(sphere.directions);
  facts.weights = std::move(sphere.weights);
  facts.air_density = acoustics.radiation.air.density;
  facts.air_speed = acoustics.radiation.air.speed;
  place_listeners(facts, acoustics.listeners);
  return facts;
}

/// Integral of |p r|^2 over the directions, Pa2 m2.
double square_over(const harmonic::Radiation& facts, const std::vector<Complex>& far_field) {
  double sum = 0.0;
  for (std::size_t d = 0; d < far_field.size(); ++d) {
    sum += facts.weights[d] * std::norm(far_field[d]);
  }
  return sum;
}

/// Level of a model above the exact one where it is most wrong, dB. Directions that are 10 dB below the mean are nulls.
double worst_error(const harmonic::Radiation& facts, const std::vector<Complex>& model,
                   const std::vector<Complex>& exact) {
  const double mean = square_over(facts, exact) / (4.0 * std::numbers::pi);
  double worst = 0.0;
  for (std::size_t d = 0; d < exact.size(); ++d) {
    const double error = 20.0 * std::log10(std::abs(model[d] / exact[d]));
    if (std::norm(exact[d]) > 0.1 * mean && std::abs(error) > std::abs(worst)) {
      worst = error;
    }
  }
  return worst;
}

/// Area of a part, m2, and the integral of |v|^2 of its normal velocity, m4/s2: exact for linear velocities.
std::pair<double, double> area_and_flux(const AcousticSurface& surface, std::size_t part,
                                        const std::vector<Complex>& velocity) {
  double area = 0.0;
  double square = 0.0;
  for (Index t = surface.first_triangle[part]; t < surface.first_triangle[part + 1]; ++t) {
    const auto& [a, b, c] = surface.boundary.triangles[t];
    const Vector3& corner = surface.boundary.vertices[a];
    const double here =
        0.5 * (surface.boundary.vertices[b] - corner).cross(surface.boundary.vertices[c] - corner).norm();
    const auto at = 3 * static_cast<std::size_t>(t);
    const Complex u = velocity[at], v = velocity[at + 1], w = velocity[at + 2];
    area += here;
    square +=
        here / 6.0 *
        (std::norm(u) + std::norm(v) + std::norm(w) + (u * std::conj(v) + v * std::conj(w) + w * std::conj(u)).real());
  }
  return {area, square};
}

/// What all sounds have in common.
struct Radiator {
  std::size_t part;
  const AcousticSurface& surface;
  const harmonic::Radiation& facts;
  const scene::AirProperties& air;
};

/// Compares with the models of `run`, on the surface as it is there.
/// @param whole  integral of the squared far field over the directions, Pa2 m2
void compare_models(harmonic::RadiatedSound& sound, double whole, const Radiator& radiator, const QuietAir& air,
                    const Vibration& vibration) {
  const auto& [part, surface, facts, unused] = radiator;
  const double wave_number = 2.0 * std::numbers::pi * vibration.frequency / air.speed;
  const auto modelled =
      harmonic::modelled_far_field(surface.boundary, surface.first_triangle[part], surface.first_triangle[part + 1],
                                   air, wave_number, vibration.normal_velocity, facts.directions);
  sound.kirchhoff_error = 10.0 * std::log10(square_over(facts, modelled.kirchhoff) / whole);
  sound.kirchhoff_worst = worst_error(facts, modelled.kirchhoff, sound.far_field);
  sound.rayleigh_error = 10.0 * std::log10(square_over(facts, modelled.rayleigh) / whole);
  sound.rayleigh_worst = worst_error(facts, modelled.rayleigh, sound.far_field);
  if (facts.cell > 0.0) {
    const auto on_grid = grid_far_field(surface, vibration, air, facts.cell, facts.directions);
    sound.waves_error = 10.0 * std::log10(square_over(facts, on_grid) / whole);
    sound.waves_worst = worst_error(facts, on_grid, sound.far_field);
  }
}

/// @param elements  that the field is on, as the surface or finer
harmonic::RadiatedSound sound_of(const harmonic::BoundaryElements& elements, const BoundaryField& field,
                                 const Vibration& vibration, const Radiator& radiator) {
  const harmonic::Radiation& facts = radiator.facts;
  harmonic::RadiatedSound sound;
  const auto [area, square] = area_and_flux(radiator.surface, radiator.part, vibration.normal_velocity);
  sound.mean_square_velocity = 0.5 * square / area;
  sound.power = field.power;
  sound.efficiency = field.power / (elements.air().impedance() * 0.5 * square);
  const double angular = 2.0 * std::numbers::pi * vibration.frequency;
  sound.loss_factor =
      vibration.energy > 0 ? field.power / (angular * vibration.energy) : std::numeric_limits<double>::quiet_NaN();
  sound.frequency = vibration.frequency;
  sound.solution = field;
  sound.listener_pressure = pressures_at_listeners(elements, sound, facts.listener_positions, radiator.air);
  sound.far_field = elements.far_field(field, facts.directions);
  double loudest = 0.0;
  for (const Complex pressure : sound.far_field) {
    loudest = std::max(loudest, std::norm(pressure));
  }
  const double whole = square_over(facts, sound.far_field);
  sound.directivity_index = 10.0 * std::log10(4.0 * std::numbers::pi * loudest / whole);
  compare_models(sound, whole, radiator, elements.air(), vibration);
  return sound;
}

std::vector<harmonic::RadiatedSound> sounds_of(const FrequencyGroup& group, SurfaceLevels& levels, double tolerance,
                                               const std::vector<Vibration>& vibrations, const Radiator& radiator) {
  std::vector<std::vector<ComplexVector>> velocities;
  for (std::size_t v = group.first; v < group.last; ++v) {
    velocities.push_back(vibrations[v].velocity);
  }
  const double wave_number = 2.0 * std::numbers::pi * vibrations[group.first].frequency / levels.coarsest().air().speed;
  const RefinedSolution solution = solve_refined(levels, wave_number, std::move(velocities), tolerance);
  std::vector<harmonic::RadiatedSound> sounds;
  for (std::size_t m = 0; m < solution.fields.size(); ++m) {
    sounds.push_back(sound_of(*solution.elements, solution.fields[m], vibrations[group.first + m], radiator));
    sounds.back().level_error = solution.level_error[m];
    sounds.back().refinements = solution.refinements;
  }
  return sounds;
}

/// Those that sounds were solved on.
void add_refined_surfaces(harmonic::Radiation& result, SurfaceLevels& levels) {
  std::size_t most = 0;
  for (const harmonic::RadiatedSound& sound : result.sounds) {
    most = std::max(most, sound.refinements);
  }
  for (std::size_t number = 1; number <= most; ++number) {
    result.surfaces.push_back(levels.level(number)->elements.boundary());
  }
}

}  // namespace

harmonic::Radiation radiated_sounds(const scene::Acoustics& acoustics, std::size_t part, const AcousticSurface& surface,
                                    const std::vector<Vibration>& vibrations, const RadiationOptions& options,
                                    MPI_Comm communicator, const PartWatch& watch) {
  double highest = 0.0;
  for (const Vibration& vibration : vibrations) {
    highest = std::max(highest, vibration.frequency);
  }
  harmonic::Radiation result = facts_of(acoustics, part, surface, highest);
  result.cell = options.cell.value_or(0.0);
  SurfaceLevels levels(surface.boundary,
                       {.density = acoustics.radiation.air.density, .speed = acoustics.radiation.air.speed},
                       options.most_vertices);
  const Radiator radiator{part, surface, result, acoustics.radiation.air};
  const auto groups = groups_of(vibrations);
  const auto ranks = static_cast<std::size_t>(parallel::size_of(communicator));
  std::vector<Complex> own;
  std::size_t next = parallel::rank_of(communicator);
  for (bool goes_on = true; goes_on && next < groups.size();) {
    for (const auto& sound : sounds_of(groups[next], levels, options.tolerance, vibrations, radiator)) {
      pack(sound, own);
    }
    next += ranks;
    goes_on = !watch || watch(std::min(next, groups.size()), groups.size());
  }
  const std::size_t done = parallel::smallest(std::uint64_t{std::min(next, groups.size())}, communicator);
  const auto all = parallel::gather_all(std::span<const Complex>(own), communicator);
  std::vector<std::span<const Complex>> left;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    left.push_back(std::span(all.values).subspan(all.offsets[rank], all.counts[rank]));
  }
  for (std::size_t g = 0; g < done; ++g) {
    for (std::size_t v = groups[g].first; v < groups[g].last; ++v) {
      auto& sound = result.sounds.emplace_back();
      sound.name = vibrations[v].name;
      left[g % ranks] = unpack(left[g % ranks], sound);
    }
  }
  add_refined_surfaces(result, levels);
  return result;
}

}  // namespace idiophone::harmonic
