#pragma once
// Whether what an engine says can be. All functions throw std::runtime_error if not.

#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/instruments/engines/engine_stage.hpp"

namespace idiophone::engines {

inline constexpr std::size_t most_channels = 4;
inline constexpr double largest_number = 1e6;  ///< of an event or a place, in its unit
inline constexpr double most_ahead = 0.1;      ///< s, by which contacts may be ahead of the sound, beside the latency
inline constexpr double longest_step = 1.0;    ///< s, of the physics
inline constexpr double least_speed = 1e-3, most_speed = 1e3;  ///< of the machine

void require(bool good, const std::string& problem);
/// The same for the audio thread: a text takes memory only if it is needed.
void require(bool good, const char* problem);

/// @return the same
[[nodiscard]] StageOptions checked(StageOptions options);
[[nodiscard]] const std::vector<SharedMap>& checked(const std::vector<SharedMap>& bodies);
[[nodiscard]] std::vector<Surface> checked(std::vector<Surface> surfaces);
/// As vectors.
[[nodiscard]] std::vector<Vector3> checked(std::span<const Triple> ears);

/// @param number  for the message
void check_surface(const Surface& surface, std::size_t number);
void check_tuning(const Tuning& tuning);
/// @param bodies  of the stage
void check_pose(std::size_t body, const Pose& pose, std::size_t bodies);
/// @param bodies, surfaces  of the stage
void check_event(const ContactEvent& event, std::size_t bodies, std::size_t surfaces);

}  // namespace idiophone::engines
