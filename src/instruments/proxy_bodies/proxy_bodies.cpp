#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/solids/mesh/mesh_values.hpp"
#include "known_modes.hpp"
#include "own_springs.hpp"

namespace idiophone::proxy_bodies {

namespace {

void check_proxy_body(const scene::Body& body, int levels) {
  if (body.thickness) {
    throw deck::DeckError(body.thickness_where,
                          "a proxy needs tetrahedra; a wall with a thickness is meshed with hexahedra");
  }
  if (!body.regions.empty()) {
    throw deck::DeckError(body.regions.front().where,
                          "a proxy has one material, so bodies with `materials` have none: give the body a `material`");
  }
  if (body.prestress) {
    throw deck::DeckError(body.prestress->where, "a proxy has no prestress: its springs are at rest. Leave it out");
  }
  if (levels > 1 && !body.parameters.contains("size")) {
    throw deck::DeckError(body.mesh_where, "several levels need parameters: {size: ...}, the elements of the finest");
  }
  if (levels > 1 && body.springs) {
    throw deck::DeckError(body.mesh_where, "single springs belong to one mesh; leave out `springs` or `--levels`");
  }
  for (const scene::FixedGroup& fixed : body.fixed) {
    if (fixed.hinge || !std::ranges::all_of(fixed.axes, std::identity())) {
      throw deck::DeckError(fixed.where,
                            "proxies pin masses in all directions; hinges and single axes are not possible");
    }
  }
  if (!body.driven.empty()) {
    throw deck::DeckError(body.driven.front().where, "proxies have no driven groups");
  }
}

/// tan(phi) of the direction of the largest Young's modulus, which a proxy has in all directions.
double stiffest_loss(const scene::Material& material, double frequency) {
  const scene::LossFactor& loss = *material.damping.loss;
  if (!loss.directions) {
    return loss.at(frequency);
  }
  Eigen::Index stiffest = 0;
  material.orthotropy->young.maxCoeff(&stiffest);
  return loss.directions->young[stiffest];
}

/// Mass and stiffness damping; a loss factor is met exactly at two frequencies.
proxies::Damping proxy_damping(const scene::Material& material) {
  constexpr double low = 200.0, high = 5000.0;  // Hz
  const scene::Damping& damping = material.damping;
  proxies::Damping sum{.mass = damping.mass, .stiffness = damping.stiffness};
  if (damping.loss && stiffest_loss(material, high) > 0) {
    const auto t60 = [&](double frequency) {
      return std::log(1000.0) / (std::numbers::pi * frequency * stiffest_loss(material, frequency));
    };
    const proxies::Damping fitted = proxies::damping_for({low, high}, {t60(low), t60(high)});
    sum.mass += fitted.mass;
    sum.stiffness += fitted.stiffness;
  }
  return sum;
}

proxies::TetrahedralMesh tetrahedra_of(const mesh::Mesh& mesh) {
  proxies::TetrahedralMesh tetrahedra;
  tetrahedra.nodes = mesh.nodes;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    std::ranges::copy(mesh.element_nodes(element), tetrahedra.tetrahedra.emplace_back().begin());
  }
  tetrahedra.surface = mesh.surface;
  return tetrahedra;
}

/// A view of a .msh file that proxies know.
struct KnownView {
  const char* name;
  bool of_elements;
  std::vector<double> proxies::OwnValues::*values;
};
constexpr std::array<KnownView, 4> known_views = {{{"spring_stiffness", true, &proxies::OwnValues::stiffness},
                                                   {"spring_damping", true, &proxies::OwnValues::damping},
                                                   {"spring_length", true, &proxies::OwnValues::length},
                                                   {"mass", false, &proxies::OwnValues::masses}}};

proxies::OwnValues own_values(const scene::Body& body, const std::vector<mesh::MeshValues>& views) {
  proxies::OwnValues own;
  for (const mesh::MeshValues& view : views) {
    const auto* const known =
        std::ranges::find_if(known_views, [&](const KnownView& each) { return each.name == view.name; });
    if (known == known_views.end()) {
      spdlog::warn("{}: its view '{}' has no meaning for proxies", body.mesh.string(), view.name);
      continue;
    }
    if (view.of_elements != known->of_elements) {
      throw deck::DeckError(body.mesh_where,
                            fmt::format("the view '{}' of {} must be {}", view.name, body.mesh.string(),
                                        known->of_elements ? "$ElementData" : "$NodeData"));
    }
    own.*known->values = view.value;
  }
  return own;
}

std::string listed(std::span<const double> cents) {
  constexpr std::size_t most = 5;
  std::string text;
  for (const double each : cents.first(std::min(cents.size(), most))) {
    text += fmt::format(" {:+.0f}", each);
  }
  return text;
}

/// A body and one mesh of its proxy.
struct MeshedProxy {
  const scene::Solids& solids;
  std::size_t body;           ///< of the solids
  const scene::Body& meshed;  ///< the same with the elements of the proxy
};

/// @param plain  the lattice without values of its own
std::vector<proxies::EdgeFactors> fitted_edges(const MeshedProxy& proxy, const mesh::Mesh& mesh,
                                               const proxies::Lattice& plain) {
  constexpr double far = 100.0;  // cents, of which a warning tells
  try {
    const auto modes = known_modes(proxy.solids, proxy.body, mesh, proxies::modes_to_fit(plain));
    proxies::SpringFit fit = proxies::fit_springs(plain, modes);
    spdlog::info("{}: springs fitted to {} modes; the lowest ones are{} cents from those of finite elements,{} before",
                 proxy.meshed.name, modes.size(), listed(fit.after), listed(fit.before));
    const auto is_far = [](double cents) { return std::abs(cents) > far; };
    if (const auto count = std::ranges::count_if(fit.after, is_far); count > 0) {
      spdlog::warn(
          "{}: {} of its {} fitted modes are more than {} cents from those of finite elements; smaller elements "
          "follow them better",
          proxy.meshed.name, count, modes.size(), far);
    }
    return std::move(fit.edges);
  } catch (const std::exception& error) {
    throw deck::DeckError(proxy.meshed.mesh_where,
                          fmt::format("the springs of body '{}' can't be fitted: {}. --springs van_gelder does without",
                                      proxy.meshed.name, error.what()));
  }
}

std::shared_ptr<const proxies::Lattice> lattice_of(const MeshedProxy& proxy, Springs springs) {
  const scene::Body& meshed = proxy.meshed;
  const scene::Material& material = proxy.solids.materials[meshed.material];
  const auto [mesh, views] = mesh::read_mesh_with_values(meshed);
  std::vector<Index> pinned;
  for (const scene::FixedGroup& fixed : meshed.fixed) {
    const std::vector<Index>& nodes = mesh::find_group(mesh, fixed.group, fixed.where);
    pinned.insert(pinned.end(), nodes.begin(), nodes.end());
  }
  proxies::TetrahedralMesh tetrahedra = tetrahedra_of(mesh);
  proxies::OwnValues own = own_values(meshed, views);
  if (meshed.springs) {
    own.springs = own_springs(*meshed.springs, tetrahedra);
  }
  const proxies::Material of_springs{
      .young = material.young, .density = material.density, .damping = proxy_damping(material)};
  try {
    if (springs == Springs::fitted) {
      own.edges = fitted_edges(proxy, mesh, proxies::Lattice(tetrahedra, of_springs, pinned));
    }
    return std::make_shared<proxies::Lattice>(std::move(tetrahedra), of_springs, pinned, std::move(own));
  } catch (const std::invalid_argument& error) {
    throw deck::DeckError(meshed.mesh_where, fmt::format("body '{}': {}", meshed.name, error.what()));
  }
}

/// Null, with a warning, where a mesh of so large elements can't be made: the body has finer ones.
std::shared_ptr<const proxies::Lattice> coarser_lattice(const MeshedProxy& proxy, Springs springs, int level) {
  try {
    return lattice_of(proxy, springs);
  } catch (const std::exception& error) {
    spdlog::warn(
        "body {} does without its mesh {} of elements of {:.3g} m, which can't be used; give fewer --levels "
        "or a smaller size. The reason: {}",
        proxy.meshed.name, level, proxy.meshed.parameters.at("size"), error.what());
    return nullptr;
  }
}

void warn_of_material(const scene::Material& material) {
  if (!material.is_isotropic()) {
    spdlog::warn("material {} is not isotropic: its proxies have its largest Young's modulus in all directions",
                 material.name);
  }
  if (material.damping.loss) {
    spdlog::warn("material {}: its proxies have the loss factor at 200 and 5000 Hz only", material.name);
  }
  if (material.damping.of_vibration() > 0) {
    spdlog::warn("material {}: mass_of: vibration has no effect on its proxies, whose mass damping slows every motion",
                 material.name);
  }
}

}  // namespace

std::vector<std::shared_ptr<const proxies::Lattice>> proxy_levels(const scene::Solids& solids, std::size_t body,
                                                                  int levels, Springs springs) {
  scene::refuse_joints(solids, "proxies");
  scene::Body meshed = solids.bodies[body];
  check_proxy_body(meshed, levels);
  meshed.element = element::tet4;
  meshed.modal.reset();
  meshed.mass_scaling.reset();
  const MeshedProxy proxy{solids, body, meshed};
  std::vector<std::shared_ptr<const proxies::Lattice>> lattices = {lattice_of(proxy, springs)};
  for (int level = 1; level < levels; ++level) {
    meshed.parameters["size"] *= 2.0;
    if (auto coarser = coarser_lattice(proxy, springs, level)) {
      lattices.push_back(std::move(coarser));
    }
  }
  return lattices;
}

void warn_of_what_proxies_lack(const scene::Scene& scene) {
  for (const auto& body : scene.recorded_bodies) {
    spdlog::warn("body {} is a recording: it gets no proxy", body.name);
  }
  std::set<std::size_t> materials;
  for (const scene::Body& body : scene.bodies) {
    materials.insert(body.material);
    if (!body.supports.empty()) {
      spdlog::warn("body {}: its proxy has no supports", body.name);
    }
  }
  for (const std::size_t material : materials) {
    warn_of_material(scene.materials[material]);
  }
  if (std::ranges::any_of(scene.listeners, [](const auto& listener) { return listener.attached.has_value(); })) {
    spdlog::warn("listeners of proxies stand still: `attached` has no effect");
  }
  if (!scene.pulses.empty() || !scene.plucks.empty() || !scene.winds.empty() || !scene.bows.empty()) {
    spdlog::warn("the loads of the deck are left out; --score says what is done to proxies");
  }
}

}  // namespace idiophone::proxy_bodies
