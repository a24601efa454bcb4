#pragma once
// What is in a datagram of Open Sound Control: a message, or a bundle of messages and bundles.

#include <functional>
#include <span>
#include <string>

#include "idiophone/instruments/drivers/osc.hpp"

namespace idiophone::drivers {

/// Reads a packet, with liblo. The messages of a bundle are handled at once, whatever its time is.
/// @param handle  gets the messages in their order
/// @throws std::runtime_error for a packet that is damaged, has more than 100 messages, or arguments that are no
///         numbers or texts; messages before that are handled
void read_osc_packet(std::span<char> packet,
                     const std::function<void(const std::string& path, const OscArguments& arguments)>& handle);

}  // namespace idiophone::drivers
