#pragma once
// What sound maps cost.

#include <cstddef>

namespace idiophone::voices {

/// Processor time per time of sound, as it is estimated. A listener who moves past a body, or a body that moves, makes
/// both its sound here and its sound there, so that one can fade into the other.
class MapCosts {
 public:
  /// @param speed      of the machine, as MapDetail::speed
  /// @param receivers  that each body is heard by
  MapCosts(int rate, double speed, std::size_t receivers);

  /// Of the way from a body to the receivers.
  [[nodiscard]] double of_body(bool moves) const { return outputs_ * (moves ? moving_body_ : body_); }

  /// Of a group of modes that rings.
  [[nodiscard]] double of_group(bool moves) const {
    return group_ + outputs_ * (moves ? moving_group_of_output_ : group_of_output_);
  }

  /// Of a body on which forces act, without what its stretching costs.
  [[nodiscard]] double of_driven(std::size_t groups, bool moves) const {
    return of_body(moves) + static_cast<double>(groups) * driven_group_;
  }

  /// Of multiply-adds of its stretching in an audio sample.
  [[nodiscard]] double of_stretching(std::size_t operations) const {
    return static_cast<double>(operations) * multiply_add_;
  }

  /// Of the choice among the modes of a body that rings, heard or not.
  [[nodiscard]] double of_choice(std::size_t groups) const {
    return choice_ + static_cast<double>(groups) * choice_of_group_;
  }

 private:
  double outputs_;
  double body_, moving_body_;  // of an output, as the next two
  double group_, group_of_output_, moving_group_of_output_, driven_group_;
  double choice_, choice_of_group_, multiply_add_;
};

}  // namespace idiophone::voices
