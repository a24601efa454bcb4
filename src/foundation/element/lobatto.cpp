#include "idiophone/foundation/element/lobatto.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "legendre.hpp"

namespace idiophone::element {

namespace {

/// The zero of P' next to a first guess, by Newton's method: (1 - x^2) P'' = 2 x P' - order (order + 1) P.
double inner_node(int order, double guess) {
  double x = guess;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const auto [value, slope] = legendre(order, x);
    x -= slope * (1 - x * x) / (2 * x * slope - order * (order + 1) * value);
  }
  return x;
}

Lobatto make_rule(int order) {
  const Eigen::Index count = order + 1;
  Lobatto rule{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::MatrixXd::Zero(count, count)};
  for (Eigen::Index i = 0; 2 * i < count; ++i) {
    // Both halves have the same bits. Chebyshev's nodes are close enough to start from.
    const double x = i == 0           ? -1.0
                     : 2 * i == order ? 0.0
                                      : inner_node(order, -std::cos(std::numbers::pi * static_cast<double>(i) / order));
    const double value = legendre(order, x).value;
    rule.nodes[i] = x;
    rule.nodes[order - i] = -x;
    rule.weights[i] = rule.weights[order - i] = 2 / (order * (order + 1) * value * value);
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      if (i != j) {
        rule.derivative(i, j) = legendre(order, rule.nodes[i]).value /
                                (legendre(order, rule.nodes[j]).value * (rule.nodes[i] - rule.nodes[j]));
      }
    }
    // A constant has no derivative, to the last bit that a sum allows.
    rule.derivative(i, i) = -rule.derivative.row(i).sum();
  }
  return rule;
}

}  // namespace

const Lobatto& lobatto(int order) {
  static const std::array<Lobatto, highest_lobatto_order> rules = [] {
    std::array<Lobatto, highest_lobatto_order> all;
    for (int p = 1; p <= highest_lobatto_order; ++p) {
      all[p - 1] = make_rule(p);
    }
    return all;
  }();
  if (order < 1 || order > highest_lobatto_order) {
    throw std::invalid_argument(
        fmt::format("Gauss-Lobatto-Legendre nodes are for orders 1 to {}, not {}", highest_lobatto_order, order));
  }
  return rules[order - 1];
}

}  // namespace idiophone::element
