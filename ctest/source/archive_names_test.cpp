// docs/checkpoints.md and the code name the same state.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "idiophone/source/finite_element_source.hpp"

namespace idiophone::source {
namespace {

/// All names in the first column of the page's tables, BODY, CONTACT, EAR and PATH as they stand there.
std::set<std::string> documented() {
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/checkpoints.md");
  static const std::regex name(R"(`(\w+/[\w/]+)`)");
  std::set<std::string> names;
  for (std::string line; std::getline(file, line);) {
    const std::string cell = line.starts_with("|") ? line.substr(0, line.find('|', 1)) : "";
    for (std::sregex_iterator match(cell.begin(), cell.end(), name), end; match != end; ++match) {
      names.insert((*match)[1]);
    }
  }
  return names;
}

TEST(ArchiveNames, EveryStateOfComputedBodiesIsDocumented) {
  scene::Scene scene = scene::read_deck(IDIOPHONE_SOURCE_DIR "/ctest/app/decks/touching.yaml",
                                        {"materials.foam.damping={loss_factor: 0.1, band: [50, 3000]}"});
  const Preparation ready = prepare(scene, MPI_COMM_WORLD);
  parallel::Stages stages;
  FiniteElementSource source(ready, stages, MPI_COMM_WORLD);
  surface::SurfaceMotion motion;
  source.start(motion);
  parallel::ArchiveNames archive(MPI_COMM_WORLD);
  source.archive(archive);
  std::set<std::string> names;
  for (std::string name : archive.names()) {
    name = std::regex_replace(name, std::regex("memory/\\w+"), "memory/BODY");
    names.insert(std::regex_replace(name, std::regex("contact/\\w+/"), "contact/CONTACT/"));
  }
  const std::set<std::string> page = documented();
  for (const std::string& name : names) {
    EXPECT_TRUE(page.contains(name)) << name << " is not in docs/checkpoints.md";
  }
  for (const std::string& name : page) {
    const bool of_bodies = name.starts_with("motion/") || name.starts_with("contact/");
    EXPECT_TRUE(!of_bodies || names.contains(name)) << name << " of docs/checkpoints.md does not exist";
  }
  EXPECT_GT(names.size(), 8U);
}

}  // namespace
}  // namespace idiophone::source
