#include "idiophone/record/channel_recorder.hpp"

namespace idiophone::record {

ChannelRecorder::ChannelRecorder(source::Channels& channels, store::ResultFile& result)
    : channels_(channels), result_(result) {
  channels_.subscribe(
      [&result](const store::Series& channel, std::span<const double> rows) { result.append(channel.path, rows); });
}

void ChannelRecorder::declare() {
  for (const store::Series& channel : channels_.all()) {
    result_.declare(channel);
  }
}

}  // namespace idiophone::record
