#include "geo_parameters.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <stdexcept>

#include "start_gmsh.hpp"

namespace idiophone::mesher {

namespace {

/// gmsh knows two kinds of quotation marks, and no way to write either of them between its own.
std::string include_line(const mesh::MeshingRequest& request) {
  const char quote = request.file.find('"') == std::string::npos ? '"' : '\'';
  if (request.file.find_first_of(std::string(1, quote) + "\n") != std::string::npos) {
    return "Error(\"the path has both kinds of quotation marks, or a line break: gmsh can't include the file\");\n";
  }
  return fmt::format("Include {0}{1}{0};\n", quote, request.file);
}

/// A line that leaves the value of an expression under the parameter's name where probe() finds it: gmsh has no call
/// that asks for a variable, but a constant with a Name is kept by its ONELAB server.
std::string probe_line(const std::string& parameter, const std::string& expression) {
  return fmt::format("DefineConstant[ idiophone_probe_{0} = {{ {1}, Name \"idiophone/{0}\" }} ];\n", parameter,
                     expression);
}

/// Not a number when the file ended before the line was reached.
double probe(const std::string& parameter) {
  std::vector<double> values;
  gmsh::onelab::getNumber("idiophone/" + parameter, values);
  return values.empty() ? std::nan("") : values.front();
}

std::string probing_script(const mesh::MeshingRequest& request) {
  std::string text = include_line(request);
  for (const auto& [name, value] : request.parameters) {
    text += probe_line(name, fmt::format("Exists({})", name));
  }
  return text;
}

std::string setting_script(const mesh::MeshingRequest& request) {
  std::string assignments = fmt::format("hexahedra = {};\n", request.hexahedra);
  std::string probes;
  for (const auto& [name, value] : request.parameters) {
    assignments += fmt::format("{} = {:.17g};\n", name, value);
    probes += probe_line(name, name);
  }
  return assignments + include_line(request) + probes;
}

}  // namespace

GeoScripts::GeoScripts(const mesh::MeshingRequest& request)
    : probing_(probing_script(request)), setting_(setting_script(request)) {}

std::vector<mesh::Objection> GeoScripts::undefined_parameters(const mesh::MeshingRequest& request) const {
  probing_.run();
  std::vector<mesh::Objection> undefined;
  for (const auto& [name, value] : request.parameters) {
    if (probe(name) != 1.0) {
      undefined.push_back({name, fmt::format("{} defines no parameter '{}'; a parameter is a constant that the file "
                                             "sets by DefineConstant[ name = value ]",
                                             request.file, name)});
    }
  }
  clear_gmsh();
  return undefined;
}

std::vector<mesh::Objection> GeoScripts::open_with_parameters(const mesh::MeshingRequest& request) const {
  setting_.run();
  std::vector<mesh::Objection> overwritten;
  for (const auto& [name, value] : request.parameters) {
    if (probe(name) != value) {
      overwritten.push_back({name, fmt::format("{} sets '{}' to {} itself: define it there by DefineConstant[ {} = "
                                               "value ], which leaves a deck's value alone",
                                               request.file, name, probe(name), name)});
    }
  }
  return overwritten;
}

}  // namespace idiophone::mesher
