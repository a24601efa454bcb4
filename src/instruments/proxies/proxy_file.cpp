#include "idiophone/instruments/proxies/proxy_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/flat_file.hpp"

namespace idiophone::proxies {

namespace {

constexpr FlatKind proxy_kind{
    .magic = "IDIOPHONE PROXY\n", .version = 1, .made_with = "idiophone export DECK --proxy FILE.proxy"};
constexpr std::size_t most_levels = 6;
constexpr double farthest_node = 1e6;  // m

/// What a lattice is made of.
struct LatticeParts {
  TetrahedralMesh mesh;
  Material material;
  std::vector<Index> pinned;
  OwnValues own;
};

template <class Archive>
void all_of_springs(Archive& archive, std::vector<OwnSpring>& springs) {
  springs.resize(archive.count(springs.size(), sizeof(OwnSpring)));
  for (OwnSpring& spring : springs) {
    archive.number(spring.a);
    archive.number(spring.b);
    archive.number(spring.stiffness);
    archive.number(spring.damping);
    archive.number(spring.length);
  }
}

/// The one order of all that the file has of a lattice, for writing and reading.
template <class Archive>
void all_of(Archive& archive, LatticeParts& parts) {
  each_value(archive, parts.mesh.nodes);
  each_value(archive, parts.mesh.tetrahedra);
  each_value(archive, parts.mesh.surface);
  for (double* number : {&parts.material.young, &parts.material.density, &parts.material.damping.mass,
                         &parts.material.damping.stiffness}) {
    archive.number(*number);
  }
  each_value(archive, parts.pinned);
  for (std::vector<double>* values : {&parts.own.stiffness, &parts.own.damping, &parts.own.length, &parts.own.masses}) {
    each_value(archive, *values);
  }
  each_value(archive, parts.own.edges);
  all_of_springs(archive, parts.own.springs);
}

LatticeParts parts_of(const Lattice& lattice) {
  LatticeParts parts{.mesh = lattice.mesh(), .material = lattice.material(), .pinned = {}, .own = lattice.own()};
  parts.mesh.nodes = lattice.given_nodes();
  for (std::size_t node = 0; node < lattice.pinned().size(); ++node) {
    if (lattice.pinned()[node]) {
      parts.pinned.push_back(static_cast<Index>(node));
    }
  }
  return parts;
}

/// What the lattice takes for granted.
void check(const TetrahedralMesh& mesh) {
  if (mesh.tetrahedra.empty() || mesh.surface.empty()) {
    throw std::runtime_error("a level has no tetrahedra, or no surface");
  }
  if (!std::ranges::all_of(mesh.nodes, [](const Vector3& node) {
        return node.allFinite() && node.cwiseAbs().maxCoeff() <= farthest_node;
      })) {
    throw std::runtime_error("a node is not finite, or more than 1e6 m away");
  }
  const auto is_node = [&](Index node) { return node >= 0 && node < std::ssize(mesh.nodes); };
  const auto has_nodes = [&](const auto& corners) { return std::ranges::all_of(corners, is_node); };
  if (!std::ranges::all_of(mesh.tetrahedra, has_nodes) || !std::ranges::all_of(mesh.surface, has_nodes)) {
    throw std::runtime_error("a tetrahedron or a triangle has a node that there is not");
  }
}

StoredBody read_contents(std::span<const char> bytes) {
  ByteReader reader = flat_contents(proxy_kind, bytes);
  StoredBody body;
  reader.text(body.name);
  const std::size_t levels = reader.count(0, 1);
  if (levels == 0 || levels > most_levels) {
    throw std::runtime_error("it has " + std::to_string(levels) + " levels; a body has 1 to " +
                             std::to_string(most_levels));
  }
  for (std::size_t level = 0; level < levels; ++level) {
    LatticeParts parts;
    all_of(reader, parts);
    check(parts.mesh);
    body.levels.push_back(
        std::make_shared<const Lattice>(std::move(parts.mesh), parts.material, parts.pinned, std::move(parts.own)));
  }
  reader.end();
  return body;
}

}  // namespace

std::string proxy_file(const StoredBody& body) {
  ByteWriter contents;
  contents.text(body.name);
  contents.count(body.levels.size(), 1);
  for (const auto& lattice : body.levels) {
    LatticeParts parts = parts_of(*lattice);
    all_of(contents, parts);
  }
  return flat_file(proxy_kind, contents);
}

StoredBody read_proxy(std::span<const char> bytes, const std::string& name) {
  try {
    return read_contents(bytes);
  } catch (const std::exception& error) {
    throw std::runtime_error(name + " is no proxy file that can be read: " + error.what());
  }
}

StoredBody read_proxy(const std::filesystem::path& path) {
  return read_proxy(read_bytes(path), path.string());
}

}  // namespace idiophone::proxies
