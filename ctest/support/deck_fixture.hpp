#pragma once
// A folder of its own for each test, with a small deck and the files it names.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

class DeckTest : public testing::Test {
 public:
  DeckTest(const DeckTest&) = delete;
  DeckTest(DeckTest&&) = delete;
  DeckTest& operator=(const DeckTest&) = delete;
  DeckTest& operator=(DeckTest&&) = delete;

  /// The text with every `old` replaced; the test fails if there is none.
  static std::string replaced(std::string text, const std::string& old, const std::string& by) {
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size())) {
      text.replace(at, old.size(), by);
    }
    return text;
  }

 protected:
  DeckTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::temp_directory_path() /
             fmt::format("idiophone_{}_{}_{}", test->test_suite_name(), test->name(), ::getpid());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "shapes");
    write("plate.geo", "");
    write("shapes/bar.msh", "");
  }
  ~DeckTest() override { std::filesystem::remove_all(folder); }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder / file, std::ios::binary) << text;
  }

  /// Writes the text as deck.yaml and reads it.
  [[nodiscard]] Scene read(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    write("deck.yaml", text);
    return read_deck(folder / "deck.yaml", overrides);
  }

  /// The mistakes of a deck, a line each, with "deck.yaml" for its whole path and "DIR" for its folder.
  [[nodiscard]] std::string mistakes(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    try {
      static_cast<void>(read(text, overrides));
    } catch (const deck::DeckError& error) {
      return replaced(replaced(error.what(), folder.string() + "/deck.yaml:", "deck.yaml:"), folder.string(), "DIR");
    }
    return "no mistakes";
  }

  std::filesystem::path folder;
  const std::string plate =
      "name: plate\n"
      "time: {duration: 1.0}\n"
      "materials:\n"
      "  steel: {young: 2.0e11, poisson: 0.3, density: 7850}\n"
      "bodies:\n"
      "  plate: {mesh: plate.geo, material: steel, fixed: [rim]}\n"
      "loads:\n"
      "  tap: {at: [0, 0, 0], force: [0, 0, -20], duration: 1.0e-3}\n"
      "listeners:\n"
      "  ear: {type: mono, position: [0, 0, 1]}\n";
};

}  // namespace idiophone::scene
