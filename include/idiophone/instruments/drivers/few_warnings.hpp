#pragma once
// Warnings of what others send, of which there can be any number.

#include <cstddef>
#include <string>

namespace idiophone::drivers {

/// Logs the first warnings and counts the others, so that a flood of them takes no time and fills no log.
class FewWarnings {
 public:
  static constexpr std::size_t most = 20;

  /// @param text  codes that would control a terminal are replaced
  void warn(std::string text);

  /// Of all, logged or not.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

}  // namespace idiophone::drivers
