#pragma once
// Writes all motion channels to the result.

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/run/record/recorder.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::record {

/// One subscriber of the channels among others; it makes them deliver at the end of each block.
class ChannelRecorder : public Recorder {
 public:
  /// @param channels, result  must outlive this object
  ChannelRecorder(bodies::Channels& channels, results::ResultFile& result);

  void declare() override;
  /// The source notes its channels itself.
  void note(std::int64_t /*sample*/, const surface::SurfaceMotion& /*motion*/) override {}
  void write() override { channels_.deliver(); }
  /// The source archives its channels, and the result its lengths.
  void archive(parallel::Archive& /*archive*/) override {}

 private:
  bodies::Channels& channels_;
  results::ResultFile& result_;
};

}  // namespace idiophone::record
