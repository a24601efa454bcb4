#pragma once
// What `idiophone bench` knows of a body before it plans cuts.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/bench/cut_plan.hpp"
#include "idiophone/study/bench/learning.hpp"
#include "idiophone/study/bench/workpiece.hpp"
#include "idiophone/study/fitting/target.hpp"

namespace idiophone::app {

struct BenchPartial {
  int mode = 0;                                    ///< its number, from 1 on
  double computed = 0.0;                           ///< Hz, of the deck's body with the cuts
  std::optional<fitting::Line> line = {};          ///< measured; none without taps, or where it is doubted
  std::optional<bench::CarriedOver> carried = {};  ///< none of a line of the last tap
  double wanted = 0.0;                             ///< Hz; of ratios with the first partial's frequency

  /// Measured, or else computed, Hz.
  [[nodiscard]] double frequency() const { return line ? line->frequency : computed; }
};

struct BenchSession {
  std::vector<BenchPartial> partials;
  std::optional<bench::Learned> learned;  ///< where there is a tap
  std::vector<bench::Cut> cuts;           ///< that were made, as deep as they are
  bench::Workpiece::Solved body;          ///< with them
  std::string doubt;                      ///< which line may be that of another mode, as a sentence; empty: none
  std::string renewal;  ///< asks for a tap that renews a line which is carried over, as a sentence; empty: none
  std::optional<Vector3> decisive;  ///< where such a tap is, or one that ends the doubt, m
};

/// What is tuned, by which measurement.
struct BenchSubject {
  const std::vector<int>& numbers;        ///< of the modes, from 1 on
  const std::filesystem::path& measured;  ///< for messages
};

/// Solves the body with its cuts. Where there are taps, the piece has from then on the material that they tell.
/// @throws std::runtime_error where a mode was certainly not measured, and what bench::learn() throws
[[nodiscard]] BenchSession begin_session(bench::Workpiece& piece, const BenchSubject& subject, const bench::Past& past,
                                         const fitting::Target& target, const bench::Beliefs& beliefs);

/// How far the partials are from their targets, for the plan.
[[nodiscard]] bench::Partials distances_of(const std::vector<BenchPartial>& partials, bool are_ratios);

}  // namespace idiophone::app
