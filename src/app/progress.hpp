#pragma once
// What rank 0 tells while a run goes on: one updating line on a terminal, plain lines now and then in a log.

#include <cstdint>

#include "preparation.hpp"
#include "stages.hpp"

namespace idiophone::app {

class Progress {
 public:
  /// @param done    audio samples done before, by the run that is resumed
  /// @param line    whether to update one line, as on a terminal; lines of a log otherwise
  /// @param speaks  whether this rank prints
  Progress(const Preparation& ready, std::int64_t last_sample, std::int64_t done, bool line, bool speaks);

  /// At the end of a block.
  /// @param loudest  largest magnitude of any audio sample so far, in the model's unit
  void tell(std::int64_t done, double loudest, int checkpoints);

  /// At the end of the run: speed, and each stage's share.
  /// @param ranks  of the job
  void conclude(std::int64_t done, const Stages& stages, int ranks) const;

 private:
  const Preparation& ready_;
  std::int64_t last_sample_;
  std::int64_t resumed_at_;
  bool speaks_;
  bool line_;
  double start_;
  double told_ = -1e9;
};

}  // namespace idiophone::app
