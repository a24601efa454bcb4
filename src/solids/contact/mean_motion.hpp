#pragma once

#include "idiophone/solids/contact/contact_motion.hpp"

namespace idiophone::contact {

/// The mean of a contact's motion over some steps. The contact force weights points, normals and slip.
class MeanMotion {
 public:
  /// Counts one more step.
  void add(const ContactMotion& now) {
    const double weight = now.force.norm();
    sum_.force += now.force;
    sum_.overlap += now.overlap;
    sum_.point += weight * now.point;
    sum_.normal += weight * now.normal;
    sum_.slip += weight * now.slip;
    sum_.spread += weight * (now.spread + now.point * now.point.transpose());
    weight_ += weight;
    ++steps_;
  }

  /// The mean since the last call; zero if there was no step.
  [[nodiscard]] ContactMotion take() {
    ContactMotion mean = sum_;
    if (steps_ > 0) {
      mean.force /= steps_;
      mean.overlap /= steps_;
    }
    if (weight_ > 0) {
      mean.point /= weight_;
      mean.normal.normalize();
      mean.slip /= weight_;
      mean.spread = mean.spread / weight_ - mean.point * mean.point.transpose();
    }
    *this = {};
    return mean;
  }

 private:
  ContactMotion sum_;
  double weight_ = 0.0;  ///< N
  int steps_ = 0;
};

}  // namespace idiophone::contact
