#pragma once
// Drivers that read the motion of a run from its result: contact forces, and any channel as a force.

#include <filesystem>
#include <vector>

#include "idiophone/instruments/drivers/body_track.hpp"
#include "idiophone/instruments/drivers/driver.hpp"

namespace idiophone::drivers {

/// The forces of all contacts of a result on these bodies, in the coordinates of the undeformed bodies. Bodies that the
/// run does not have are left alone.
/// @return  in the order of the deck's contacts; Event::body is the number of the body
/// @throws std::runtime_error when the result can't be read, is damaged, lacks the channels, or has none of the bodies
///         in contact
[[nodiscard]] std::vector<Event> contact_events(const std::filesystem::path& result,
                                                const std::vector<StruckBody>& bodies, int rate);

/// Forces that follow a channel of a result: the force of the score times the channel's value, while that is above the
/// threshold. Between two rows, the value changes evenly.
/// @throws std::runtime_error when the result can't be read, is damaged, or lacks a channel or column
[[nodiscard]] std::vector<Event> motion_events(const std::filesystem::path& result,
                                               const std::vector<score::MotionForce>& forces, int rate);

}  // namespace idiophone::drivers
