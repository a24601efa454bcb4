#include "vibrating_solid.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "idiophone/air/receivers/filter_bank.hpp"
#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/air/surface/equivalent_radius.hpp"

namespace idiophone::radiation {

namespace {

using std::numbers::pi;

/// Joins corners that lie at the same place.
class Joiner {
 public:
  void add(const Vector3& a, const Vector3& b, const Vector3& c) {
    solid_.triangles.push_back({number(a), number(b), number(c)});
  }
  [[nodiscard]] const Solid& solid() const { return solid_; }

 private:
  Index number(const Vector3& place) {
    const std::array<long, 3> key = {std::lround(1e9 * place[0]), std::lround(1e9 * place[1]),
                                     std::lround(1e9 * place[2])};
    const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<Index>(solid_.vertices.size()));
    if (is_new) {
      solid_.vertices.push_back(place);
    }
    return entry->second;
  }

  Solid solid_;
  std::map<std::array<long, 3>, Index> numbers_;
};

}  // namespace

std::vector<std::array<Vector3, 3>> Solid::corners() const {
  std::vector<std::array<Vector3, 3>> places;
  for (const auto& [a, b, c] : triangles) {
    places.push_back({vertices[a], vertices[b], vertices[c]});
  }
  return places;
}

std::vector<double> Solid::radii() const {
  std::vector<Index> all(triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return surface::equivalent_radii(corners(), all);
}

double Solid::area() const {
  double sum = 0.0;
  for (const auto& [a, b, c] : corners()) {
    sum += (b - a).cross(c - a).norm() / 2.0;
  }
  return sum;
}

Solid icosphere(double radius, int n) {
  const double golden = std::numbers::phi;
  std::vector<Vector3> corners;
  for (const double one : {-1.0, 1.0}) {
    for (const double other : {-golden, golden}) {
      corners.insert(corners.end(), {{0.0, one, other}, {one, other, 0.0}, {other, 0.0, one}});
    }
  }
  Joiner joiner;
  const auto add_face = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto point = [&](int i, int j) { return Vector3(radius * (a * (n - i - j) + b * i + c * j).normalized()); };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        joiner.add(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j < n - 1) {
          joiner.add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
        }
      }
    }
  };
  const auto neighbours = [](const Vector3& a, const Vector3& b) { return std::abs((a - b).norm() - 2.0) < 1e-9; };
  for (const Vector3& a : corners) {
    for (const Vector3& b : corners) {
      for (const Vector3& c : corners) {
        const bool is_first = std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end()) &&
                              std::lexicographical_compare(a.begin(), a.end(), c.begin(), c.end());
        if (is_first && neighbours(a, b) && neighbours(b, c) && neighbours(c, a) && a.dot(b.cross(c)) > 0) {
          add_face(a, b, c);
        }
      }
    }
  }
  Solid solid = joiner.solid();
  const double scale = radius * std::sqrt(4.0 * pi / solid.area());
  for (Vector3& vertex : solid.vertices) {
    vertex *= scale;
  }
  return solid;
}

Solid box(const Vector3& size, const std::array<int, 3>& cells) {
  Joiner joiner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const auto point = [&](int side, int i, int j) {
      Vector3 place;
      place[axis] = 0.5 * side * size[axis];
      place[u] = size[u] * (static_cast<double>(i) / cells.at(u) - 0.5);
      place[v] = size[v] * (static_cast<double>(j) / cells.at(v) - 0.5);
      return place;
    };
    for (int i = 0; i < cells.at(u); ++i) {
      for (int j = 0; j < cells.at(v); ++j) {
        joiner.add(point(1, i, j), point(1, i + 1, j), point(1, i + 1, j + 1));
        joiner.add(point(1, i, j), point(1, i + 1, j + 1), point(1, i, j + 1));
        joiner.add(point(-1, i, j), point(-1, i + 1, j + 1), point(-1, i + 1, j));
        joiner.add(point(-1, i, j), point(-1, i, j + 1), point(-1, i + 1, j + 1));
      }
    }
  }
  return joiner.solid();
}

Solid sphere(double radius, int n) {
  Joiner joiner;
  for (int octant = 0; octant < 8; ++octant) {
    const Vector3 sign((octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1, (octant & 4) != 0 ? -1 : 1);
    const auto point = [&](int i, int j) {
      return Vector3(radius * sign.cwiseProduct(Vector3(i, j, n - i - j)).normalized());
    };
    const auto add = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
      sign.prod() > 0 ? joiner.add(a, b, c) : joiner.add(a, c, b);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(point(i, j), point(i + 1, j), point(i, j + 1));
        if (i + j < n - 1) {
          add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
        }
      }
    }
  }
  return joiner.solid();
}

Solid disc(double radius, int n, double thickness) {
  Joiner joiner;
  const auto point = [&](int ring, int step, double z) {
    const double angle = ring == 0 ? 0.0 : 2.0 * pi * step / (6.0 * ring);
    return Vector3(radius * ring / n * std::cos(angle), radius * ring / n * std::sin(angle), z);
  };
  const double top = thickness / 2.0;
  const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
    joiner.add(point(a[0], a[1], top), point(b[0], b[1], top), point(c[0], c[1], top));
    if (thickness > 0.0) {
      joiner.add(point(a[0], a[1], -top), point(c[0], c[1], -top), point(b[0], b[1], -top));
    }
  };
  for (int ring = 1; ring <= n; ++ring) {
    for (int sector = 0; sector < 6; ++sector) {
      for (int i = 0; i < ring; ++i) {
        const int outer = sector * ring + i;
        const int inner = sector * (ring - 1) + i;
        add({ring, outer}, {ring, outer + 1}, {ring - 1, inner});
        if (i < ring - 1) {
          add({ring - 1, inner}, {ring, outer + 1}, {ring - 1, inner + 1});
        }
      }
    }
  }
  for (int step = 0; thickness > 0.0 && step < 6 * n; ++step) {
    joiner.add(point(n, step, -top), point(n, step + 1, -top), point(n, step + 1, top));
    joiner.add(point(n, step, -top), point(n, step + 1, top), point(n, step, top));
  }
  return joiner.solid();
}

std::vector<double> listen(const Solid& solid, const NormalVelocity& velocity, const Model& model,
                           std::optional<Field> field, const Vector3& receiver, int samples) {
  const double impedance = air_density * test_air.speed;
  surface::Emitter emitter(solid.triangles, 0.0,
                           field ? surface::SurfacePressure(*field, solid.radii(), test_air.speed / test_air.rate)
                                 : surface::SurfacePressure());
  surface::SurfaceMotion motion{std::vector<double>(padded(solid.triangles.size())),
                                std::vector<double>(surface::SurfaceMotion::position_length(solid.vertices.size()))};
  for (std::size_t vertex = 0; vertex < solid.vertices.size(); ++vertex) {
    Vector3::Map(&motion.position[3 * vertex]) = solid.vertices[vertex];
  }
  emitter.start(motion);
  const auto& spreading = receivers::Spreading::band_limited();
  const auto lookahead = static_cast<std::int64_t>(spreading.lookahead());
  receivers::AccumulationBuffer buffer(-lookahead, 1e5, spreading);
  surface::Emission emission;
  emitter.emit(motion, emission);
  Paths paths;
  find_paths(emission, {.position = receiver}, test_air, paths);
  Arrivals arrivals;
  for (std::int64_t sample = 0; sample < samples + lookahead; ++sample) {
    for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
      const Vector3 centre(emission.centre[0][i], emission.centre[1][i], emission.centre[2][i]);
      const Vector3 normal(emission.normal[0][i], emission.normal[1][i], emission.normal[2][i]);
      motion.pressure[i] = impedance * velocity(centre, normal, static_cast<double>(sample) / test_air.rate);
    }
    emitter.emit(motion, emission);
    model.radiate(emission, paths, arrivals);
    buffer.add(sample, arrivals);
  }
  return receivers::read_entries(receivers::values(buffer.take(static_cast<std::size_t>(samples + 2 * lookahead))),
                                 spreading);
}

std::complex<double> response(const Solid& solid, const std::function<double(const Vector3&, const Vector3&)>& shape,
                              const Model& model, std::optional<Field> field, const Vector3& receiver,
                              double frequency) {
  double extent = 0.0;
  for (const Vector3& vertex : solid.vertices) {
    extent = std::max(extent, vertex.norm());
  }
  // What the start stirs up has passed, and died away on the surface.
  const int begin = 40 + static_cast<int>((receiver.norm() + 15.0 * extent) * test_air.samples_per_metre());
  const int length = 100 + static_cast<int>(test_air.rate / frequency);
  const double pace = 2.0 * pi * frequency / test_air.rate;
  const std::vector<double> sound = listen(
      solid,
      [&](const Vector3& centre, const Vector3& normal, double time) {
        return shape(centre, normal) * std::sin(2.0 * pi * frequency * time);
      },
      model, field, receiver, begin + length);
  Eigen::MatrixX2d waves(length, 2);
  Eigen::VectorXd heard(length);
  for (int i = 0; i < length; ++i) {
    waves(i, 0) = std::sin(pace * (begin + i));
    waves(i, 1) = std::cos(pace * (begin + i));
    heard[i] = sound[sound.size() - static_cast<std::size_t>(length - i)];
  }
  const Eigen::Vector2d parts = waves.colPivHouseholderQr().solve(heard);
  return {parts[0], parts[1]};
}

double decibels(double one, double other) {
  return 20.0 * std::log10(std::abs(one / other));
}

}  // namespace idiophone::radiation
