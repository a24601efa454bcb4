// The independent constants of each symmetry of crystals, and where they stand in the stiffness.

#include <algorithm>
#include <array>

#include "idiophone/scene/anisotropy.hpp"

namespace idiophone::scene {

namespace {

using Constants = std::vector<CrystalConstant>;

CrystalConstant constant(std::string_view places) {
  const std::string name = "c" + std::string(places.substr(0, 2));
  return {.name = name, .is_diagonal = name[1] == name[2], .places = places};
}

CrystalConstant optional_constant(std::string_view places) {
  CrystalConstant result = constant(places);
  result.is_optional = true;
  return result;
}

/// Of the first place of each, which names it.
Constants constants(std::initializer_list<std::string_view> places) {
  Constants result;
  for (const std::string_view of_one : places) {
    result.push_back(constant(of_one));
  }
  return result;
}

Constants all_of(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::cubic:
      return constants({"11 22 33", "12 13 23", "44 55 66"});
    case Symmetry::hexagonal:  // c66 = (c11 - c12)/2
      return constants({"11 22 66/2", "12 -66/2", "13 23", "33", "44 55"});
    case Symmetry::trigonal: {
      Constants result = constants({"11 22 66/2", "12 -66/2", "13 23", "14 -24 56", "33", "44 55"});
      result.push_back(optional_constant("15 -25 -46"));
      return result;
    }
    case Symmetry::tetragonal: {
      Constants result = constants({"11 22", "12", "13 23", "33", "44 55", "66"});
      result.push_back(optional_constant("16 -26"));
      return result;
    }
    case Symmetry::orthotropic:
      return constants({"11", "22", "33", "12", "13", "23", "44", "55", "66"});
    case Symmetry::monoclinic:
      return constants({"11", "22", "33", "12", "13", "23", "44", "55", "66", "15", "25", "35", "46"});
    case Symmetry::triclinic:
      break;
  }
  return constants({"11", "12", "13", "14", "15", "16", "22", "23", "24", "25", "26",
                    "33", "34", "35", "36", "44", "45", "46", "55", "56", "66"});
}

/// Adds a constant at each of its places.
void add(const CrystalConstant& constant, double value, StiffnessMatrix& matrix) {
  std::string_view rest = constant.places;
  while (!rest.empty()) {
    const std::string_view place = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), place.size() + 1));
    const bool is_negative = place.front() == '-';
    const int row = place[is_negative ? 1 : 0] - '1';
    const int column = place[is_negative ? 2 : 1] - '1';
    matrix(row, column) += (is_negative ? -value : value) / (place.ends_with("/2") ? 2 : 1);
    matrix(column, row) = matrix(row, column);
  }
}

}  // namespace

std::span<const CrystalConstant> independent_constants(Symmetry symmetry) {
  static const std::array<Constants, 7> all = {all_of(Symmetry::cubic),       all_of(Symmetry::hexagonal),
                                               all_of(Symmetry::trigonal),    all_of(Symmetry::tetragonal),
                                               all_of(Symmetry::orthotropic), all_of(Symmetry::monoclinic),
                                               all_of(Symmetry::triclinic)};
  return all.at(static_cast<std::size_t>(symmetry));
}

StiffnessMatrix stiffness_matrix(const Crystal& crystal) {
  StiffnessMatrix matrix = StiffnessMatrix::Zero();
  const std::span<const CrystalConstant> each = independent_constants(crystal.symmetry);
  for (std::size_t k = 0; k < each.size(); ++k) {
    add(each[k], crystal.constants.at(k), matrix);
  }
  return matrix;
}

}  // namespace idiophone::scene
