#include "formula_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "beam_modes.hpp"

namespace idiophone::sound_maps {

using std::numbers::pi;

namespace {

using Type = IdealBody::Type;

/// A mode by formula.
struct FormulaMode {
  double frequency = 0.0;                           ///< Hz
  int along = 1;                                    ///< half waves along x
  int across = 0;                                   ///< along y; 0 of strings and bars, which move as one across
  std::function<double(double x, double y)> shape;  ///< for unit modal mass, 1/sqrt(kg)
};

/// Hz. @param k  wave number, 1/m
double frequency_of(const IdealBody& body, double k) {
  return std::sqrt((body.tension * k * k + body.stiffness * std::pow(k, 4)) / body.density) / (2 * pi);
}

FormulaMode line_mode(const IdealBody& body, int n) {
  const double root = beam_root(body.ends, n);
  const double scale = 1 / std::sqrt(body.density * body.length);
  return {.frequency = frequency_of(body, root / body.length),
          .along = n,
          .across = 0,
          .shape = [ends = body.ends, root, scale, length = body.length](double x, double /*y*/) {
            return scale * beam_shape(ends, root, x / length);
          }};
}

FormulaMode plate_mode(const IdealBody& body, int m, int n) {
  const double kx = m * pi / body.length;
  const double ky = n * pi / body.width;
  const double scale = 2 / std::sqrt(body.density * body.length * body.width);
  return {
      .frequency = frequency_of(body, std::hypot(kx, ky)), .along = m, .across = n, .shape = [=](double x, double y) {
        return scale * std::sin(kx * x) * std::sin(ky * y);
      }};
}

/// All modes up to some number of half waves along the longer side.
std::vector<FormulaMode> modes_up_to(const IdealBody& body, int most) {
  std::vector<FormulaMode> modes;
  const double longer = std::max(body.length, body.width);
  for (int m = 1; m <= most; ++m) {
    if (body.type != Type::plate) {
      modes.push_back(line_mode(body, m));
      continue;
    }
    for (int n = 1; std::hypot(m / body.length, n / body.width) * longer <= most; ++n) {
      modes.push_back(plate_mode(body, m, n));
    }
  }
  std::ranges::stable_sort(modes, {}, &FormulaMode::frequency);
  return modes;
}

/// The lowest modes, ascending.
std::vector<FormulaMode> formula_modes(const IdealBody& body, const eigenmodes::WantedModes& wanted) {
  constexpr int most_half_waves = 4096;
  for (int most = 16; most <= most_half_waves; most *= 2) {
    std::vector<FormulaMode> modes = modes_up_to(body, most);
    const auto above = std::ranges::upper_bound(modes, wanted.up_to.value_or(0.0), {}, &FormulaMode::frequency);
    const std::ptrdiff_t count = wanted.up_to ? above - modes.begin() : wanted.count;
    if (count < std::ssize(modes)) {
      modes.resize(count);
      return modes;
    }
  }
  throw std::runtime_error(
      fmt::format("body '{}' has more modes than a map can hold: lower --up-to or --modes", body.name));
}

/// A rectangle in the plane z = 0 in cells of two triangles each.
/// @param low, high  its sides along y, m
void add_rectangle(SoundMap& map, double length, double low, double high, int columns, int rows) {
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      map.vertices.emplace_back(length * i / columns, low + (high - low) * j / rows, 0.0);
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index corner = j * (columns + 1) + i;
      map.triangles.push_back({corner, corner + 1, corner + columns + 2});
      map.triangles.push_back({corner, corner + columns + 2, corner + columns + 1});
    }
  }
}

}  // namespace

void add_formula_modes(SoundMap& map, const IdealBody& body, const eigenmodes::WantedModes& wanted) {
  constexpr int cells_of_half_wave = 4;
  const std::vector<FormulaMode> modes = formula_modes(body, wanted);
  int along = 4;
  int across = 0;
  for (const FormulaMode& mode : modes) {
    along = std::max(along, mode.along);
    across = std::max(across, mode.across);
  }
  const bool is_plate = body.type == Type::plate;
  add_rectangle(map, body.length, is_plate ? 0.0 : -0.5 * body.width, is_plate ? body.width : 0.5 * body.width,
                cells_of_half_wave * along, std::max(1, cells_of_half_wave * across));
  for (const FormulaMode& mode : modes) {
    map.frequency.push_back(mode.frequency);
    for (const Vector3& vertex : map.vertices) {
      map.shape.insert(map.shape.end(), {0.0F, 0.0F, static_cast<float>(mode.shape(vertex[0], vertex[1]))});
    }
  }
}

}  // namespace idiophone::sound_maps
