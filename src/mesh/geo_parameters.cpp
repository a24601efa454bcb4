#include "geo_parameters.hpp"

#include <fmt/format.h>
#include <gmsh.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "gmsh_session.hpp"
#include "idiophone/deck/location.hpp"

namespace idiophone::mesh {

namespace {

/// A .geo script in the folder for temporary files, gone with this object.
class TemporaryScript {
 public:
  explicit TemporaryScript(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / "idiophone_XXXXXX.geo").string()) {
    const int file = mkstemps(path_.data(), 4);
    if (file < 0) {
      throw std::runtime_error("can't write a temporary file " + path_ + " for gmsh: is the folder writable?");
    }
    close(file);
    std::ofstream(path_) << text;
  }
  ~TemporaryScript() { unlink(path_.c_str()); }
  TemporaryScript(const TemporaryScript&) = delete;
  TemporaryScript& operator=(const TemporaryScript&) = delete;
  TemporaryScript(TemporaryScript&&) = delete;
  TemporaryScript& operator=(TemporaryScript&&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string include_line(const scene::Body& body) {
  return fmt::format("Include \"{}\";\n", std::filesystem::absolute(body.mesh).string());
}

/// A line that leaves the value of an expression under the parameter's name where probe() finds it: gmsh has no call
/// that asks for a variable, but a constant with a Name is kept by its ONELAB server.
std::string probe_line(const std::string& parameter, const std::string& expression) {
  return fmt::format("DefineConstant[ idiophone_probe_{0} = {{ {1}, Name \"idiophone/{0}\" }} ];\n", parameter,
                     expression);
}

double probe(const std::string& parameter) {
  std::vector<double> values;
  gmsh::onelab::getNumber("idiophone/" + parameter, values);
  return values.at(0);
}

const deck::Location& place_of(const scene::Body& body, const std::string& parameter) {
  const auto found = body.parameters_where.find(parameter);
  return found == body.parameters_where.end() ? body.mesh_where : found->second;
}

}  // namespace

void require_parameters(const scene::Body& body) {
  std::string text = include_line(body);
  for (const auto& [name, value] : body.parameters) {
    text += probe_line(name, fmt::format("Exists({})", name));
  }
  const TemporaryScript script(text);
  const auto mistakes = with_gmsh(body, [&] {
    gmsh::open(script.path());
    std::vector<deck::Mistake> unknown;
    for (const auto& [name, value] : body.parameters) {
      if (probe(name) == 0.0) {
        unknown.push_back({place_of(body, name), fmt::format("{} defines no parameter '{}'; a parameter is a constant "
                                                             "that the file sets by DefineConstant[ name = value ]",
                                                             body.mesh.string(), name)});
      }
    }
    return unknown;
  });
  if (!mistakes.empty()) {
    throw deck::DeckError(mistakes);
  }
}

void open_with_parameters(const scene::Body& body) {
  std::string assignments;
  std::string probes;
  for (const auto& [name, value] : body.parameters) {
    assignments += fmt::format("{} = {:.17g};\n", name, value);
    probes += probe_line(name, name);
  }
  const TemporaryScript script(assignments + include_line(body) + probes);
  gmsh::open(script.path());
  std::vector<deck::Mistake> overwritten;
  for (const auto& [name, value] : body.parameters) {
    if (probe(name) != value) {
      overwritten.push_back({place_of(body, name), fmt::format("{} sets '{}' to {} itself: define it there by "
                                                               "DefineConstant[ {} = value ], which leaves a deck's "
                                                               "value alone",
                                                               body.mesh.string(), name, probe(name), name)});
    }
  }
  if (!overwritten.empty()) {
    throw deck::DeckError(overwritten);
  }
}

}  // namespace idiophone::mesh
