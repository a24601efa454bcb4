#include "meshed_modes.hpp"

#include <fmt/format.h>

#include "idiophone/foundation/dense/space_spline.hpp"
#include "plane_formula.hpp"

namespace idiophone::sound_maps {

namespace {

// Values of a formula beyond these, in SI units, are mistakes; the matrices would lose all digits.
constexpr double least_value = 1e-6;
constexpr double most_value = 1e9;

/// The smooth surface through values at points.
eigenmodes::PlaneField through_points(const std::vector<Vector3>& points) {
  std::vector<Vector3> places;
  std::vector<double> values;
  for (const Vector3& point : points) {
    places.emplace_back(point[0], point[1], 0.0);
    values.push_back(point[2]);
  }
  return [spline = dense::SpaceSpline(places, values)](double x, double y) { return spline({x, y, 0.0}); };
}

/// A number, or a formula or points where there are some. @param key  of the deck, for messages
eigenmodes::PlaneField field_of(const IdealBody& body, const std::string& key, double number,
                                const std::string& formula, const std::vector<Vector3>& points) {
  if (formula.empty() && points.empty()) {
    return [number](double /*x*/, double /*y*/) { return number; };
  }
  const eigenmodes::PlaneField varying = points.empty() ? PlaneFormula(formula) : through_points(points);
  return [value = varying, what = points.empty() ? "formula gives" : "surface through the points has",
          where = body.where, path = "ideal_bodies." + body.name + "." + key](double x, double y) {
    const double found = value(x, y);
    if (!(found >= least_value && found <= most_value)) {
      throw deck::DeckError(where, fmt::format("{}: the {} {:.6g} at [{:.6g}, {:.6g}]; it must be from {:g} to "
                                               "{:g} in the whole outline",
                                               path, what, found, x, y, least_value, most_value));
    }
    return found;
  };
}

std::vector<eigenmodes::PlaneMode> modes_of(const IdealBody& body, const mesh::PlaneMesh& mesh,
                                            const eigenmodes::WantedModes& wanted) {
  if (body.type == IdealBody::Type::membrane) {
    const eigenmodes::Membrane membrane{
        field_of(body, "tension", body.tension, body.tension_formula, body.tension_points), density_of(body)};
    return eigenmodes::membrane_modes(mesh, membrane, wanted);
  }
  const eigenmodes::Plate plate{.stiffness = body.stiffness,
                                .poisson = body.poisson,
                                .tension = body.tension,
                                .density = body.density,
                                .edges = body.edges};
  return eigenmodes::plate_modes(body.region, mesh, plate, wanted);
}

/// Slopes of plates are finite at corners, and their matrices lose more digits to small elements than those of
/// membranes.
mesh::PlaneMesh mesh_of(const IdealBody& body) {
  constexpr int plate_levels = 5;
  return body.type == IdealBody::Type::plate ? mesh::mesh_region(body.region, body.size, plate_levels)
                                             : mesh::mesh_region(body.region, body.size);
}

}  // namespace

eigenmodes::PlaneField density_of(const IdealBody& body) {
  return field_of(body, "density", body.density, body.density_formula, body.density_points);
}

void add_meshed_modes(SoundMap& map, const IdealBody& body, const eigenmodes::WantedModes& wanted) {
  const mesh::PlaneMesh mesh = mesh_of(body);
  for (const auto& [x, y] : mesh.nodes) {
    map.vertices.emplace_back(x, y, 0.0);
  }
  for (const auto& [a, b, c, ab, bc, ca] : mesh.elements) {  // four flat triangles for each
    for (const std::array<Index, 3>& corners : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      map.triangles.push_back(corners);
    }
  }
  for (const auto& mode : modes_of(body, mesh, wanted)) {
    map.frequency.push_back(mode.frequency);
    for (const double value : mode.shape) {
      map.shape.insert(map.shape.end(), {0.0F, 0.0F, static_cast<float>(value)});
    }
  }
}

}  // namespace idiophone::sound_maps
