#include "idiophone/study/bench/tap.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "idiophone/study/partials/compare.hpp"

namespace idiophone::bench {

std::vector<fitting::Line> without_faint_neighbours(const std::vector<fitting::Line>& lines) {
  constexpr double near = 200.0;   // cents
  constexpr double faint = -20.0;  // dB
  std::vector<fitting::Line> loud;
  std::ranges::copy_if(lines, std::back_inserter(loud), [&](const fitting::Line& line) {
    return std::ranges::none_of(lines, [&](const fitting::Line& other) {
      return line.level && other.level && std::abs(partials::cents(line.frequency, other.frequency)) < near &&
             *line.level - *other.level < faint;
    });
  });
  return loud;
}

}  // namespace idiophone::bench
