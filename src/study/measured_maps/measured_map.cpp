#include "idiophone/study/measured_maps/measured_map.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "blow_directions.hpp"
#include "force_transform.hpp"
#include "idiophone/foundation/dense/space_spline.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/study/partials/shared_partials.hpp"
#include "modal_amplitudes.hpp"
#include "recordings.hpp"

namespace idiophone::measured_maps {

namespace {

using Complex = std::complex<double>;
using sound_maps::SoundMap;
using std::numbers::pi;

constexpr std::size_t rings_of_directions = 16;

/// Adds the vertices and triangles of a mesh's surface, and the centre of what is inside.
void add_surface(SoundMap& map, const mesh::Mesh& mesh) {
  std::map<Index, Index> vertex_of;  // by node
  for (const mesh::Triangle& triangle : mesh.surface) {
    std::array<Index, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [entry, is_new] = vertex_of.try_emplace(triangle.at(c), static_cast<Index>(map.vertices.size()));
      if (is_new) {
        map.vertices.push_back(mesh.nodes[triangle.at(c)]);
      }
      corners.at(c) = entry->second;
    }
    map.triangles.push_back(corners);
  }
  double volume = 0.0;
  for (const auto& [i, j, k] : map.triangles) {  // with the origin, each makes a tetrahedron
    const Vector3 &a = map.vertices[i], &b = map.vertices[j], &c = map.vertices[k];
    const double part = a.dot(b.cross(c)) / 6.0;
    volume += part;
    map.centre += part * (a + b + c) / 4.0;
  }
  map.centre /= volume;
}

/// Adds the microphones, without pressures.
void add_microphones(SoundMap& map, const scene::Scene& scene) {
  for (const scene::Listener& listener : scene.listeners) {
    for (const scene::Receiver& receiver : listener.receivers) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector3& vertex : map.vertices) {
        nearest = std::min(nearest, (receiver.position - vertex).norm());
      }
      map.listeners.push_back(
          {.name = receiver.channel, .position = receiver.position, .delay = nearest / map.air_speed, .pressure = {}});
    }
  }
}

std::vector<double> delays_of(const SoundMap& map) {
  std::vector<double> delays;
  for (const sound_maps::MapListener& listener : map.listeners) {
    delays.push_back(listener.delay);
  }
  return delays;
}

std::vector<partials::SharedPartial> partials_of(const MeasuredBody& body, const Recordings& recordings,
                                                 const WantedPartials& wanted) {
  std::vector<std::vector<double>> all;
  for (const auto& of_blow : recordings.pressure) {
    all.insert(all.end(), of_blow.begin(), of_blow.end());
  }
  partials::PartialOptions options;
  options.highest = std::min(wanted.up_to, 0.5 * recordings.rate);
  std::vector<partials::SharedPartial> found;
  if (*options.highest > options.lowest) {
    found = partials::find_shared_partials(all, recordings.rate, options);
  }
  if (found.empty()) {
    throw deck::DeckError(body.where,
                          fmt::format("the recordings of body '{}' have no partials that decay from {:g} to {:g} Hz",
                                      body.name, options.lowest, *options.highest));
  }
  if (wanted.count && static_cast<std::size_t>(*wanted.count) < found.size()) {
    found.resize(static_cast<std::size_t>(*wanted.count));
  }
  return found;
}

/// What would be heard of a mode after an impulse of 1 N s, when its sound arrives. A force F gives the state
/// z = e^(s t) integral of F e^(-s t), and the mode's velocity (1 + i d/w) z (docs/method/sound_map.md).
Heard heard_of(const partials::SharedPartial& partial, const MeasuredBody& body, const Recordings& recordings,
               std::span<const double> delays) {
  const Complex exponent(-partial.decay, 2.0 * pi * partial.frequency);
  const Complex velocity(1.0, partial.decay / exponent.imag());
  Heard heard(body.blows.size());
  for (std::size_t blow = 0; blow < heard.size(); ++blow) {
    const Complex force = force_transform(body.blows[blow], exponent) * velocity;
    for (std::size_t m = 0; m < delays.size(); ++m) {
      const double time = recordings.start[blow] - delays[m];
      heard[blow].push_back(partial.amplitude[blow * delays.size() + m] * std::exp(-exponent * time) / force);
    }
  }
  return heard;
}

std::vector<Vector3> places_of(const MeasuredBody& body) {
  std::vector<Vector3> places;
  for (const RecordedBlow& blow : body.blows) {
    places.push_back(blow.at);
  }
  return places;
}

/// Adds a mode's shape with the unit modal mass, and its pressures. The mass is spread evenly over the surface.
void add_mode(SoundMap& map, const SeparatedMode& mode, const Eigen::MatrixXd& weights,
              const std::vector<Vector3>& directions, const std::vector<double>& areas) {
  const Eigen::VectorXd heights = weights * Eigen::Map<const Eigen::VectorXd>(
                                                mode.strength.data(), static_cast<Eigen::Index>(mode.strength.size()));
  double square = 0.0, area = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    square += areas[v] * std::pow(heights[static_cast<Eigen::Index>(v)], 2);
    area += areas[v];
  }
  const double root = std::sqrt(map.mass * square / area);  // of the modal mass of the heights
  for (std::size_t v = 0; v < areas.size(); ++v) {
    const Vector3 displacement = heights[static_cast<Eigen::Index>(v)] / root * directions[v];
    for (const double part : displacement) {
      map.shape.push_back(static_cast<float>(part));
    }
  }
  for (std::size_t m = 0; m < map.listeners.size(); ++m) {
    map.listeners[m].pressure.push_back(root * mode.pressure[m]);
  }
}

/// A body that sounds alike in all directions: the level is the mean of the microphones', times their distances, and
/// the phase is that of the first one.
void add_sphere(SoundMap& map) {
  map.sphere = sound_maps::sphere_of_directions(rings_of_directions);
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    double square = 0.0;
    for (const sound_maps::MapListener& listener : map.listeners) {
      const double level = std::abs(listener.pressure[mode]) * (listener.position - map.centre).norm();
      square += level * level / static_cast<double>(map.listeners.size());
    }
    const sound_maps::MapListener& first = map.listeners.front();
    const double later = (first.position - map.centre).norm() / map.air_speed - first.delay;
    const double phase = std::arg(first.pressure[mode]) + 2.0 * pi * map.frequency[mode] * later;
    map.sphere.pressure.insert(map.sphere.pressure.end(), map.sphere.direction.size(),
                               std::polar(std::sqrt(square) / map.sphere.distance, phase));
  }
}

SoundMap empty_map(const MeasuredDeck& deck, const MeasuredBody& body) {
  SoundMap map;
  map.name = deck.scene.name;
  map.body = body.name;
  map.kind = "measured";
  map.deck_text = deck.scene.deck_text;
  map.overrides = deck.scene.overrides;
  map.resolved_deck = deck.resolved;
  map.mass = body.mass;
  map.air_density = deck.scene.radiation.air.density;
  map.air_speed = deck.scene.radiation.air.speed;
  map.radiation = "measured";
  return map;
}

}  // namespace

SoundMap measured_map(const MeasuredDeck& deck, const MeasuredBody& body, const WantedPartials& wanted) {
  SoundMap map = empty_map(deck, body);
  const mesh::Mesh mesh = mesh::read_mesh(body.shape);
  for (const RecordedBlow& blow : body.blows) {
    (void)mesh::find_patch(mesh,
                           {.at = blow.at, .radius = 0.0, .where = blow.at_where});  // it refuses what is far away
  }
  add_surface(map, mesh);
  add_microphones(map, deck.scene);
  const std::vector<double> delays = delays_of(map);
  const Recordings recordings = read_recordings(body, delays);
  const std::vector<partials::SharedPartial> found = partials_of(body, recordings, wanted);

  std::vector<Heard> heard;
  std::vector<double> frequencies;  // of the decaying oscillations, Hz
  std::vector<bool> is_timed;
  for (const partials::SharedPartial& partial : found) {
    heard.push_back(heard_of(partial, body, recordings, delays));
    frequencies.push_back(partial.frequency);
    map.frequency.push_back(std::hypot(partial.frequency, partial.decay / (2.0 * pi)));
    map.material_decay.push_back(partial.decay);
    map.radiation_decay.push_back(0.0);
  }
  for (const RecordedBlow& blow : body.blows) {
    is_timed.push_back(blow.time.has_value());
  }
  align(heard, frequencies, is_timed);

  const BlowDirections directions(body.blows);
  const std::vector<Vector3> at_vertices = directions.at(map.vertices);
  const Eigen::MatrixXd weights = dense::spline_weights(places_of(body), map.vertices);
  const std::vector<double> areas = mesh::nodal_areas(map.triangles, map.vertices);
  for (const Heard& of_mode : heard) {
    SeparatedMode mode = separate(of_mode);
    directions.turn(mode.strength);
    add_mode(map, mode, weights, at_vertices, areas);
  }
  add_sphere(map);
  return map;
}

}  // namespace idiophone::measured_maps
