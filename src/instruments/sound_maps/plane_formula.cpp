#include "plane_formula.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <limits>
#include <numbers>
#include <stdexcept>

namespace idiophone::sound_maps {

struct PlaneFormula::Parser {
  mu::Parser formula;
  double x = 0.0;
  double y = 0.0;
};

PlaneFormula::PlaneFormula(const std::string& text) : parser_(std::make_shared<Parser>()) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) {
    throw std::invalid_argument(fmt::format("the formula has more than {} characters", longest));
  }
  if (text.find('=') != std::string::npos) {
    throw std::invalid_argument("a formula has no sign '='");
  }
  mu::Parser& formula = parser_->formula;
  try {
    formula.ClearConst();
    formula.DefineConst("pi", std::numbers::pi);
    formula.DefineVar("x", &parser_->x);
    formula.DefineVar("y", &parser_->y);
    formula.SetExpr(text);
    formula.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw std::invalid_argument(error.GetMsg());
  }
  if (formula.GetNumResults() != 1) {
    throw std::invalid_argument("the formula has several values; decimals have a point");
  }
}

std::string PlaneFormula::error_in(const std::string& text) {
  try {
    static_cast<void>(PlaneFormula(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

double PlaneFormula::operator()(double x, double y) const {
  parser_->x = x;
  parser_->y = y;
  try {
    return parser_->formula.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace idiophone::sound_maps
