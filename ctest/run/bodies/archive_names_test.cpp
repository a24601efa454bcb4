// docs/method/checkpoints.md and the code name the same state.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "idiophone/run/bodies/combined_source.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"
#include "idiophone/run/results/surface_motion_file.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {
namespace {

/// All names in the first column of the page's tables, BODY, CONTACT, EAR and PATH as they stand there.
std::set<std::string> documented() {
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/method/checkpoints.md");
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

/// Records one triangle at rest: two audio samples.
void record(const std::filesystem::path& path) {
  const bool root = support::rank() == 0;
  const auto numbers = root ? std::vector<Index>{0, 1, 2} : std::vector<Index>();
  const std::vector<double> reference = root ? std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0} : std::vector<double>();
  const parallel::Rows triangles(std::span<const Index>(numbers).first(root ? 1 : 0), 1, MPI_COMM_WORLD);
  const parallel::Rows vertices(numbers, 3, MPI_COMM_WORLD);
  surface::RecordingHeader header;
  header.rate = 8000;
  header.samples = 1;
  header.air_density = 1.2;
  header.air_speed = 340;
  header.bodies = {{"bell", 0, 0}};
  auto file =
      results::SurfaceMotionFile::create(path, header, {&triangles, &vertices, numbers, reference}, MPI_COMM_WORLD);
  for (int row = 0; row < 2; ++row) {
    file.append(1, std::vector<double>(root ? 1 : 0), reference);
  }
  file.flush();
}

/// Air without pressure.
class NoAir : public propagation::AirLoad {
 public:
  [[nodiscard]] int steps() const override { return 1; }
  void connect(const std::vector<Index>& /*triangles*/) override {}
  void advance(std::span<const double> /*changes*/, std::span<double> /*force*/,
               std::span<double> /*resistance*/) override {}
};

/// All names of an archive, with those of the deck replaced as on the page.
std::set<std::string> archived(Source& source) {
  parallel::ArchiveNames archive(MPI_COMM_WORLD);
  source.archive(archive);
  std::set<std::string> names;
  for (std::string name : archive.names()) {
    name = std::regex_replace(name, std::regex("memory/\\w+"), "memory/BODY");
    name = std::regex_replace(name, std::regex("modal/\\w+/"), "modal/BODY/");
    name = std::regex_replace(name, std::regex("fracture/\\w+"), "fracture/BODY");
    name = std::regex_replace(name, std::regex("recording/\\w+/"), "recording/BODY/");
    names.insert(std::regex_replace(name, std::regex("contact/\\w+/"), "contact/CONTACT/"));
  }
  return names;
}

ON_RANKS(1, 3);

TEST(ArchiveNames, EveryStateOfComputedAndRecordedBodiesIsDocumented) {
  const scene::Scene scene = scene::read_deck(
      IDIOPHONE_SOURCE_DIR "/ctest/app/decks/touching.yaml",
      {"materials.foam.damping={loss_factor: 0.1, band: [50, 3000]}", "bodies.block.model={type: modal, count: 2}",
       "loads={rub: {type: bow, body: block, at: [0.12, 0, 0.0151], direction: [0, 1, 0], speed: 1, load: 1}}",
       "bodies.bar={mesh: seam.geo, position: [1, 0, 0], material: rubber, fracture: [{surface: seam, strength: 1}]}"});
  const Preparation ready = prepare(scene, MPI_COMM_WORLD);
  parallel::Stages stages;
  const support::Folder folder;
  record(folder / "bell_surface.h5");
  std::vector<std::unique_ptr<Source>> sources;
  auto bodies = std::make_unique<FiniteElementSource>(ready, stages, MPI_COMM_WORLD);
  NoAir air;
  bodies->couple(air);
  sources.push_back(std::move(bodies));
  sources.push_back(std::make_unique<RecordedSource>("bell", results::SurfaceMotionReader(folder / "bell_surface.h5"),
                                                     scene.radiation, RecordedObstacles::keep, MPI_COMM_WORLD));
  CombinedSource source(std::move(sources));
  surface::SurfaceMotion motion;
  source.start(motion);
  const std::set<std::string> names = archived(source);
  const std::set<std::string> page = documented();
  for (const std::string& name : names) {
    EXPECT_TRUE(page.contains(name)) << name << " is not in docs/method/checkpoints.md";
  }
  for (const std::string& name : page) {
    const std::string group = name.substr(0, name.find('/'));
    const bool of_sources = group == "motion" || group == "contact" || group == "recording" || group == "source";
    EXPECT_TRUE(!of_sources || names.contains(name)) << name << " of docs/method/checkpoints.md does not exist";
  }
  EXPECT_GT(names.size(), 10U);
}

}  // namespace
}  // namespace idiophone::bodies
