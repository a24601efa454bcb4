#include "shared_options.hpp"

#include <fmt/format.h>

namespace idiophone::app {

namespace {

deck::Choices<eigenmodes::MassMatrix> mass_matrices() {
  using eigenmodes::MassMatrix;
  return {{{"lumped", MassMatrix::lumped}, {"consistent", MassMatrix::consistent}}};
}

}  // namespace

void add_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  app.add_option("--set", overrides, "KEY.PATH=VALUE: overrides a value of the deck; may be given again")
      ->take_all()
      ->expected(1);
}

void add_deck(CLI::App& app, std::filesystem::path& deck, std::vector<std::string>& overrides) {
  app.add_option("deck", deck, "the scene, a YAML file (docs/use/deck.md)")->required();
  add_overrides(app, overrides);
}

void add_output_folder(CLI::App& app, std::filesystem::path& folder, const std::string& text) {
  app.add_option("--output-folder", folder, text)->default_str(folder.string());
  add_renamed(app, "--output", "--output-folder");
}

void add_output_file(CLI::App& app, std::filesystem::path& file, const std::string& text) {
  app.add_option("-o,--output", file, text)->default_str(file.string());
}

void add_progress(CLI::App& app, loop::ProgressWish& wish) {
  using loop::ProgressWish;
  const deck::Choices<ProgressWish> wishes{
      {{"auto", ProgressWish::automatic}, {"line", ProgressWish::line}, {"log", ProgressWish::log}}};
  add_choice(app, "--progress", wish, wishes, "one updating line, or lines of a log (under mpirun: log)");
}

void add_body(CLI::App& app, std::string& body) {
  app.add_option("--body", body, "of the deck (default: the first)");
}

void add_mass(CLI::App& app, eigenmodes::MassMatrix& mass, const std::string& text) {
  add_choice(app, "--mass", mass, mass_matrices(), text);
}

std::string mass_name(eigenmodes::MassMatrix mass) {
  return deck::to_node(mass, mass_matrices()).text;
}

void add_estimates(CLI::App& app, eigenmodes::Estimates& wanted) {
  CLI::Option* all = app.add_flag_callback(
      "--estimate", [&wanted] { wanted = eigenmodes::Estimates::all; },
      "estimate the error of the mesh for all modes (default: the lowest, for about ten seconds of one core)");
  app.add_flag_callback(
         "--no-estimate", [&wanted] { wanted = eigenmodes::Estimates::none; }, "do not estimate the error of the mesh")
      ->excludes(all);
}

void add_json(CLI::App& app, Style& style) {
  app.add_flag_callback(
      "--json", [&style] { style = Style::json; }, "answer in JSON, for scripts");
}

void add_renamed(CLI::App& app, const std::string& old_name, const std::string& new_name) {
  const auto refuse = [=](const std::string& /*value*/) {
    throw CLI::ValidationError(fmt::format("{} was renamed: use {}", old_name, new_name));
  };
  app.add_option_function<std::string>(old_name, refuse)->expected(0, 1)->group("");  // not in --help
}

void add_word(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
              const std::function<void(const std::string&)>& take, const std::string& word, const std::string& text) {
  CLI::Option* option = app.add_option_function<std::string>(name, take, text)->check(CLI::IsMember(words));
  if (!word.empty()) {
    option->default_str(word);
  }
}

}  // namespace idiophone::app
