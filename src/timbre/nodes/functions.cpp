// Arithmetic and standard functions.

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

namespace {

constexpr auto any = Argument::Kind::signal;

template <std::size_t count>
struct Function {
  using Arguments = std::array<double, count>;
  double (*value)(const Arguments&);

  [[nodiscard]] double step(const Moment& /*moment*/, const Arguments& arguments) const { return value(arguments); }
};

/// @param names  one for each argument
template <std::size_t count>
NodeType function(const char* name, const std::array<const char*, count>& names, const char* description,
                  double (*value)(const std::array<double, count>&), EndsWith ends_with = EndsWith::none) {
  NodeType type{.name = name, .description = description, .is_timeless = true, .ends_with = ends_with};
  for (const char* argument : names) {
    type.arguments.push_back({argument, any});
  }
  type.make = [value](const Call& call) {
    return component_node(std::vector<Function<count>>(call.width, Function<count>{value}));
  };
  return type;
}

/// Joins any number of arguments, from the left to the right.
template <class Join>
class JoinNode : public Node {
 public:
  JoinNode(Join join, Join alone) : join_(join), alone_(alone) {}

  void render(const Block& block, std::span<const Input> inputs, std::span<double> output) override {
    const bool is_alone = inputs.size() == 1;
    for (std::size_t i = 0; i < block.count; ++i) {
      for (std::size_t c = 0; c < block.width; ++c) {
        double& joined = output[i * block.width + c];
        joined = inputs[0].at(i, c);
        for (std::size_t a = 1; a < inputs.size(); ++a) {
          joined = join_(joined, inputs[a].at(i, c));
        }
        joined = is_alone ? alone_(joined, joined) : joined;
      }
    }
  }

 private:
  Join join_, alone_;
};

using Join = double (*)(double, double);

double same(double a, double /*b*/) {
  return a;
}

/// @param alone  what becomes of a single argument, which it gets twice
NodeType joining(const char* name, EndsWith ends_with, const char* description, Join join, Join alone) {
  return {.name = name,
          .arguments = {{"x", any}},
          .description = description,
          .make = [join, alone](const Call& /*call*/) { return std::make_unique<JoinNode<Join>>(join, alone); },
          .repeats = true,
          .is_timeless = true,
          .ends_with = ends_with};
}

}  // namespace

std::vector<NodeType> functions() {
  using One = std::array<double, 1>;
  using Two = std::array<double, 2>;
  using Three = std::array<double, 3>;
  return {
      joining(
          "+", EndsWith::all, "sum", [](double a, double b) { return a + b; }, same),
      joining(
          "-", EndsWith::all, "first argument minus the others; the negative of a single one",
          [](double a, double b) { return a - b; }, [](double a, double /*b*/) { return -a; }),
      joining(
          "*", EndsWith::any, "product", [](double a, double b) { return a * b; }, same),
      joining(
          "/", EndsWith::first, "first argument over the others; the inverse of a single one",
          [](double a, double b) { return a / b; }, [](double a, double /*b*/) { return 1.0 / a; }),
      joining(
          "min", EndsWith::all, "the least", [](double a, double b) { return std::min(a, b); }, same),
      joining(
          "max", EndsWith::all, "the largest", [](double a, double b) { return std::max(a, b); }, same),
      function<2>("pow", {"x", "exponent"}, "x to the power of the exponent",
                  [](const Two& a) { return std::pow(a[0], a[1]); }),
      function<2>("mod", {"x", "y"}, "remainder of x/y, with the sign of y",
                  [](const Two& a) { return a[0] - a[1] * std::floor(a[0] / a[1]); }),
      function<1>(
          "abs", {"x"}, "magnitude", [](const One& a) { return std::abs(a[0]); }, EndsWith::all),
      function<1>("sign", {"x"}, "-1, 0 or 1",
                  [](const One& a) { return static_cast<double>(a[0] > 0.0) - static_cast<double>(a[0] < 0.0); }),
      function<1>("floor", {"x"}, "the next whole number that is not above x",
                  [](const One& a) { return std::floor(a[0]); }),
      function<1>("sqrt", {"x"}, "square root", [](const One& a) { return std::sqrt(a[0]); }),
      function<1>("exp", {"x"}, "exponential", [](const One& a) { return std::exp(a[0]); }),
      function<1>("log", {"x"}, "natural logarithm", [](const One& a) { return std::log(a[0]); }),
      function<1>(
          "sin", {"x"}, "sine of an angle in rad", [](const One& a) { return std::sin(a[0]); }, EndsWith::all),
      function<1>("cos", {"x"}, "cosine of an angle in rad", [](const One& a) { return std::cos(a[0]); }),
      function<1>(
          "tanh", {"x"}, "hyperbolic tangent, which limits softly to -1 to 1",
          [](const One& a) { return std::tanh(a[0]); }, EndsWith::all),
      function<1>("decibels", {"level"}, "the factor 10^(level/20)",
                  [](const One& a) { return std::pow(10.0, a[0] / 20.0); }),
      function<3>("clip", {"x", "lowest", "highest"}, "x within bounds",
                  [](const Three& a) { return std::min(std::max(a[0], a[1]), a[2]); }),
      function<2>("less", {"x", "y"}, "1 where x < y, otherwise 0",
                  [](const Two& a) { return a[0] < a[1] ? 1.0 : 0.0; }),
      function<3>("select", {"condition", "x", "y"}, "x where the condition is above 0, otherwise y",
                  [](const Three& a) { return a[0] > 0.0 ? a[1] : a[2]; }),
  };
}

}  // namespace idiophone::timbre
