#include "finite_element_surfaces.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "idiophone/solids/accelerated/accelerated_solid.hpp"

namespace idiophone::bodies {

namespace {

surface::Sampling sampling_of(const Preparation& ready) {
  const auto& audio = ready.scene.audio;
  return {audio.rate,          ready.steps_per_sample,   ready.steps_per_read,
          audio.max_frequency, audio.kernel_wavelengths, ready.scene.radiation.air.impedance()};
}

/// The face that each triangle of fracture faces belongs to, in their order.
std::vector<std::size_t> faces_of_triangles(std::span<const mesh::FractureFace> faces) {
  std::vector<std::size_t> result;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    result.insert(result.end(), faces[face].triangles, face);
  }
  return result;
}

}  // namespace

FiniteElementSurfaces::FiniteElementSurfaces(const Preparation& ready, const propagation::AudibleSurface& surface,
                                             const std::vector<bool>& left_out, MPI_Comm communicator)
    : ready_(ready),
      share_(left_out, ready.part),
      nodes_(share_.nodes()),
      surface_(share_.corners(), share_.positions(), sampling_of(ready)),
      triangle_rows_(
          rows_without(left_out, surface.triangle_ids, surface.first_triangle, share_.triangles(), communicator)),
      vertex_rows_(rows_without(left_out, surface.vertex_ids, surface.first_vertex, share_.vertices(), communicator)) {
  find_fracture_triangles();
}

/// The triangles of its faces are the last ones of a body, in their order (mesh::Mesh::surface).
void FiniteElementSurfaces::find_fracture_triangles() {
  const std::vector<std::size_t>& triangles = share_.triangles();
  std::size_t fracture = 0;
  for (std::size_t body = 0; body < ready_.attachments.bodies.size(); ++body) {
    const std::vector<std::size_t> faces = faces_of_triangles(ready_.attachments.bodies[body].fracture);
    if (faces.empty()) {
      continue;
    }
    const Index end = ready_.offsets.triangles[body + 1];
    const Index begin = end - static_cast<Index>(faces.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (const Index number = ready_.part.triangle_ids[triangles[t]]; number >= begin && number < end) {
        fracture_triangles_.push_back({t, fracture, faces[number - begin]});
      }
    }
    ++fracture;
  }
}

void FiniteElementSurfaces::accelerate(accelerator::Accelerator& accelerator, const motion::Motion& motion) {
  if (share_.triangles().empty()) {
    return;
  }
  const mesh::Part& part = ready_.part;
  accelerated_.emplace(accelerator, share_.corners(), surface_);
  for (std::size_t body = 0; body < part.bodies.size(); ++body) {
    const SurfaceShare of_body = SurfaceShare::of_body(body, part);
    const accelerated::AcceleratedSolid* const solid = motion.dynamics().model(body).on_accelerator();
    if (solid == nullptr || of_body.vertices().empty()) {
      continue;
    }
    std::vector<Index> nodes;
    std::ranges::transform(of_body.nodes(), std::back_inserter(nodes),
                           [&](std::size_t node) { return solid->number(static_cast<Index>(node)); });
    const auto first = std::ranges::lower_bound(share_.vertices(), of_body.vertices().front());
    accelerated_vertices_.push_back(
        {body, static_cast<std::size_t>(first - share_.vertices().begin()), {accelerator, nodes}});
  }
}

void FiniteElementSurfaces::start(const motion::Motion& motion, surface::SurfaceMotion& result) {
  read_displacements(motion);
  open_broken_faces(motion);
  std::vector<double> velocities;
  for (const std::size_t node : nodes_) {
    const auto& v = motion.state()[node].velocity;
    velocities.insert(velocities.end(), v, v + 3);
  }
  motion_ = surface_.start(velocities);
  if (accelerated_) {
    accelerated_->load();
  }
  put(result);
}

void FiniteElementSurfaces::read(motion::Motion& motion) {
  if (accelerated_) {
    motion.update_ghosts_on_accelerator();
    for (const auto& [body, first, nodes] : accelerated_vertices_) {
      accelerated_->displace(first, nodes, motion.dynamics().model(body).on_accelerator()->displacements());
    }
    accelerated_->read();
  } else {
    read_displacements(motion);
    open_broken_faces(motion);
    surface_.read();
  }
}

void FiniteElementSurfaces::take(surface::SurfaceMotion& result) {
  if (accelerated_) {
    accelerated_->take(motion_);
  } else {
    surface_.take(motion_);
  }
  put(result);
}

void FiniteElementSurfaces::read_displacements(const motion::Motion& motion) {
  const std::span<double> displacements = surface_.displacements();
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    std::copy_n(motion.state()[nodes_[v]].displacement, 3, &displacements[3 * v]);
  }
}

void FiniteElementSurfaces::open_broken_faces(const motion::Motion& motion) {
  for (const auto& [triangle, fracture, face] : fracture_triangles_) {
    surface_.set_open(triangle, motion.dynamics().fractures()[fracture].is_broken(face));
  }
}

void FiniteElementSurfaces::put(surface::SurfaceMotion& result) const {
  result.pressure.resize(padded(ready_.part.surface.size()));
  result.position.resize(surface::SurfaceMotion::position_length(ready_.part.vertices.size()));
  for (std::size_t t = 0; t < share_.triangles().size(); ++t) {
    result.pressure[share_.triangles()[t]] = motion_.pressure[t];
  }
  for (std::size_t v = 0; v < share_.vertices().size(); ++v) {
    std::copy_n(&motion_.position[3 * v], 3, &result.position[3 * share_.vertices()[v]]);
  }
}

void FiniteElementSurfaces::archive(parallel::Archive& archive) {
  if (accelerated_ && !archive.restoring()) {
    accelerated_->save();
  }
  surface_.archive(archive, triangle_rows_, vertex_rows_);
  if (accelerated_ && archive.restoring()) {
    accelerated_->load();
  }
}

}  // namespace idiophone::bodies
