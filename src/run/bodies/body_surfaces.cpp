#include "body_surfaces.hpp"

#include <algorithm>
#include <numeric>

#include "surface_share.hpp"

namespace idiophone::bodies {

namespace {

/// Whose surface follows from few coordinates. [bodies]
std::vector<bool> with_coordinates(const Preparation& ready) {
  std::vector<bool> result(ready.scene.bodies.size());
  for (const auto& [body, basis] : ready.modal_bases) {
    result[body] = true;
  }
  return result;
}

}  // namespace

BodySurfaces::BodySurfaces(const Preparation& ready, const propagation::AudibleSurface& surface, MPI_Comm communicator)
    : ready_(ready),
      communicator_(communicator),
      finite_elements_(ready, surface, with_coordinates(ready), communicator) {
  for (const auto& [body, basis] : ready.modal_bases) {
    const mesh::BodyPart& here = ready.part.bodies[body];
    if (here.owned_begin < here.owned_end) {
      add_modal_body(body, basis);
    }
  }
}

void BodySurfaces::add_modal_body(std::size_t body, const modal_bodies::ModalBasis& basis) {
  const SurfaceShare share = SurfaceShare::of_body(body, ready_.part);
  std::vector<std::size_t> nodes = share.nodes();
  for (std::size_t& node : nodes) {
    node -= ready_.part.bodies[body].owned_begin;
  }
  const ModalSurface::Shape shape{share.corners(), std::move(nodes), share.positions(),
                                  ready_.initial_state.centres[body]};
  modal_.push_back({body,
                    {share.triangles().front(), share.triangles().size()},
                    {share.vertices().front(), share.vertices().size()},
                    ModalSurface(basis, shape, sampling())});
}

void BodySurfaces::start(const motion::Motion& motion, surface::SurfaceMotion& result) {
  finite_elements_.start(motion, result);
  for (ModalBody& body : modal_) {
    body.surface.start(*motion.dynamics().model(body.number).modal_state(), body.pressure(result),
                       body.position(result));
  }
}

void BodySurfaces::read(motion::Motion& motion) {
  finite_elements_.read(motion);
  for (ModalBody& body : modal_) {
    body.surface.read(*motion.dynamics().model(body.number).modal_state());
  }
}

void BodySurfaces::take(surface::SurfaceMotion& result) {
  finite_elements_.take(result);
  for (ModalBody& body : modal_) {
    body.surface.take(body.pressure(result), body.position(result));
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
  finite_elements_.archive(archive);
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
