#include "idiophone/source/channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/deck/suggestion.hpp"

namespace idiophone::source {

Channels::Channels(const std::vector<ChannelGroup*>& groups) : groups_(groups) {}

std::vector<store::Series> Channels::all() const {
  std::vector<store::Series> channels;
  for (const ChannelGroup* group : groups_) {
    std::ranges::copy(group->channels(), std::back_inserter(channels));
  }
  return channels;
}

void Channels::subscribe(const std::string& path, Subscriber subscriber) {
  std::vector<std::string> known;
  std::ranges::transform(all(), std::back_inserter(known), &store::Series::path);
  if (std::ranges::find(known, path) == known.end()) {
    throw std::invalid_argument(fmt::format("there is no channel {}{}", path, deck::suggestion(path, known)));
  }
  subscriptions_.push_back({path, std::move(subscriber)});
}

void Channels::subscribe(Subscriber subscriber) {
  subscriptions_.push_back({"", std::move(subscriber)});
}

void Channels::deliver() {
  for (ChannelGroup* group : groups_) {
    const std::vector<std::vector<double>> rows = group->collect();
    for (std::size_t c = 0; c < rows.size(); ++c) {
      const store::Series& channel = group->channels()[c];
      for (const auto& [path, subscriber] : subscriptions_) {
        if (path.empty() || path == channel.path) {
          subscriber(channel, rows[c]);
        }
      }
    }
  }
}

}  // namespace idiophone::source
