#include "ideal_bodies.hpp"

#include <algorithm>
#include <filesystem>

#include "idiophone/foundation/deck/csv.hpp"
#include "idiophone/scene/ranges.hpp"
#include "outline_sections.hpp"
#include "plane_formula.hpp"

namespace idiophone::sound_maps {

using namespace deck;  // values, keys and sections

namespace {

using Type = IdealBody::Type;

/// Whether the type has a key.
bool type_has(Type type, std::string_view key) {
  using Keys = std::vector<std::string_view>;
  switch (type) {
    case Type::membrane:
      return std::ranges::count(Keys{"polygon", "radius", "holes", "size", "tension"}, key) > 0;
    case Type::string:
      return std::ranges::count(Keys{"length", "width", "tension"}, key) > 0;
    case Type::bar:
      return std::ranges::count(Keys{"length", "width", "ends", "tension", "stiffness"}, key) > 0;
    case Type::plate:
      return std::ranges::count(Keys{"polygon", "radius", "holes", "size", "length", "width", "edges", "poisson",
                                     "tension", "stiffness"},
                                key) > 0;
  }
  return false;
}

/// Refuses the keys that belong to other types.
void refuse_others(Section& section, Type type) {
  for (const char* key :
       {"polygon", "radius", "holes", "size", "length", "width", "ends", "edges", "poisson", "tension", "stiffness"}) {
    if (!type_has(type, key)) {
      section.refuse(key, "has no meaning for this type of ideal body");
    }
  }
}

/// Whether a point has a value in the range.
bool check_value(const Vector3& point, const Location& where, Mistakes& mistakes, const Range& range) {
  if (!range.contains(point[2])) {
    mistakes.add(where, fmt::format("expected [x, y, value] with a value above {} and at most {} {}", range.above,
                                    range.at_most, range.unit));
  }
  return range.contains(point[2]);
}

/// Rows of x, y and a value in the range.
void read_points(const Node& list, Mistakes& mistakes, std::vector<Vector3>& points, const Range& range) {
  for (const Node& row : list.children) {
    Vector3 point = Vector3::Zero();
    if (read(row, mistakes, point, Range{})) {
      check_value(point, row.where, mistakes, range);
    }
    points.push_back(point);
  }
}

/// The same in a CSV file.
void read_points(const Node& name, Mistakes& mistakes, std::vector<Vector3>& points, const Range& range,
                 const Folder& folder) {
  std::filesystem::path file;
  std::vector<CsvRow> rows;
  if (!read(name, mistakes, file, folder) || !read_csv(file, {{"x", "m"}, {"y", "m"}, {"value"}}, mistakes, rows)) {
    return;
  }
  for (const auto& [where, row] : rows) {
    if (!check_value(Vector3(row.data()), where, mistakes, range)) {
      return;
    }
    points.emplace_back(row.data());
  }
}

/// The surface through points costs the cube of their number.
void check_count(const Node& node, Mistakes& mistakes, std::size_t points) {
  constexpr std::size_t most_points = 1000;
  if (points == 0) {
    mistakes.add(node, "is empty; it needs at least one point [x, y, value]");
  } else if (points > most_points) {
    mistakes.add(node, fmt::format("has {} points; at most {} are possible, so leave some out", points, most_points));
  }
}

bool is_file(const Node& node) {
  return node.kind == Node::Kind::scalar && std::filesystem::path(node.text).extension() == ".csv";
}

/// A number in the range, a formula of x and y, or values at points: a list, or a CSV file.
void read_varying(Section& section, const std::string& key, double& value, std::string& formula,
                  std::vector<Vector3>& points, const Range& range, const Folder& folder) {
  const Node* node = section.find(key);
  if (node != nullptr && (node->kind == Node::Kind::list || is_file(*node))) {
    const std::size_t mistakes = section.mistakes().count();
    is_file(*node) ? read_points(*node, section.mistakes(), points, range, folder)
                   : read_points(*node, section.mistakes(), points, range);
    if (section.mistakes().count() == mistakes) {
      check_count(*node, section.mistakes(), points.size());
    }
    return;
  }
  Mistakes none;
  double number = 0.0;
  if (node == nullptr || node->kind != Node::Kind::scalar || read(*node, none, number, Range{})) {
    section.required(key, value, range);
  } else if (const std::string error = PlaneFormula::error_in(node->text); !error.empty()) {
    section.mistakes().add(*node,
                           fmt::format("expected a number or a formula of x and y, such as 0.2*(1 + x^2): {}", error));
  } else {
    formula = node->text;
  }
}

constexpr Range tension_range{.above = 0.0, .at_most = 1e9, .unit = "N or N/m"};
constexpr Range density_range{.above = 0.0, .at_most = 1e6, .unit = "kg/m or kg/m2"};

void read_membrane(Section& section, IdealBody& body, const Folder& folder) {
  read_outline(section, body);
  read_varying(section, "tension", body.tension, body.tension_formula, body.tension_points, tension_range, folder);
  read_varying(section, "density", body.density, body.density_formula, body.density_points, density_range, folder);
}

void read_string(Section& section, IdealBody& body) {
  read_sides(section, body);
  section.required("tension", body.tension, tension_range);
  section.required("density", body.density, density_range);
}

/// What bars and plates have in common.
void read_stiff(Section& section, IdealBody& body) {
  section.optional("tension", body.tension, Range{.at_least = 0.0, .at_most = 1e9, .unit = "N or N/m"});
  section.required("stiffness", body.stiffness, Range{.above = 0.0, .at_most = 1e12, .unit = "N m2 or N m"});
  section.required("density", body.density, density_range);
}

void read_bar(Section& section, IdealBody& body) {
  const Choices<IdealBody::Ends> ends{{{"supported", IdealBody::Ends::supported},
                                       {"free", IdealBody::Ends::free},
                                       {"clamped", IdealBody::Ends::clamped},
                                       {"clamped_free", IdealBody::Ends::clamped_free}}};
  read_sides(section, body);
  read_stiff(section, body);
  section.optional("ends", body.ends, ends);
  if (body.tension > 0.0 && body.ends != IdealBody::Ends::supported) {
    section.refuse("tension", "needs supported ends");
  }
}

void read_plate(Section& section, IdealBody& body) {
  read_outline(section, body);
  read_stiff(section, body);
  section.optional("poisson", body.poisson, Range{.above = -1.0, .at_most = 0.5});
  const auto has_free = [](const auto& edges) { return std::ranges::count(edges, eigenmodes::PlateEdge::free) > 0; };
  if (body.tension > 0.0 && std::ranges::any_of(body.edges, has_free)) {
    section.refuse("tension", "needs edges that are supported or clamped");
  }
}

void read_type(Section& section, IdealBody& body, const Folder& folder) {
  switch (body.type) {
    case Type::membrane:
      return read_membrane(section, body, folder);
    case Type::string:
      return read_string(section, body);
    case Type::bar:
      return read_bar(section, body);
    case Type::plate:
      return read_plate(section, body);
  }
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, IdealBody& body, const Folder& folder) {
  const Choices<Type> types{
      {{"membrane", Type::membrane}, {"string", Type::string}, {"bar", Type::bar}, {"plate", Type::plate}}};
  body.where = node.key_where;
  Section section(node, mistakes);
  if (!section.required("type", body.type, types)) {
    return false;  // the other keys depend on it
  }
  refuse_others(section, body.type);
  read_type(section, body, folder);
  section.optional("friction", body.friction, Range{.at_least = 0.0, .at_most = 1.0});
  section.optional("position", body.position, scene::coordinate);
  return section.finish();
}

}  // namespace idiophone::sound_maps
