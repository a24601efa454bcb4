#include "idiophone/instruments/proxy_bodies/proxy_source.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "idiophone/air/surface/spread_radii.hpp"
#include "idiophone/foundation/each_once.hpp"

namespace idiophone::proxy_bodies {

namespace {

/// Masses of a lattice's surface, ascending.
std::vector<Index> surface_masses(const proxies::Lattice& lattice) {
  std::vector<Index> masses;
  for (const auto& triangle : lattice.mesh().surface) {
    masses.insert(masses.end(), triangle.begin(), triangle.end());
  }
  keep_each_once(masses);
  return masses;
}

std::vector<Index> surface_masses(const std::vector<ProxyBody>& bodies) {
  std::vector<Index> all;
  for (const ProxyBody& body : bodies) {
    const std::vector<Index> masses = surface_masses(*body.lattice);
    all.insert(all.end(), masses.begin(), masses.end());
  }
  return all;
}

void add_surface(const ProxyBody& body, propagation::AudibleSurface& surface) {
  const std::vector<Index> masses = surface_masses(*body.lattice);
  const auto first = static_cast<Index>(surface.reference.size());
  for (const Index mass : masses) {
    surface.reference.push_back(body.lattice->mesh().nodes[mass]);
  }
  for (mesh::Triangle triangle : body.lattice->mesh().surface) {
    for (Index& corner : triangle) {
      corner = first + static_cast<Index>(std::ranges::lower_bound(masses, corner) - masses.begin());
    }
    surface.triangles.push_back(triangle);
  }
  surface.bodies.push_back(body.name);
  surface.first_triangle.push_back(static_cast<Index>(surface.triangles.size()));
  surface.first_vertex.push_back(static_cast<Index>(surface.reference.size()));
}

propagation::AudibleSurface surface_of(const std::vector<ProxyBody>& bodies, const scene::Radiation& radiation) {
  propagation::AudibleSurface surface;
  surface.first_triangle = surface.first_vertex = {0};
  for (const ProxyBody& body : bodies) {
    add_surface(body, surface);
  }
  surface.triangle_ids.resize(surface.triangles.size());
  surface.vertex_ids.resize(surface.reference.size());
  std::iota(surface.triangle_ids.begin(), surface.triangle_ids.end(), 0);
  std::iota(surface.vertex_ids.begin(), surface.vertex_ids.end(), 0);
  if (radiation.needs_radii()) {
    surface.radii = surface::spread_radii(surface.triangle_ids, surface.first_triangle, [&](std::size_t body) {
      std::vector<std::array<Vector3, 3>> whole;
      for (Index t = surface.first_triangle[body]; t < surface.first_triangle[body + 1]; ++t) {
        const auto& [i, j, k] = surface.triangles[t];
        whole.push_back({surface.reference[i], surface.reference[j], surface.reference[k]});
      }
      return whole;
    });
  }
  return surface;
}

/// Enough reads that the mean velocity over each loses at most 0.1 dB at the largest frequency, as
/// surface::choose_steps_per_read() has it.
surface::Sampling sampling_of(const scene::Scene& scene) {
  const int reads = static_cast<int>(std::ceil(12.0 * scene.audio.max_frequency / scene.audio.rate));
  return {scene.audio.rate,
          reads,
          1,
          scene.audio.max_frequency,
          scene.audio.kernel_wavelengths,
          scene.radiation.air.impedance()};
}

}  // namespace

ProxySource::ProxySource(const std::vector<ProxyBody>& bodies, std::vector<proxies::Force> forces,
                         const scene::Scene& scene, const proxies::ProxyOptions& options)
    : bodies::Source(surface_of(bodies, scene.radiation)),
      masses_(surface_masses(bodies)),
      surface_(surface().triangles, surface().reference, sampling_of(scene)) {
  if (scene.radiation.grid.back) {
    throw std::runtime_error("the air cannot act on proxies; leave radiation.back out of the deck");
  }
  proxies::ProxyOptions chosen = options;
  chosen.rate = static_cast<double>(scene.audio.rate) * surface_.sampling().reads_per_sample();
  for (const ProxyBody& body : bodies) {
    proxies_.emplace_back(body.lattice, chosen);
    tracks_.push_back(body.track);
  }
  std::ranges::stable_sort(forces, {}, &proxies::Force::start);
  for (proxies::Force& force : forces) {
    const proxies::Contact contact = bodies.at(force.body).lattice->contact_at(force.at);
    forces_.push_back({.force = std::move(force), .contact = contact});
  }
}

void ProxySource::start(surface::SurfaceMotion& motion) {
  write_displacements();
  motion = surface_.start();
  follow_tracks(motion);
}

void ProxySource::advance(surface::SurfaceMotion& motion) {
  for (int read = 0; read < surface_.sampling().reads_per_sample(); ++read) {
    for (std::size_t body = 0; body < proxies_.size(); ++body) {
      find_forces(body);
      proxies_[body].advance(present_);
    }
    write_displacements();
    surface_.read();
  }
  ++sample_;
  std::erase_if(forces_, [&](const ActingForce& acting) {
    return acting.force.start + static_cast<std::int64_t>(acting.force.curve.size()) <= sample_;
  });
  surface_.take(motion);
  follow_tracks(motion);
}

/// The sound is that of the vibration: pressures stay what they are.
void ProxySource::follow_tracks(surface::SurfaceMotion& motion) const {
  const double time = static_cast<double>(first_sample() + sample_) / surface_.sampling().rate;
  for (std::size_t body = 0; body < tracks_.size(); ++body) {
    if (!tracks_[body]) {
      continue;
    }
    const Eigen::Isometry3d track = tracks_[body](time);
    for (Index vertex = surface().first_vertex[body]; vertex < surface().first_vertex[body + 1]; ++vertex) {
      Eigen::Map<Vector3> position(&motion.position[3 * static_cast<std::size_t>(vertex)]);
      position = track * position;
    }
  }
}

std::vector<double> ProxySource::displacement(std::size_t body) const {
  const double time = static_cast<double>(sample_) / surface_.sampling().rate;
  const Eigen::Isometry3d track = tracks_[body] ? tracks_[body](time) : Eigen::Isometry3d::Identity();
  const std::vector<Vector3>& nodes = proxies_[body].lattice().mesh().nodes;
  std::vector<double> displacement;
  for (std::size_t mass = 0; mass < nodes.size(); ++mass) {
    const Vector3 moved = track * (nodes[mass] + proxies_[body].displacement(static_cast<Index>(mass))) - nodes[mass];
    displacement.insert(displacement.end(), moved.begin(), moved.end());
  }
  return displacement;
}

void ProxySource::archive(parallel::Archive& /*archive*/) {
  throw std::logic_error("proxies have no checkpoints");
}

void ProxySource::find_forces(std::size_t body) {
  present_.clear();
  for (const ActingForce& acting : forces_) {
    if (acting.force.start > sample_) {
      break;  // later ones begin later
    }
    if (acting.force.body == body) {
      const double value = acting.force.curve[static_cast<std::size_t>(sample_ - acting.force.start)];
      present_.push_back({.contact = acting.contact, .force = value * acting.force.direction});
    }
  }
}

void ProxySource::write_displacements() {
  const std::span<double> displacements = surface_.displacements();
  for (std::size_t body = 0; body < proxies_.size(); ++body) {
    for (Index vertex = surface().first_vertex[body]; vertex < surface().first_vertex[body + 1]; ++vertex) {
      const Vector3 displacement = proxies_[body].displacement(masses_[vertex]);
      std::ranges::copy(displacement, &displacements[3 * static_cast<std::size_t>(vertex)]);
    }
  }
}

}  // namespace idiophone::proxy_bodies
