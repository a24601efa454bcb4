#pragma once
// Options that several commands have, and how a command answers.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/values.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

namespace idiophone::app {

/// What a command writes to standard output. Where that is for scripts, what is logged goes to standard error.
enum class Style {
  text,  ///< for people
  json,  ///< facts for scripts
  deck   ///< a resolved deck, YAML
};

/// --set, for values of a deck, or of another YAML file.
void add_overrides(CLI::App& app, std::vector<std::string>& overrides);

/// The deck, and --set.
void add_deck(CLI::App& app, std::filesystem::path& deck, std::vector<std::string>& overrides);

/// --output-folder, of a command that writes several files.
/// @param text  what the folder is for
void add_output_folder(CLI::App& app, std::filesystem::path& folder, const std::string& text);

/// -o, --output, of a command that writes one file.
/// @param text  what the file is
void add_output_file(CLI::App& app, std::filesystem::path& file, const std::string& text);

/// --progress
void add_progress(CLI::App& app, loop::ProgressWish& wish);

/// --body, one of a deck.
void add_body(CLI::App& app, std::string& body);

/// --mass
/// @param text  what its words mean
void add_mass(CLI::App& app, eigenmodes::MassMatrix& mass, const std::string& text);

/// --estimate and --no-estimate, of the error of the mesh.
void add_estimates(CLI::App& app, eigenmodes::Estimates& wanted);

/// The word of --mass for it.
[[nodiscard]] std::string mass_name(eigenmodes::MassMatrix mass);

/// --json, for a command that prints facts.
void add_json(CLI::App& app, Style& style);

/// Refuses an option that had another name, and says the new one.
void add_renamed(CLI::App& app, const std::string& old_name, const std::string& new_name);

/// An option whose value is one of a few words.
/// @param take  is called with the word that is given
/// @param word  of the default; empty for none
void add_word(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
              const std::function<void(const std::string&)>& take, const std::string& word, const std::string& text);

/// The same, for an enumeration.
/// @param choice  default, and where the choice goes; T or std::optional<T>
template <class Choice, class T>
void add_choice(CLI::App& app, const std::string& name, Choice& choice, const deck::Choices<T>& choices,
                const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const auto& [known, meaning] : choices.words) {
    words.push_back(known);
    word = choice == meaning ? known : word;
  }
  const auto take = [&choice, choices](const std::string& given) {
    for (const auto& [known, meaning] : choices.words) {
      if (known == given) {
        choice = meaning;
      }
    }
  };
  add_word(app, name, words, take, word, text);
}

}  // namespace idiophone::app
