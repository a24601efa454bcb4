#include "idiophone/run/bodies/channel.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::bodies {

Channels::Channels(std::vector<ChannelGroup*> groups) : groups_(std::move(groups)) {}

std::vector<spectra::Series> Channels::all() const {
  std::vector<spectra::Series> channels;
  for (const ChannelGroup* group : groups_) {
    std::ranges::copy(group->channels(), std::back_inserter(channels));
  }
  return channels;
}

void Channels::subscribe(const std::string& name, Subscriber subscriber) {
  subscriptions_.push_back({spectra::find_series(all(), name).path, std::move(subscriber)});
}

void Channels::subscribe(Subscriber subscriber) {
  subscriptions_.push_back({"", std::move(subscriber)});
}

void Channels::deliver() {
  for (ChannelGroup* group : groups_) {
    const std::vector<std::vector<double>> rows = group->collect();
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const spectra::Series& channel = group->channels()[c];
      for (const auto& [path, subscriber] : subscriptions_) {
        if (path.empty() || path == channel.path) {
          subscriber(channel, rows[c]);
        }
      }
    }
  }
}

}  // namespace idiophone::bodies
