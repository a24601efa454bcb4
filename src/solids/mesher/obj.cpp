// Wavefront OBJ files.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "refusal.hpp"
#include "triangles.hpp"

namespace idiophone::mesher {

namespace {

struct Faces {
  std::vector<double> coordinates;     // [3 x vertices]
  std::vector<std::size_t> triangles;  // [3 x triangles] vertices, from 1
  std::set<std::string> names;         // of objects and groups
};

void read_vertex(std::istringstream& line, Faces& faces) {
  for (int axis = 0; axis < 3; ++axis) {
    double value = 0.0;
    if (!(line >> value)) {
      throw Refusal("a vertex needs three numbers");
    }
    faces.coordinates.push_back(value);
  }
}

/// A face's corner is "7", "7/1", "7//3" or "7/1/3", of which the first is the vertex; -1 is the last vertex so far.
std::size_t read_corner(const std::string& word, std::size_t vertices) {
  long number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool ends_well = error == std::errc() && (end == word.data() + word.size() || *end == '/');
  if (ends_well && number < 0) {
    number += static_cast<long>(vertices) + 1;
  }
  if (!ends_well || number < 1 || number > static_cast<long>(vertices)) {
    throw Refusal(fmt::format("'{}' is none of the {} vertices so far", word, vertices));
  }
  return static_cast<std::size_t>(number);
}

void read_face(std::istringstream& line, Faces& faces) {
  std::vector<std::size_t> corners;
  for (std::string word; line >> word;) {
    corners.push_back(read_corner(word, faces.coordinates.size() / 3));
  }
  if (corners.size() < 3) {
    throw Refusal("a face needs at least three corners");
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    faces.triangles.insert(faces.triangles.end(), {corners[0], corners[i - 1], corners[i]});
  }
}

/// Where the faces that follow belong.
struct Section {
  std::string object;
  std::string group;  // of the object

  [[nodiscard]] bool is_in(const std::string& name) const { return name.empty() || object == name || group == name; }
};

/// The rest of a line without spaces around it.
std::string rest_of(std::istringstream& line) {
  std::string rest;
  std::getline(line >> std::ws, rest);
  rest.erase(rest.find_last_not_of(" \t\r") + 1);
  return rest;
}

Faces read_faces(const std::string& file, const std::string& object) {
  std::ifstream stream(file);
  Faces faces;
  Section section;
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    std::istringstream line(text);
    std::string keyword;
    line >> keyword;
    try {
      if (keyword == "v") {
        read_vertex(line, faces);
      } else if (keyword == "o") {
        section = {.object = rest_of(line), .group = {}};
        faces.names.insert(section.object);
      } else if (keyword == "g") {
        section.group = rest_of(line);
        faces.names.insert(section.group);
      } else if (keyword == "f" && section.is_in(object)) {
        read_face(line, faces);
      }
    } catch (const Refusal& error) {
      throw Refusal(fmt::format("{}:{}: {}", file, number, error.what()));
    }
  }
  return faces;
}

}  // namespace

void open_obj(const std::string& file, const std::string& object) {
  const Faces faces = read_faces(file, object);
  if (!object.empty() && faces.triangles.empty()) {
    throw NoSuchObject(
        fmt::format("it has no faces of an object '{}'. It has: {}", object,
                    faces.names.empty() ? "none with a name" : fmt::format("{}", fmt::join(faces.names, ", "))));
  }
  add_triangles(faces.coordinates, faces.triangles);
}

}  // namespace idiophone::mesher
