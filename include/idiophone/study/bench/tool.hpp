#pragma once
// Tools that remove material from a body.

#include <string>
#include <vector>

namespace idiophone::bench {

/// The profile of a cut along the body.
enum class Profile {
  groove,  ///< as deep everywhere: a router that is led across the body
  hollow   ///< cos^2, deepest in the middle: a sander
};

/// A tool whose cuts reach across the whole side of a body.
struct Tool {
  std::string name;  ///< as the user writes it: "router", "sander"
  Profile profile = Profile::groove;
  double radius = 0.0;       ///< half the width of a cut, m
  double slope_error = 0.0;  ///< least standard deviation of what its cuts do, over what the model says
};

/// Reads NAME:RADIUS of each text: "router:0.006", "sander:0.02".
/// @throws std::runtime_error for another text, or none
[[nodiscard]] std::vector<Tool> read_tools(const std::vector<std::string>& texts);

/// Radii of tools for a body, m.
struct Radii {
  double least;  ///< of cuts that are four strips wide, the narrowest that a plan resolves
  double most;   ///< of a cut as long as the body
};

/// @param length  m, of the body along the side that is cut
[[nodiscard]] Radii suitable_radii(double length);

/// @throws std::runtime_error for a tool whose radius does not suit a body of this length (m)
void require_suitable_radii(const std::vector<Tool>& tools, double length);

/// The slope error of a tool whose cuts are narrower than the body is thick; 0 of others. Nodes that move do not
/// relieve the material beside a cut, and what is added for it is not exact for deep narrow cuts (docs/use/bench.md,
/// Limits).
/// @param thinnest  m, of the body
[[nodiscard]] double doubt_of(const Tool& tool, double thinnest);

/// Gives such tools their slope errors.
/// @param thinnest  m, of the body
/// @return those tools
std::vector<Tool> doubt_narrow_tools(std::vector<Tool>& tools, double thinnest);

/// Depth at a distance (m) from the middle of a cut, over the greatest depth: 0 to 1.
[[nodiscard]] double depth_share(const Tool& tool, double distance);

/// Mean of depth_share() between two places.
/// @param from, to  m from the middle of the cut along the body, ascending
[[nodiscard]] double mean_depth_share(const Tool& tool, double from, double to);

}  // namespace idiophone::bench
