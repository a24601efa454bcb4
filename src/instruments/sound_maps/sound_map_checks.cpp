#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sound_map_paths.hpp"

namespace idiophone::sound_maps {

namespace {

class MapChecker {
 public:
  MapChecker(const SoundMap& map, const std::filesystem::path& path) : map_(map), path_(path) {}

  void check() const {
    check_facts();
    check_modes();
    check_scaling();
    check_stretching();
    check_surface();
    check_listeners();
    check_sphere();
  }

 private:
  void require(bool good, const std::string& problem) const {
    if (!good) {
      throw std::runtime_error(fmt::format("{} is no right sound map: {}", path_.string(), problem));
    }
  }

  void require_positive(double value, const std::string& what) const {
    require(value > 0 && std::isfinite(value), fmt::format("{} has to be above 0, not {}", what, value));
  }

  template <class Values>
  void require_finite(const Values& values, std::size_t size, const std::string& what) const {
    require(values.size() == size, fmt::format("{} has {} values, not {}", what, values.size(), size));
    const auto finite = [](auto value) { return std::isfinite(std::abs(value)); };
    require(std::ranges::all_of(values, finite), fmt::format("{} has a value that is not finite", what));
  }

  void check_facts() const {
    require_positive(map_.mass, "mass");
    require_positive(map_.air_density, "air_density");
    require_positive(map_.air_speed, "air_speed");
    require(map_.centre.allFinite(), "centre is not finite");
    if (map_.material) {
      require_positive(map_.material->density, "density");
      require_positive(map_.material->young, "young");
    }
  }

  void check_modes() const {
    require(map_.modes() > 0, "it has no modes");
    for (const double frequency : map_.frequency) {
      require_positive(frequency, sound_map::frequency);
    }
    require(std::ranges::is_sorted(map_.frequency), "its frequencies do not ascend");
    for (const auto& [values, name] : {std::pair(&map_.material_decay, sound_map::material_decay),
                                       std::pair(&map_.radiation_decay, sound_map::radiation_decay)}) {
      require_finite(*values, map_.modes(), name);
      require(std::ranges::min(*values) >= 0, fmt::format("{} has a value below 0", name));
    }
    require(map_.mesh_error.empty() || map_.mesh_error.size() == map_.modes(),
            fmt::format("{} has {} values, not {}", sound_map::mesh_error, map_.mesh_error.size(), map_.modes()));
    const auto infinite = [](double error) { return std::isinf(error); };
    require(std::ranges::none_of(map_.mesh_error, infinite),
            fmt::format("{} has an infinite value", sound_map::mesh_error));
    require_finite(map_.shape, 3 * map_.modes() * map_.vertices.size(), sound_map::shape);
  }

  void check_scaling() const {
    if (!map_.scalable) {
      return;
    }
    const auto& [mesh, shape, held, stiffness, lossless] = *map_.scalable;
    require(!shape || (shape->middle.allFinite() && shape->pattern.allFinite() && std::isfinite(shape->size) &&
                       shape->size > 0),
            fmt::format("{} is zero or not finite", sound_map::mesh_shape));
    require(map_.material.has_value(), "it can be rescaled, but has no material");
    require(stiffness.allFinite() && stiffness.norm() > 0,
            fmt::format("{} is zero or not finite", sound_map::stiffness));
    require_finite(lossless, map_.modes(), sound_map::lossless_frequency);
    require(lossless.front() > 0 && std::ranges::is_sorted(lossless),
            fmt::format("{} does not ascend from above 0", sound_map::lossless_frequency));
  }

  void check_stretching() const {
    const modal_bodies::Stretching& stretching = map_.stretching;
    const std::size_t modes = map_.modes(), terms = stretching.linear.size() / modes;
    if (stretching.linear.empty() && stretching.quadratic.empty() && stretching.rotation.empty()) {
      return;
    }
    require(terms > 0, "its stretching has no terms");
    require_finite(stretching.linear, terms * modes, sound_map::stretching_linear);
    require_finite(stretching.quadratic, terms * modes * modes, sound_map::stretching_quadratic);
    require_finite(stretching.rotation, modes * modes, sound_map::stretching_rotation);
    require_symmetric(stretching.quadratic, sound_map::stretching_quadratic);
    require_symmetric(stretching.rotation, sound_map::stretching_rotation);
  }

  /// But for rounding.
  /// @param matrices  [any number x modes x modes]
  void require_symmetric(const std::vector<double>& matrices, const std::string& what) const {
    const std::size_t modes = map_.modes();
    const double rounding =
        1e-9 * std::abs(*std::ranges::max_element(matrices, {}, [](double x) { return std::abs(x); }));
    bool symmetric = true;
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      const std::size_t row = i / modes % modes, column = i % modes;
      const double mirrored = matrices[i - row * modes - column + column * modes + row];
      symmetric &= std::abs(matrices[i] - mirrored) <= rounding;
    }
    require(symmetric, fmt::format("{} is not symmetric", what));
  }

  void check_surface() const {
    require(!map_.triangles.empty(), "it has no triangles");
    const auto finite = [](const Vector3& vertex) { return vertex.allFinite(); };
    require(std::ranges::all_of(map_.vertices, finite), "a vertex is not finite");
    const auto vertices = static_cast<Index>(map_.vertices.size());
    for (const auto& triangle : map_.triangles) {
      for (const Index vertex : triangle) {
        require(vertex >= 0 && vertex < vertices,
                fmt::format("a triangle has vertex {}; there are {}", vertex, vertices));
      }
    }
  }

  void check_listeners() const {
    for (const MapListener& listener : map_.listeners) {
      require_finite(listener.pressure, map_.modes(), "the pressure at listener " + listener.name);
      require(listener.position.allFinite() && listener.delay >= 0 && std::isfinite(listener.delay),
              fmt::format("listener {} has no right position or delay", listener.name));
    }
  }

  void check_sphere() const {
    const MapSphere& sphere = map_.sphere;
    require_positive(sphere.distance, "distance");
    const std::size_t directions = sphere.direction.size();
    require(directions > 0 && sphere.rings > 0 && directions % sphere.rings == 0 &&
                directions / sphere.rings == sphere.azimuths,
            fmt::format("{} directions are not {} rings of {}", directions, sphere.rings, sphere.azimuths));
    require_finite(sphere.weight, directions, sound_map::weights);
    require_finite(sphere.pressure, map_.modes() * directions, sound_map::sphere_pressure);
    const auto is_unit = [](const Vector3& direction) { return std::abs(direction.norm() - 1) < 1e-6; };
    require(std::ranges::all_of(sphere.direction, is_unit), "a direction does not have the length 1");
  }

  const SoundMap& map_;
  const std::filesystem::path& path_;
};

}  // namespace

void check_sound_map(const SoundMap& map, const std::filesystem::path& path) {
  MapChecker(map, path).check();
}

}  // namespace idiophone::sound_maps
