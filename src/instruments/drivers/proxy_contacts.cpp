#include "idiophone/instruments/drivers/proxy_contacts.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::drivers {

namespace {

constexpr std::size_t longest_piece = 64;  // audio samples in which the point of contact stays

/// A channel of vectors.
struct VectorChannel {
  std::size_t width;
  double rate;  // rows per second
  std::vector<double> values;

  VectorChannel(const results::SeriesReader& reader, const std::string& name) {
    const spectra::Series& series = reader.find(name);
    reader.require_intact(series);
    width = series.columns.size();
    rate = series.rate;
    values = reader.read(series);
  }

  [[nodiscard]] std::size_t rows() const { return values.size() / width; }
  [[nodiscard]] Vector3 vector(std::size_t row) const { return Vector3::Map(&values[width * row]); }
};

/// Takes points and forces to where the body was before it moved.
class BodyFrame {
 public:
  BodyFrame(const results::SeriesReader& reader, const std::string& body, Vector3 centre)
      : positions_(reader, fmt::format("motion/{}/centre_of_mass", body)),
        orientations_(reader, fmt::format("motion/{}/orientation", body)),
        centre_(std::move(centre)) {
    if (positions_.rows() == 0 || orientations_.rows() == 0) {
      throw std::runtime_error(fmt::format("the result has no motion of body {}; set output.motion_per_second", body));
    }
  }

  [[nodiscard]] Vector3 point(const Vector3& now, double time) const {
    const auto [row, share] = place(time);
    const Vector3 position = (1.0 - share) * positions_.vector(row) + share * positions_.vector(row + 1);
    return centre_ + force(now - position, time);
  }

  [[nodiscard]] Vector3 force(const Vector3& now, double time) const {
    const auto [row, share] = place(time);
    return orientation(row).slerp(share, orientation(row + 1)).inverse() * now;
  }

 private:
  /// Between which rows a time is; past the end, the last row counts.
  [[nodiscard]] std::pair<std::size_t, double> place(double time) const {
    const double at = std::clamp(time * positions_.rate, 0.0, static_cast<double>(positions_.rows() - 1));
    const auto row = std::min(static_cast<std::size_t>(at), positions_.rows() > 1 ? positions_.rows() - 2 : 0);
    return {row, positions_.rows() > 1 ? at - static_cast<double>(row) : 0.0};
  }

  [[nodiscard]] Eigen::Quaterniond orientation(std::size_t row) const {
    const double* wxyz = &orientations_.values[4 * std::min(row, orientations_.rows() - 1)];
    return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized();
  }

  VectorChannel positions_, orientations_;
  Vector3 centre_;
};

/// The force and the point of one contact.
struct ContactRecord {
  VectorChannel force, point;

  [[nodiscard]] bool touches(std::size_t row) const { return force.vector(row) != Vector3::Zero(); }

  /// Mean point of some rows, weighted by the force.
  [[nodiscard]] Vector3 mean_point(std::size_t begin, std::size_t end) const {
    Vector3 sum = Vector3::Zero();
    double weights = 0.0;
    for (std::size_t row = begin; row < end; ++row) {
      const double weight = force.vector(row).norm();
      sum += weight * point.vector(row);
      weights += weight;
    }
    return sum / weights;
  }
};

/// One force along each axis, for rows in which the contact touches.
void add_piece(const ContactRecord& contact, std::size_t begin, std::size_t end, double sign, std::size_t body,
               const BodyFrame& frame, std::vector<proxies::Force>& forces) {
  const double middle = 0.5 * static_cast<double>(begin + end) / contact.force.rate;
  const Vector3 at = frame.point(contact.mean_point(begin, end), middle);
  for (int axis = 0; axis < 3; ++axis) {
    proxies::Force force{.body = body,
                         .start = static_cast<std::int64_t>(begin),
                         .at = at,
                         .direction = sign * Vector3::Unit(axis),
                         .curve = {}};
    for (std::size_t row = begin; row < end; ++row) {
      force.curve.push_back(frame.force(contact.force.vector(row), middle)[axis]);
    }
    forces.push_back(std::move(force));
  }
}

void add_contact(const ContactRecord& contact, double sign, std::size_t body, const BodyFrame& frame,
                 std::vector<proxies::Force>& forces) {
  for (std::size_t begin = 0; begin < contact.force.rows(); ++begin) {
    if (!contact.touches(begin)) {
      continue;
    }
    std::size_t end = begin + 1;
    while (end < contact.force.rows() && end - begin < longest_piece && contact.touches(end)) {
      ++end;
    }
    add_piece(contact, begin, end, sign, body, frame, forces);
    begin = end - 1;
  }
}

}  // namespace

std::vector<proxies::Force> contact_forces(const std::filesystem::path& result, const scene::Solids& solids,
                                           const std::vector<Vector3>& centres) {
  const results::SeriesReader reader(result);
  std::vector<proxies::Force> forces;
  for (const scene::Contact& contact : solids.contacts) {
    const std::string path = "contacts/" + contact.name;
    const ContactRecord record{.force = VectorChannel(reader, path + "/force"),
                               .point = VectorChannel(reader, path + "/point")};
    const auto add = [&](std::size_t body, double sign) {
      add_contact(record, sign, body, BodyFrame(reader, solids.bodies[body].name, centres[body]), forces);
    };
    add(contact.body, 1.0);
    if (contact.other) {
      add(*contact.other, -1.0);
    }
  }
  return forces;
}

}  // namespace idiophone::drivers
