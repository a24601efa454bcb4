// All that decides the future of bodies of finite elements.

#include "idiophone/source/finite_element_source.hpp"

namespace idiophone::source {

namespace {

/// The elements of a body computed here, ghosts included: those have the same rows as their owners'.
parallel::Rows element_rows(const Preparation& ready, std::size_t body, MPI_Comm communicator) {
  std::vector<Index> numbers = ready.part.bodies[body].element_ids;
  const Index first = ready.offsets.elements[body];
  for (Index& number : numbers) {
    number -= first;
  }
  return {numbers, ready.offsets.elements[body + 1] - first, communicator};
}

}  // namespace

void FiniteElementSource::archive(parallel::Archive& archive) {
  archive_contacts(archive);  // before the motion, whose restored state finds the contact forces
  archive_motion(archive);
  archive_surface(archive);
  stability_.archive(archive);
  body_channels_.archive(archive);
  contact_channels_.archive(archive);
}

void FiniteElementSource::archive_contacts(parallel::Archive& archive) {
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const std::string path = "contact/" + ready_.scene.contacts[c].name;
    double depth = deepest(c);
    archive.root(path + "/deepest", depth);
    archive.rows(
        path + "/bonds", node_rows_, contact::Contacts::bond_width,
        [&] { return motion_.contacts().save(c, ready_.part.owned_nodes); },
        [&](const std::vector<double>& bonds) { motion_.contacts().restore(c, bonds, depth); });
  }
}

void FiniteElementSource::archive_motion(parallel::Archive& archive) {
  archive.root("motion/sample", sample_);
  ReproducibleSum work = motion_.work();
  archive.sum("motion/work", work);
  archive.rows(
      "motion/nodes", node_rows_, motion::Motion::saved_width, [&] { return motion_.save(); },
      [&](const std::vector<double>& rows) { motion_.restore(sample_ * ready_.steps_per_sample, rows, work); });
  for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
    if (const auto width = static_cast<int>(motion_.memory_width(b)); width > 0) {
      archive.rows(
          "motion/memory/" + ready_.scene.bodies[b].name, element_rows(ready_, b, communicator_), width,
          [&] { return motion_.save_memory(b); },
          [&](const std::vector<double>& rows) { motion_.restore_memory(b, rows); });
    }
  }
}

void FiniteElementSource::archive_surface(parallel::Archive& archive) {
  const std::size_t triangle_width = surface_.triangle_state_size();
  const std::size_t vertex_width = surface_.vertex_state_size();
  std::vector<double> triangles(triangle_width * surface_.triangles());
  std::vector<double> vertices(vertex_width * surface_.vertices());
  if (!archive.restoring()) {
    surface_.save(triangles, vertices);
  }
  archive.rows("surface/triangles", triangle_rows_, static_cast<int>(triangle_width), triangles);
  archive.rows("surface/vertices", vertex_rows_, static_cast<int>(vertex_width), vertices);
  if (archive.restoring()) {
    surface_.restore(triangles, vertices);
  }
}

}  // namespace idiophone::source
