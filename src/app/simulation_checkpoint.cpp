// All that decides the future of a run, to a checkpoint and back on any number of ranks.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>

#include "simulation.hpp"

namespace idiophone::app {

namespace {

constexpr int node_width = 6;  // displacement and velocity

std::string memory_path(const scene::Body& body) {
  return "motion/memory/" + body.name;
}

/// The elements of a body computed here, ghosts included: those have the same rows as their owners'.
parallel::Rows element_rows(const source::Preparation& ready, std::size_t body, MPI_Comm communicator) {
  std::vector<Index> numbers = ready.part.bodies[body].element_ids;
  const Index first = ready.offsets.elements[body];
  for (Index& number : numbers) {
    number -= first;
  }
  return {numbers, ready.offsets.elements[body + 1] - first, communicator};
}

}  // namespace

void Simulation::write_checkpoint() {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::store);
  store::CheckpointWriter writer(checkpoint_directory_, identity_, {motion_.step_number(), sample_}, communicator_);
  writer.add_rows("motion/nodes", node_rows_, node_width, std::span<const double>(motion_.save()));
  for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
    if (const auto width = static_cast<int>(motion_.memory_width(b)); width > 0) {
      writer.add_rows(memory_path(ready_.scene.bodies[b]), element_rows(ready_, b, communicator_), width,
                      std::span<const double>(motion_.save_memory(b)));
    }
  }
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const std::string path = "contact/" + ready_.scene.contacts[c].name;
    writer.add_rows(path + "/bonds", node_rows_, contact::Contacts::bond_width,
                    std::span<const double>(motion_.contacts().save(c, ready_.part.owned_nodes)));
    const double deepest = this->deepest(c);
    writer.add_root(path + "/deepest", std::span<const double>(&deepest, 1));
  }

  const auto triangle_width = surface_.triangle_state_size();
  const auto vertex_width = surface_.vertex_state_size();
  std::vector<double> triangles(triangle_width * surface_.triangles());
  std::vector<double> vertices(vertex_width * surface_.vertices());
  surface_.save(triangles, vertices);
  writer.add_rows("surface/triangles", triangle_rows_, static_cast<int>(triangle_width),
                  std::span<const double>(triangles));
  writer.add_rows("surface/vertices", vertex_rows_, static_cast<int>(vertex_width), std::span<const double>(vertices));

  audio_path_.save(writer, triangle_rows_);
  auto work = motion_.work().words();
  MPI_Allreduce(MPI_IN_PLACE, work.data(), static_cast<int>(work.size()), MPI_INT64_T, MPI_SUM, communicator_);
  writer.add_root("motion/work", std::span<const std::int64_t>(work));
  const std::array<double, 2> scales = {energy_at_start_, largest_given_};
  writer.add_root("run/scales", std::span<const double>(scales));
  writer.add_root("motion/orientations", std::span<const double>(observer_.save()));
  for (const auto& [path, length] : result_->lengths()) {
    writer.add_root("run/lengths" + path, std::span<const std::int64_t>(&length, 1));
  }
  result_->flush();
  const auto path = writer.commit(ready_.scene.output.checkpoint_keep);
  last_checkpoint_ = MPI_Wtime();
  ++checkpoints_;
  if (rank_ == 0) {
    spdlog::info("checkpoint {} at {:.6g} s", path.string(), static_cast<double>(sample_) / ready_.scene.audio.rate);
  }
}

void Simulation::resume_from(const store::CheckpointReader& checkpoint) {
  sample_ = checkpoint.moment().sample;
  try {
    result_ = store::ResultFile::open(result_path_, communicator_);
    if (recorder_) {
      recorder_->resume(sample_);
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        fmt::format("{}; resuming goes on with this file, so bring it back, or, to start again from the beginning, "
                    "leave --resume out",
                    error.what()));
  }
  store::Lengths lengths;
  for (const auto& [path, length] : result_->lengths()) {
    lengths[path] = checkpoint.read_integer_root("run/lengths" + path).at(0);
  }
  result_->cut(lengths);

  const std::vector<double> scales = checkpoint.read_root("run/scales");
  energy_at_start_ = scales.at(0);
  largest_given_ = scales.at(1);

  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const std::string path = "contact/" + ready_.scene.contacts[c].name;
    motion_.contacts().restore(c, checkpoint.read_rows(path + "/bonds", node_rows_, contact::Contacts::bond_width),
                               checkpoint.read_root(path + "/deepest").at(0));
  }
  ReproducibleSum::Words work;
  std::ranges::copy(checkpoint.read_integer_root("motion/work"), work.begin());
  motion_.restore(checkpoint.moment().step, checkpoint.read_rows("motion/nodes", node_rows_, node_width),
                  rank_ == 0 ? ReproducibleSum::from_words(work) : ReproducibleSum());
  for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
    if (const auto width = static_cast<int>(motion_.memory_width(b)); width > 0) {
      motion_.restore_memory(
          b, checkpoint.read_rows(memory_path(ready_.scene.bodies[b]), element_rows(ready_, b, communicator_), width));
    }
  }
  observer_.restore(checkpoint.read_root("motion/orientations"));
  surface_.restore(
      checkpoint.read_rows("surface/triangles", triangle_rows_, static_cast<int>(surface_.triangle_state_size())),
      checkpoint.read_rows("surface/vertices", vertex_rows_, static_cast<int>(surface_.vertex_state_size())));
  audio_path_.restore(checkpoint, triangle_rows_);
  if (rank_ == 0) {
    spdlog::info("resuming from {} at {:.6g} s", checkpoint.path().string(),
                 static_cast<double>(sample_) / ready_.scene.audio.rate);
  }
}

}  // namespace idiophone::app
