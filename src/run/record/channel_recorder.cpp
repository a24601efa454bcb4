#include "idiophone/run/record/channel_recorder.hpp"

namespace idiophone::record {

ChannelRecorder::ChannelRecorder(bodies::Channels& channels, results::ResultFile& result)
    : channels_(channels), result_(result) {
  channels_.subscribe(
      [&result](const spectra::Series& channel, std::span<const double> rows) { result.append(channel.path, rows); });
}

void ChannelRecorder::declare() {
  for (const spectra::Series& channel : channels_.all()) {
    result_.declare(channel);
  }
}

}  // namespace idiophone::record
