#include "idiophone/air/radiation/floor.hpp"

namespace idiophone::radiation {

ReceiverState image(const ReceiverState& receiver, const ReflectingPlane& floor) {
  return {.position = floor.at + floor.mirrored(receiver.position - floor.at),
          .velocity = floor.mirrored(receiver.velocity),
          .axis = floor.mirrored(receiver.axis),
          .directivity = receiver.directivity,
          .gain = floor.reflection * receiver.gain};
}

}  // namespace idiophone::radiation
