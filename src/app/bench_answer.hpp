#pragma once
// What `idiophone bench` answers: the partials, and the next cuts.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/study/bench/cut_plan.hpp"
#include "idiophone/study/fitting/measurements.hpp"

namespace idiophone::app {

struct BenchPartial {
  int mode = 0;                            ///< its number, from 1 on
  double computed = 0.0;                   ///< Hz, of the deck's body
  std::optional<fitting::Line> line = {};  ///< measured
  double wanted = 0.0;                     ///< Hz; of ratios with the first partial's frequency

  /// Measured, or else computed, Hz.
  [[nodiscard]] double frequency() const { return line ? line->frequency : computed; }
};

struct BenchAnswer {
  const std::string& body;  ///< its name
  const std::vector<BenchPartial>& partials;
  const bench::Side& side;
  const bench::Strips& strips;  ///< slopes of the partials
  const std::vector<bench::Tool>& tools;
  const std::vector<bench::Cut>& made;  ///< earlier
  const bench::Plan& plan;
};

/// The partials, what the first tool does along the body, and the next cuts.
void print(const BenchAnswer& answer);

/// The same facts for scripts.
[[nodiscard]] nlohmann::json to_json(const BenchAnswer& answer);

/// What to do next, as a sentence.
[[nodiscard]] std::string advice(const BenchAnswer& answer);

}  // namespace idiophone::app
