#pragma once
// What gmsh says while it works.

#include <string>
#include <string_view>
#include <vector>

namespace idiophone::mesh {

/// Takes gmsh's output as it comes and keeps what a user should read if it fails. Control characters become spaces.
class MesherMessages {
 public:
  void add(std::string_view part);

  /// The newest complete line, or what there is of it.
  [[nodiscard]] std::string last() const;

  /// The newest of the errors kept, without its heading; empty without any.
  [[nodiscard]] std::string last_error() const;

  /// The first warnings and errors without the newest line, each after "\n  gmsh: ".
  [[nodiscard]] std::string complaints() const;

 private:
  void end_line();

  std::string line_;  ///< not complete yet
  std::string last_;
  std::vector<std::string> complaints_;
};

}  // namespace idiophone::mesh
