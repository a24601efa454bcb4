#pragma once
// What `idiophone bench` answers: the partials, and the next cuts.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench_session.hpp"
#include "idiophone/study/bench/cut_plan.hpp"

namespace idiophone::app {

struct BenchAnswer {
  const std::string& body;  ///< its name
  const BenchSession& session;
  const bench::Side& side;
  const bench::Strips& strips;  ///< slopes of the partials
  const std::vector<bench::Tool>& tools;
  const bench::Past& past;  ///< cuts as they were asked for, and taps
  const bench::Plan& plan;
};

/// The partials, what the taps tell, what the first tool does along the body, and the next cuts.
void print(const BenchAnswer& answer);

/// The same facts for scripts.
[[nodiscard]] nlohmann::json to_json(const BenchAnswer& answer);

/// "in_tune", "cut", ...
[[nodiscard]] std::string word_of(bench::Verdict verdict);

/// What to do next, as a sentence.
[[nodiscard]] std::string advice(const BenchAnswer& answer);

}  // namespace idiophone::app
