#include "idiophone/scene/still_receivers.hpp"

namespace idiophone::scene {

std::vector<StillReceiver> still_receivers(std::span<const Listener> listeners) {
  std::vector<StillReceiver> all;
  for (const Listener& listener : listeners) {
    const std::size_t members = listener.head ? 1 : listener.receivers.size();
    for (std::size_t r = 0; r < members; ++r) {
      const Receiver& receiver = listener.receivers[r];
      all.push_back(
          {listener.head ? listener.name : receiver.channel, listener.place(receiver, 0.0).position, &receiver});
    }
  }
  return all;
}

}  // namespace idiophone::scene
