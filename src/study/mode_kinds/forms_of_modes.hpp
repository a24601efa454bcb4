#pragma once
// Kinds of modes of each form of body, from one shape in the axes of the body.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body_form.hpp"

namespace idiophone::mode_kinds {

/// A mode in the axes of a body's form, from its centre.
struct LocalShape {
  Eigen::Matrix3Xd places;         ///< [3 x nodes] m
  Eigen::Matrix3Xd displacements;  ///< [3 x nodes]
};

/// How a kind is called, and whether modes of that name are counted: "bending" with " along z" becomes
/// "bending 1 along z".
struct KindName {
  std::string name;  ///< empty: none
  bool is_counted = false;
  std::string ending = {};
};

/// How often values change their signs, from the first to the last. Values below a share of the largest one count as
/// zero, so that noise changes no sign.
[[nodiscard]] int sign_changes(const std::vector<double>& values, double share);

[[nodiscard]] KindName kind_in_bar(const BodyForm& form, const LocalShape& shape);
[[nodiscard]] KindName kind_in_plate(const BodyForm& form, const LocalShape& shape);
[[nodiscard]] KindName kind_in_round_body(const BodyForm& form, const LocalShape& shape);

}  // namespace idiophone::mode_kinds
