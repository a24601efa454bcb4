#pragma once
// A .geo script in memory: gmsh runs scripts from files only.

#include <string>

namespace idiophone::mesher {

class Script {
 public:
  /// @throws std::runtime_error when there is no memory for it
  explicit Script(const std::string& text);
  ~Script();
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;
  Script(Script&&) = delete;
  Script& operator=(Script&&) = delete;

  /// Opens it in gmsh.
  /// @throws what gmsh throws
  void run() const;

 private:
  int file_;
};

}  // namespace idiophone::mesher
