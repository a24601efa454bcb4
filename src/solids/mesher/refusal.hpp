#pragma once
// What is said of a file that no mesh can be made of.

#include <stdexcept>

namespace idiophone::mesher {

/// The file is wrong, and another attempt would not help. A type of its own, because newer versions of gmsh throw
/// std::runtime_error, too; older ones throw std::string.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file has no object of the name that is asked for, or several and no name is given.
class NoSuchObject : public Refusal {
 public:
  using Refusal::Refusal;
};

/// What to do about a surface that can't be filled.
inline constexpr const char* how_to_repair =
    "Repair it in the program that made it, or put a closed surface in its place: `meshing: {repair: wrap}`";

}  // namespace idiophone::mesher
