// The measured responses of a listener's head.

#include <memory>
#include <utility>

#include "idiophone/air/receivers/head_responses.hpp"
#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::voices {

Audience::Audience(scene::Listener listener, int rate) : Audience(std::move(listener)) {
  if (!listener_->head) {
    return;
  }
  head_ = [head = std::make_shared<const receivers::HeadResponses>(listener_->head->responses, rate)](
              const Vector3& direction) {
    std::vector<double> both;
    for (const std::vector<double>& ear : head->responses(head->nearest(direction))) {
      both.insert(both.end(), ear.begin(), ear.end());
    }
    return both;
  };
}

}  // namespace idiophone::voices
