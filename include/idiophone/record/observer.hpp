#pragma once
// What is written down of the motion besides the sound. Each kind of notes keeps its own until the end of the block and
// writes them then, so that nobody waits for another rank inside a block.

#include <mpi.h>

#include "idiophone/record/frames.hpp"
#include "idiophone/source/body_notes.hpp"
#include "idiophone/source/contact_notes.hpp"

namespace idiophone::record {

class Observer {
 public:
  Observer(const source::Preparation& ready, MPI_Comm communicator)
      : body_notes_(ready, communicator), contact_notes_(ready, communicator), frames_(ready, communicator) {}

  /// Declares the series and meshes of a new result. Collective.
  void declare(store::ResultFile& result) const {
    body_notes_.declare(result);
    contact_notes_.declare(result);
    frames_.declare(result);
  }

  /// Notes what is due at an audio sample. No communication.
  void note(std::int64_t sample, motion::Motion& motion) {
    body_notes_.note(sample, motion);
    contact_notes_.note(sample, motion);
    frames_.note(sample, motion);
  }

  /// Writes all notes. Collective, at the end of a block.
  void write(store::ResultFile& result) {
    body_notes_.write(result);
    contact_notes_.write(result);
    frames_.write(result);
  }

  /// What rank 0 has to remember when all notes are written: see source::BodyNotes::save.
  [[nodiscard]] std::vector<double> save() const { return body_notes_.save(); }
  /// Goes on from what `save` gave.
  void restore(std::span<const double> orientations) { body_notes_.restore(orientations); }

 private:
  source::BodyNotes body_notes_;
  source::ContactNotes contact_notes_;
  Frames frames_;
};

}  // namespace idiophone::record
