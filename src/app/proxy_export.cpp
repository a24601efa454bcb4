#include "proxy_export.hpp"

#include "idiophone/instruments/proxies/proxy_file.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/scene/find_body.hpp"
#include "shared_options.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

void declare(CLI::App& app, ProxyExport& options) {
  app.add_option("--proxy", options.file, "FILE.proxy: masses and springs of a deck's body, for the same library");
  app.add_option("--body", options.body, "the body of --proxy (default: the first of the deck)");
  app.add_option("--levels", options.levels, "of detail of --proxy")->check(CLI::Range(1, 6))->capture_default_str();
  add_springs(app, options.springs);
  add_overrides(app, options.overrides);
  for (const char* of_proxy : {"--body", "--levels", "--springs", "--set"}) {
    app.get_option(of_proxy)->needs("--proxy");
  }
}

std::string proxy_of_deck(const std::filesystem::path& deck, const ProxyExport& options) {
  const scene::Scene scene = bodies::read_deck(deck, options.overrides, MPI_COMM_WORLD);
  const std::size_t body = scene::find_body(scene.bodies, options.body);
  proxy_bodies::warn_of_what_proxies_lack(scene);
  return proxies::proxy_file({.name = scene.bodies[body].name,
                              .levels = proxy_bodies::proxy_levels(scene, body, options.levels, options.springs)});
}

}  // namespace idiophone::app
