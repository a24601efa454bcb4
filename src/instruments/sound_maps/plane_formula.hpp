#pragma once
// Formulas of x and y in decks, read by muParser.

#include <memory>
#include <string>

namespace idiophone::sound_maps {

/// A formula such as "0.2*(1 + x^2)". Copies share the parser, so use them on one thread.
class PlaneFormula {
 public:
  /// @throws std::invalid_argument if it is no formula
  explicit PlaneFormula(const std::string& text);

  /// What is wrong with a formula; empty if nothing is.
  [[nodiscard]] static std::string error_in(const std::string& text);

  /// Its value at a place. It can be infinite or not a number. @param x, y  m
  [[nodiscard]] double operator()(double x, double y) const;

 private:
  struct Parser;
  std::shared_ptr<Parser> parser_;
};

}  // namespace idiophone::sound_maps
