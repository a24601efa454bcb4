#include "observer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace idiophone::app {

namespace {

constexpr std::size_t sum_words = std::tuple_size_v<ReproducibleSum::Words>;

/// Numbers within the body of what this rank owns of it.
store::Rows body_nodes(const Preparation& ready, std::size_t b, MPI_Comm communicator) {
  const auto& body = ready.part.bodies[b];
  std::vector<Index> numbers;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    numbers.push_back(ready.part.node_ids[static_cast<std::size_t>(node)] - ready.offsets.nodes[b]);
  }
  return {numbers, ready.offsets.nodes[b + 1] - ready.offsets.nodes[b], communicator};
}

store::Rows body_elements(const Preparation& ready, std::size_t b, MPI_Comm communicator) {
  const auto& body = ready.part.bodies[b];
  std::vector<Index> numbers;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    if (body.owned[e] != 0) {
      numbers.push_back(body.element_ids[e] - ready.offsets.elements[b]);
    }
  }
  return {numbers, ready.offsets.elements[b + 1] - ready.offsets.elements[b], communicator};
}

/// Node numbers within the body of its owned elements, [nodes per element x owned elements].
std::vector<Index> connectivity(const Preparation& ready, std::size_t b) {
  const auto& body = ready.part.bodies[b];
  const auto width = static_cast<std::size_t>(mesh::nodes_per_element(body.element));
  std::vector<Index> nodes;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    for (std::size_t a = 0; a < width && body.owned[e] != 0; ++a) {
      const auto local = static_cast<std::size_t>(body.elements[e * width + a]);
      nodes.push_back(ready.part.node_ids[local] - ready.offsets.nodes[b]);
    }
  }
  return nodes;
}

}  // namespace

double Observation::energy() const {
  double sum = gravitational;
  for (const BodyMotion& body : bodies) {
    sum += body.kinetic + body.elastic;
  }
  return sum;
}

Observer::Observer(const Preparation& ready, MPI_Comm communicator) : ready_(ready), communicator_(communicator) {
  const double wanted = ready.scene.output.motion_per_second;
  motion_stride_ = wanted > 0 ? std::max<std::int64_t>(1, std::llround(ready.scene.audio.rate / wanted)) : 0;
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    node_rows_.push_back(body_nodes(ready, b, communicator));
    element_rows_.push_back(body_elements(ready, b, communicator));
  }
}

void Observer::declare(store::ResultFile& result) const {
  if (motion_stride_ > 0) {
    const double rate = static_cast<double>(ready_.scene.audio.rate) / static_cast<double>(motion_stride_);
    result.declare({"/energy",
                    "J",
                    rate,
                    {"kinetic", "elastic", "gravitational", "work"},
                    "energies of all bodies, and the work done on them by pulses and driven groups",
                    {}});
    for (const auto& body : ready_.scene.bodies) {
      const std::string path = "/motion/" + body.name;
      result.declare({path + "/centre_of_mass", "m", rate, {"x", "y", "z"}, "position of the centre of mass", {}});
      result.declare({path + "/velocity", "m/s", rate, {"x", "y", "z"}, "velocity of the centre of mass", {}});
      result.declare({path + "/angular_momentum",
                      "kg m2/s",
                      rate,
                      {"x", "y", "z"},
                      "angular momentum about the centre of mass",
                      {}});
      result.declare({path + "/energy", "J", rate, {"kinetic", "elastic"}, "energies of the body", {}});
    }
  }
  if (ready_.scene.output.frames_per_second > 0) {
    for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
      const auto& body = ready_.part.bodies[b];
      std::vector<double> reference;
      for (Index node = body.owned_begin; node < body.owned_end; ++node) {
        const Vector3& x = ready_.part.reference[static_cast<std::size_t>(node)];
        reference.insert(reference.end(), x.begin(), x.end());
      }
      result.add_mesh(ready_.scene.bodies[b].name, node_rows_[b], reference, element_rows_[b], connectivity(ready_, b),
                      mesh::nodes_per_element(body.element));
    }
  }
}

void Observer::note(std::int64_t sample, motion::Motion& motion) {
  if (motion_stride_ > 0 && sample % motion_stride_ == 0) {
    const std::vector<std::int64_t> row = words(motion);
    notes_.insert(notes_.end(), row.begin(), row.end());
  }
  const double per_sample = ready_.scene.output.frames_per_second / ready_.scene.audio.rate;
  const bool due = sample == 0 || std::floor(static_cast<double>(sample) * per_sample) >
                                      std::floor(static_cast<double>(sample - 1) * per_sample);
  if (per_sample > 0 && due) {
    frames_.push_back(frame(static_cast<double>(sample) / ready_.scene.audio.rate, motion));
  }
}

Observer::Frame Observer::frame(double time, const motion::Motion& motion) const {
  Frame frame{time, {}};
  for (const auto& body : ready_.part.bodies) {
    auto& displacement = frame.displacement.emplace_back();
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      const auto& u = motion.state()[static_cast<std::size_t>(node)].displacement;
      displacement.insert(displacement.end(), u, u + 3);
    }
  }
  return frame;
}

void Observer::write(store::ResultFile& result) {
  int rank = 0;
  MPI_Comm_rank(communicator_, &rank);
  if (!notes_.empty()) {
    std::vector<std::int64_t> sums(notes_.size());
    MPI_Reduce(notes_.data(), sums.data(), static_cast<int>(notes_.size()), MPI_INT64_T, MPI_SUM, 0, communicator_);
    std::vector<double> energies;
    std::vector<std::array<std::vector<double>, 4>> bodies(ready_.scene.bodies.size());
    for (std::size_t row = 0; row < sums.size() && rank == 0; row += words_per_row()) {
      const Observation seen = observation(std::span(sums).subspan(row, words_per_row()));
      double kinetic = 0.0;
      double elastic = 0.0;
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        const BodyMotion& body = seen.bodies[b];
        for (std::size_t i = 0; const Vector3& vector : {body.centre, body.velocity, body.angular_momentum}) {
          bodies[b][i].insert(bodies[b][i].end(), vector.begin(), vector.end());
          ++i;
        }
        bodies[b][3].insert(bodies[b][3].end(), {body.kinetic, body.elastic});
        kinetic += body.kinetic;
        elastic += body.elastic;
      }
      energies.insert(energies.end(), {kinetic, elastic, seen.gravitational, seen.work});
    }
    result.append("/energy", energies);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const std::string path = "/motion/" + ready_.scene.bodies[b].name;
      for (std::size_t i = 0; const char* name : {"/centre_of_mass", "/velocity", "/angular_momentum", "/energy"}) {
        result.append(path + name, bodies[b][i++]);
      }
    }
    notes_.clear();
  }
  for (const Frame& frame : frames_) {
    std::vector<store::BodyFrame> bodies;
    for (std::size_t b = 0; b < node_rows_.size(); ++b) {
      bodies.push_back({ready_.scene.bodies[b].name, &node_rows_[b], frame.displacement[b]});
    }
    result.add_frame(frame.time, bodies);
  }
  frames_.clear();
}

Observation Observer::observe(motion::Motion& motion) const {
  const std::vector<std::int64_t> mine = words(motion);
  std::vector<std::int64_t> sums(mine.size());
  MPI_Reduce(mine.data(), sums.data(), static_cast<int>(mine.size()), MPI_INT64_T, MPI_SUM, 0, communicator_);
  return observation(sums);
}

std::size_t Observer::words_per_row() const {
  return sum_words * (motion::BodySums::count * ready_.scene.bodies.size() + 1);
}

std::vector<std::int64_t> Observer::words(motion::Motion& motion) const {
  std::vector<std::int64_t> row;
  const auto add = [&](const ReproducibleSum& sum) {
    const ReproducibleSum::Words words = sum.words();
    row.insert(row.end(), words.begin(), words.end());
  };
  for (const motion::BodySums& body : motion::measure(motion, ready_.part)) {
    std::ranges::for_each(body.all(), add);
  }
  add(motion.work());
  return row;
}

Observation Observer::observation(std::span<const std::int64_t> row) const {
  const auto number = [&](std::size_t sum) {
    ReproducibleSum::Words words;
    std::ranges::copy(row.subspan(sum * sum_words, sum_words), words.begin());
    return ReproducibleSum::from_words(words).value();
  };
  const auto vector = [&](std::size_t first) { return Vector3(number(first), number(first + 1), number(first + 2)); };
  Observation seen;
  for (std::size_t b = 0; b < ready_.scene.bodies.size(); ++b) {
    const std::size_t first = b * motion::BodySums::count;
    const double mass = ready_.outset.masses[b];
    const Vector3 moment = vector(first);
    const Vector3 momentum = vector(first + 3);
    const Vector3 centre = moment / mass;
    seen.bodies.push_back(
        {centre, momentum / mass, vector(first + 6) - centre.cross(momentum), number(first + 9), number(first + 10)});
    seen.gravitational -= moment.dot(ready_.scene.gravity);
  }
  seen.work = number(ready_.scene.bodies.size() * motion::BodySums::count);
  return seen;
}

}  // namespace idiophone::app
