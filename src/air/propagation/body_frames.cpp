#include "idiophone/air/propagation/body_frames.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>

#include "all_triangles.hpp"

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::propagation {

namespace {

constexpr int updates_per_second = 100;

Vector3 point(std::span<const float> rows, std::size_t vertex) {
  return {rows[3 * vertex], rows[3 * vertex + 1], rows[3 * vertex + 2]};
}

/// The angle times the axis of a rotation, rad.
Vector3 rotation_vector(const Eigen::Quaterniond& turn) {
  const Eigen::AngleAxisd part(turn.w() < 0 ? Eigen::Quaterniond(-turn.coeffs()) : turn);
  return part.angle() * part.axis();
}

Eigen::Quaterniond rotation(const Vector3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle)) : Eigen::Quaterniond::Identity();
}

/// A third of the area of the triangles around each vertex, m2.
std::vector<double> vertex_areas(const propagation::AudibleSurface& surface, std::span<const float> rest,
                                 MPI_Comm communicator) {
  std::vector<double> areas(rest.size() / 3);
  for (const auto& [i, j, k] : all_triangles(surface, communicator)) {
    const Vector3 a = point(rest, i);
    const double third = (point(rest, j) - a).cross(point(rest, k) - a).norm() / 6;
    for (const Index vertex : {i, j, k}) {
      areas[vertex] += third;
    }
  }
  return areas;
}

void require_bodies(const scene::Acoustics& acoustics, const std::vector<std::string>& names) {
  for (const scene::Listener& listener : acoustics.listeners) {
    if (listener.attached && std::ranges::find(names, *listener.attached) == names.end()) {
      throw deck::DeckError(listener.where, fmt::format("listeners.{}.attached: there is no body '{}', there are: {}",
                                                        listener.name, *listener.attached, fmt::join(names, ", ")));
    }
  }
}

}  // namespace

BodyFrames::BodyFrames(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                       MPI_Comm communicator)
    : rate_(acoustics.audio.rate),
      interval_(std::max(1, acoustics.audio.rate / updates_per_second)),
      shared_(surface.vertex_ids, communicator),
      names_(surface.bodies),
      rest_(shared_.share(surface.reference)),
      positions_(rest_),
      begin_(-interval_) {
  require_bodies(acoustics, names_);
  weight_ = vertex_areas(surface, rest_, communicator);
  for (std::size_t b = 0; b < names_.size(); ++b) {
    Body& body = bodies_.emplace_back(Body{.first = static_cast<std::size_t>(surface.first_vertex[b]),
                                           .end = static_cast<std::size_t>(surface.first_vertex[b + 1]),
                                           .reference = Vector3::Zero(),
                                           .before = {},
                                           .last = {},
                                           .from = {},
                                           .to = {}});
    body.reference = measured(body).centre;
    body.to.place.centre = body.reference;
    const auto computed = std::ranges::find(acoustics.bodies, names_[b], &scene::Body::name);
    if (computed != acoustics.bodies.end()) {
      body.to.velocity = computed->velocity;
      body.to.angular_velocity = computed->spin;
    }
    body.from = moved(body.to, -seconds());
    body.last = body.from.place;
    body.before = moved(body.to, -2 * seconds()).place;
  }
}

bool BodyFrames::needed(const scene::Acoustics& acoustics) {
  return std::ranges::any_of(acoustics.listeners,
                             [](const scene::Listener& listener) { return listener.attached.has_value(); });
}

BodyFrames::Frame BodyFrames::moved(const Frame& frame, double time) {
  Frame later = frame;
  later.place.centre += time * frame.velocity;
  later.place.turn = rotation(time * frame.angular_velocity) * frame.place.turn;
  return later;
}

BodyFrames::Place BodyFrames::measured(const Body& body) const {
  double area = 0.0;
  Vector3 centre = Vector3::Zero();
  for (std::size_t v = body.first; v < body.end; ++v) {
    area += weight_[v];
    centre += weight_[v] * (point(positions_, v) - point(rest_, v));
  }
  Vector3 rest = Vector3::Zero();
  for (std::size_t v = body.first; v < body.end; ++v) {
    rest += weight_[v] * point(rest_, v);
  }
  rest /= area;
  centre = rest + centre / area;
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  for (std::size_t v = body.first; v < body.end; ++v) {
    moment += weight_[v] * (point(positions_, v) - centre) * (point(rest_, v) - rest).transpose();
  }
  return {centre, Eigen::Quaterniond(Eigen::Affine3d(moment).rotation()).normalized()};
}

void BodyFrames::update(std::int64_t sample, const surface::SurfaceMotion& motion) {
  finish();
  for (Body& body : bodies_) {
    body.from = body.to;
    const double twice = 2 * seconds();
    const Frame steady{.place = body.last,
                       .velocity = (body.last.centre - body.before.centre) / seconds(),
                       .angular_velocity = rotation_vector(body.last.turn * body.before.turn.conjugate()) / seconds()};
    body.to = moved(steady, twice);
  }
  begin_ = sample;
  shared_.begin(motion.position);
  updating_ = true;
}

void BodyFrames::finish() {
  if (!updating_) {
    return;
  }
  updating_ = false;
  shared_.finish(positions_);
  for (Body& body : bodies_) {
    body.before = body.last;
    body.last = measured(body);
  }
}

/// Cubic (Hermite) in the centre and in the rotation vector from the interval's start.
BodyFrames::Frame BodyFrames::between(const Body& body, double interval, double time) {
  const auto& [from, to] = std::tie(body.from, body.to);
  const double s = time / interval;
  const auto cubic = [&](const Vector3& a, const Vector3& va, const Vector3& b, const Vector3& vb) {
    const Vector3 value = (1 + s * s * (2 * s - 3)) * a + s * (1 - s) * (1 - s) * interval * va +
                          s * s * (3 - 2 * s) * b - s * s * (1 - s) * interval * vb;
    const Vector3 slope = 6 * s * (s - 1) / interval * (a - b) + (1 + s * (3 * s - 4)) * va + s * (3 * s - 2) * vb;
    return std::pair(value, slope);
  };
  Frame now;
  std::tie(now.place.centre, now.velocity) = cubic(from.place.centre, from.velocity, to.place.centre, to.velocity);
  const Vector3 whole = rotation_vector(to.place.turn * from.place.turn.conjugate());
  const auto [turned, rate] = cubic(Vector3::Zero(), from.angular_velocity, whole, to.angular_velocity);
  now.place.turn = rotation(turned) * from.place.turn;
  now.angular_velocity = rate;
  return now;
}

BodyFrames::Carrier BodyFrames::at(const std::string& body, std::int64_t sample) const {
  const auto number = std::ranges::find(names_, body) - names_.begin();
  const Body& carrier = bodies_[number];
  const Frame now = between(carrier, seconds(), static_cast<double>(sample - begin_) / rate_);
  return {carrier.reference, now.place.centre, now.velocity, now.place.turn.toRotationMatrix(), now.angular_velocity};
}

void BodyFrames::archive(parallel::Archive& archive) {
  finish();
  archive.root("hearing/frames/begin", begin_);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
    std::vector<double> numbers;
    const auto visit = [&](auto each) {
      for (Place* place : {&body.before, &body.last, &body.from.place, &body.to.place}) {
        each(place->centre);
        each(place->turn.coeffs());
      }
      for (Frame* frame : {&body.from, &body.to}) {
        each(frame->velocity);
        each(frame->angular_velocity);
      }
    };
    visit([&](auto& values) { numbers.insert(numbers.end(), values.data(), values.data() + values.size()); });
    archive.root("hearing/frames/" + names_[b], numbers);
    auto next = numbers.begin();
    visit([&](auto& values) {
      std::copy_n(next, values.size(), values.data());
      next += values.size();
    });
  }
}

}  // namespace idiophone::propagation
