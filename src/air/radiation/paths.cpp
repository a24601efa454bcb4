#include "idiophone/air/radiation/paths.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::radiation {

namespace {

using WideVectors = std::array<WideLanes, 3>;

WideLanes dot(const WideVectors& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

WideLanes square_root(const WideLanes& values) {
  WideLanes roots;
  for (std::size_t lane = 0; lane < wide_count; ++lane) {
    roots[lane] = std::sqrt(values[lane]);
  }
  return roots;
}

}  // namespace

void Medium::validate() const {
  if (!(speed > 0.0) || !std::isfinite(speed) || rate < 1) {
    throw std::invalid_argument(fmt::format(
        "air: the speed of sound is {} m/s and the audio rate {} per second; both must be positive", speed, rate));
  }
}

void find_paths(const surface::Emission& emission, const ReceiverState& receiver, const Medium& air, Paths& paths) {
  const std::size_t count = emission.pressure.size();
  if (count % pack_size != 0) {
    throw std::invalid_argument(fmt::format("paths: an emission of {} triangles is not padded", count));
  }
  for (auto* values : {&paths.distance, &paths.cosine, &paths.delay, &paths.gain}) {
    values->resize(count);
  }
  // c^2 t^2 = |d + v t|^2 with d = x - y; as R = c t: (1 - m^2) R^2 - 2 (d.m) R - d^2 = 0, m = v/c.
  const Vector3 mach = receiver.velocity / air.speed;
  const double slowness = 1.0 - mach.squaredNorm();
  const double stretch = 1.0 / slowness;
  const WideLanes smallest = WideLanes{} + smallest_distance;
  for (std::size_t first = 0; first < count; first += wide_count) {
    WideVectors towards;
    WideLanes square{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      towards[axis] = receiver.position[axis] - load<WideLanes>(&emission.centre[axis][first]);
      square += towards[axis] * towards[axis];
    }
    const WideLanes approach = dot(towards, mach);
    WideLanes distance = (approach + square_root(approach * approach + slowness * square)) * stretch;
    distance = distance < smallest ? smallest : distance;  // NaN fails the comparison and is kept, not clipped
    WideLanes facing{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      towards[axis] += mach[axis] * distance;
      facing += towards[axis] * load<WideLanes>(&emission.normal[axis][first]);
    }
    put(distance, &paths.distance[first]);
    put(facing / distance, &paths.cosine[first]);
    put(distance * air.samples_per_metre(), &paths.delay[first]);
    WideLanes gain = WideLanes{} + receiver.gain;
    if (receiver.directivity != 0.0) {  // where all directions are alike, there is no division
      gain *= 1.0 - receiver.directivity - receiver.directivity * (dot(towards, receiver.axis) / distance);
    }
    put(gain, &paths.gain[first]);
  }
}

}  // namespace idiophone::radiation
