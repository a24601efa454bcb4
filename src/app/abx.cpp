// `idiophone abx`: a blind listening test of two sounds, as a web page.

#include "command.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/study/abx/abx_page.hpp"

namespace idiophone::app {

namespace {

struct AbxOptions {
  abx::Settings settings;
  std::filesystem::path page = "abx.html";  ///< to write
};

void declare(CLI::App& app, AbxOptions& options) {
  app.add_option("a", options.settings.a, "NAME.h5, or a sound file: WAV, FLAC, ...")->required();
  app.add_option("b", options.settings.b, "likewise")->required();
  add_output_file(app, options.page, "the page to write");
  app.add_option("--listener", options.settings.listener, "of results with several");
  app.add_flag("--match-levels", options.settings.match_levels, "both sounds get the same energy");
  app.add_option("--trials", options.settings.trials, "how often the listener answers")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

int write_abx(const AbxOptions& options) {
  web::write_page(options.page.string(), abx::page(options.settings));
  return loop::exit_finished;
}

}  // namespace

Command abx_command() {
  return make_command<AbxOptions>("abx", "make a blind listening test of two sounds, a web page", Ranks::one, declare,
                                  write_abx);
}

}  // namespace idiophone::app
