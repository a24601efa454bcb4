#include "body_surfaces.hpp"

#include <algorithm>
#include <numeric>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/solids/accelerated/accelerated_solid.hpp"

namespace idiophone::bodies {

namespace {

surface::Sampling sampling_of(const Preparation& ready) {
  const auto& audio = ready.scene.audio;
  return {audio.rate,          ready.steps_per_sample,   ready.steps_per_read,
          audio.max_frequency, audio.kernel_wavelengths, ready.scene.radiation.air.impedance()};
}

/// Whose surface follows from few coordinates. [bodies]
std::vector<bool> with_coordinates(const Preparation& ready) {
  std::vector<bool> result(ready.scene.bodies.size());
  for (const auto& [body, basis] : ready.modal_bases) {
    result[body] = true;
  }
  return result;
}

/// The triangles or vertices of some bodies, numbered without gaps, for the archive. Collective.
/// @param numbers  global numbers of this rank's, of all bodies
/// @param first    of each body, and one past the last
/// @param places   those of these bodies among the numbers
parallel::Rows rows_without(const std::vector<bool>& left_out, const std::vector<Index>& numbers,
                            const std::vector<Index>& first, const std::vector<std::size_t>& places,
                            MPI_Comm communicator) {
  std::vector<Index> before = {0};  // numbers left out up to each body
  for (std::size_t body = 0; body < left_out.size(); ++body) {
    before.push_back(before.back() + (left_out[body] ? first[body + 1] - first[body] : 0));
  }
  std::vector<Index> rows;
  for (const std::size_t place : places) {
    const auto body = std::ranges::upper_bound(first, numbers[place]) - first.begin() - 1;
    rows.push_back(numbers[place] - before[body]);
  }
  return {rows, first.back() - before.back(), communicator};
}

/// Places of the triangles of some bodies.
std::vector<std::size_t> triangles_without(const std::vector<bool>& left_out, const mesh::Part& part) {
  std::vector<std::size_t> places;
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    if (!left_out[part.triangle_body[t]]) {
      places.push_back(t);
    }
  }
  return places;
}

std::vector<std::size_t> triangles_of(std::size_t body, const mesh::Part& part) {
  std::vector<bool> others(part.bodies.size(), true);
  others[body] = false;
  return triangles_without(others, part);
}

/// Places of the vertices of some triangles, ascending.
std::vector<std::size_t> vertices_of(const std::vector<std::size_t>& triangles, const mesh::Part& part) {
  std::vector<std::size_t> places;
  for (const std::size_t t : triangles) {
    places.insert(places.end(), part.surface[t].begin(), part.surface[t].end());
  }
  keep_each_once(places);
  return places;
}

/// The same triangles, as places among some vertices.
std::vector<mesh::Triangle> renumbered(const std::vector<std::size_t>& triangles,
                                       const std::vector<std::size_t>& vertices, const mesh::Part& part) {
  std::vector<mesh::Triangle> result;
  for (const std::size_t t : triangles) {
    mesh::Triangle& triangle = result.emplace_back(part.surface[t]);
    for (Index& vertex : triangle) {
      vertex =
          static_cast<Index>(std::ranges::lower_bound(vertices, static_cast<std::size_t>(vertex)) - vertices.begin());
    }
  }
  return result;
}

std::vector<Vector3> positions(const std::vector<std::size_t>& vertices, const mesh::Part& part) {
  std::vector<Vector3> result;
  std::ranges::transform(vertices, std::back_inserter(result),
                         [&](std::size_t vertex) { return part.reference[part.vertices[vertex]]; });
  return result;
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

BodySurfaces::BodySurfaces(const Preparation& ready, const propagation::AudibleSurface& surface, MPI_Comm communicator)
    : ready_(ready),
      communicator_(communicator),
      triangles_(triangles_without(with_coordinates(ready), ready.part)),
      vertices_(vertices_of(triangles_, ready.part)),
      finite_elements_(renumbered(triangles_, vertices_, ready.part), positions(vertices_, ready.part),
                       sampling_of(ready)),
      triangle_rows_(rows_without(with_coordinates(ready), surface.triangle_ids, surface.first_triangle, triangles_,
                                  communicator)),
      vertex_rows_(
          rows_without(with_coordinates(ready), surface.vertex_ids, surface.first_vertex, vertices_, communicator)) {
  find_fracture_triangles();
  for (const auto& [body, basis] : ready.modal_bases) {
    const mesh::BodyPart& here = ready.part.bodies[body];
    if (here.owned_begin < here.owned_end) {
      add_modal_body(body, basis);
    }
  }
}

/// The triangles of its faces are the last ones of a body, in their order (mesh::Mesh::surface).
void BodySurfaces::find_fracture_triangles() {
  std::size_t fracture = 0;
  for (std::size_t body = 0; body < ready_.attachments.bodies.size(); ++body) {
    const std::vector<std::size_t> faces = faces_of_triangles(ready_.attachments.bodies[body].fracture);
    if (faces.empty()) {
      continue;
    }
    const Index end = ready_.offsets.triangles[body + 1];
    const Index begin = end - static_cast<Index>(faces.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (const Index number = ready_.part.triangle_ids[triangles_[t]]; number >= begin && number < end) {
        fracture_triangles_.push_back({t, fracture, faces[number - begin]});
      }
    }
    ++fracture;
  }
}

void BodySurfaces::open_broken_faces(const motion::Motion& motion) {
  for (const auto& [triangle, fracture, face] : fracture_triangles_) {
    finite_elements_.set_open(triangle, motion.dynamics().fractures()[fracture].is_broken(face));
  }
}

void BodySurfaces::add_modal_body(std::size_t body, const modal_bodies::ModalBasis& basis) {
  const mesh::Part& part = ready_.part;
  const std::vector<std::size_t> triangles = triangles_of(body, part);
  const std::vector<std::size_t> vertices = vertices_of(triangles, part);
  std::vector<std::size_t> nodes;
  std::ranges::transform(vertices, std::back_inserter(nodes), [&](std::size_t vertex) -> std::size_t {
    return part.vertices[vertex] - part.bodies[body].owned_begin;
  });
  const ModalSurface::Shape shape{renumbered(triangles, vertices, part), std::move(nodes), positions(vertices, part),
                                  ready_.initial_state.centres[body]};
  modal_.push_back({body,
                    {triangles.front(), triangles.size()},
                    {vertices.front(), vertices.size()},
                    ModalSurface(basis, shape, sampling())});
}

void BodySurfaces::accelerate(accelerator::Accelerator& accelerator, const motion::Motion& motion) {
  if (triangles_.empty()) {
    return;
  }
  const mesh::Part& part = ready_.part;
  accelerated_.emplace(accelerator, renumbered(triangles_, vertices_, part), finite_elements_);
  for (std::size_t body = 0; body < part.bodies.size(); ++body) {
    const std::vector<std::size_t> vertices = vertices_of(triangles_of(body, part), part);
    const accelerated::AcceleratedSolid* const solid = motion.dynamics().model(body).on_accelerator();
    if (solid == nullptr || vertices.empty()) {
      continue;
    }
    std::vector<Index> nodes;
    std::ranges::transform(vertices, std::back_inserter(nodes),
                           [&](std::size_t vertex) { return solid->number(part.vertices[vertex]); });
    const auto first = std::ranges::lower_bound(vertices_, vertices.front()) - vertices_.begin();
    accelerated_vertices_.push_back({body, static_cast<std::size_t>(first), {accelerator, nodes}});
  }
}

void BodySurfaces::start(const motion::Motion& motion, surface::SurfaceMotion& result) {
  read_displacements(motion);
  open_broken_faces(motion);
  std::vector<double> velocities;
  for (const std::size_t vertex : vertices_) {
    const auto& v = motion.state()[ready_.part.vertices[vertex]].velocity;
    velocities.insert(velocities.end(), v, v + 3);
  }
  finite_elements_motion_ = finite_elements_.start(velocities);
  if (accelerated_) {
    accelerated_->load();
  }
  put_finite_elements(result);
  for (ModalBody& body : modal_) {
    body.surface.start(*motion.dynamics().model(body.number).modal_state(), body.pressure(result),
                       body.position(result));
  }
}

void BodySurfaces::read(motion::Motion& motion) {
  if (accelerated_) {
    motion.update_ghosts_on_accelerator();
    for (const auto& [body, first, nodes] : accelerated_vertices_) {
      accelerated_->displace(first, nodes, motion.dynamics().model(body).on_accelerator()->displacements());
    }
    accelerated_->read();
  } else {
    read_displacements(motion);
    open_broken_faces(motion);
    finite_elements_.read();
  }
  for (ModalBody& body : modal_) {
    body.surface.read(*motion.dynamics().model(body.number).modal_state());
  }
}

void BodySurfaces::take(surface::SurfaceMotion& result) {
  if (accelerated_) {
    accelerated_->take(finite_elements_motion_);
  } else {
    finite_elements_.take(finite_elements_motion_);
  }
  put_finite_elements(result);
  for (ModalBody& body : modal_) {
    body.surface.take(body.pressure(result), body.position(result));
  }
}

void BodySurfaces::read_displacements(const motion::Motion& motion) {
  const std::span<double> displacements = finite_elements_.displacements();
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const auto& u = motion.state()[ready_.part.vertices[vertices_[v]]].displacement;
    std::copy_n(u, 3, &displacements[3 * v]);
  }
}

void BodySurfaces::put_finite_elements(surface::SurfaceMotion& result) const {
  result.pressure.resize(padded(ready_.part.surface.size()));
  result.position.resize(surface::SurfaceMotion::position_length(ready_.part.vertices.size()));
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    result.pressure[triangles_[t]] = finite_elements_motion_.pressure[t];
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    std::copy_n(&finite_elements_motion_.position[3 * v], 3, &result.position[3 * vertices_[v]]);
  }
}

double BodySurfaces::largest_vibration(std::size_t body) const {
  const auto here = std::ranges::find(modal_, body, &ModalBody::number);
  return here == modal_.end() ? 0.0 : here->surface.largest_vibration();
}

double BodySurfaces::largest_rotation(std::size_t body) const {
  const auto here = std::ranges::find(modal_, body, &ModalBody::number);
  return here == modal_.end() ? 0.0 : here->surface.largest_rotation();
}

void BodySurfaces::archive(parallel::Archive& archive) {
  if (accelerated_ && !archive.restoring()) {
    accelerated_->save();
  }
  finite_elements_.archive(archive, triangle_rows_, vertex_rows_);
  if (accelerated_ && archive.restoring()) {
    accelerated_->load();
  }
  for (const auto& [body, basis] : ready_.modal_bases) {
    const auto here = std::ranges::find(modal_, body, &ModalBody::number);
    const std::size_t all = ModalSurface::coordinates(basis);
    std::vector<Index> numbers(here == modal_.end() ? 0 : all);
    std::iota(numbers.begin(), numbers.end(), 0);
    archive.rows("surface/modal/" + ready_.scene.bodies[body].name + "/coordinates",
                 parallel::Rows(numbers, static_cast<std::int64_t>(all), communicator_),
                 [&](std::size_t row, parallel::ArchiveRow& values) { here->surface.archive(row, values); });
  }
}

}  // namespace idiophone::bodies
