// What a result says of its run, and how it is read back.

#include <nlohmann/json.hpp>

#include "idiophone/study/contents/describe.hpp"
#include "ranks.hpp"
#include "results.hpp"

namespace idiophone::results {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const nlohmann::json run = {
    {"step", 1.0 / 3.0},
    {"steps_per_sample", 12},
    {"steps_per_read", 4},
    {"deck", "name: plate\n"},
    {"bodies", {{"plate", {{"nodes", 70}, {"elements", 7}, {"element", "tet10"}, {"triangles", 3}, {"mass", 0.25}}}}}};
const nlohmann::json job = {{"ranks", 2}, {"first_sample", 0}, {"instruction_set", "AVX2"}};
const nlohmann::json end_of_job = {{"last_sample", 100},
                                   {"elapsed", 4.0},
                                   {"elements_per_second", 5e6},
                                   {"stages", {{"motion", 3.0}, {"store", 1.0}}}};

nlohmann::json read(const std::filesystem::path& path) {
  return nlohmann::json::parse(contents::describe_as_json(path));
}

/// What only rank 0 knows.
nlohmann::json of_rank_0(const nlohmann::json& facts) {
  return rank() == 0 ? facts : nlohmann::json();
}

ON_RANKS(1, 3);

TEST(ResultFacts, AreReadAsTheyWereWritten) {
  const Folder folder;
  auto result = make_result(folder / "plate.h5", 0);
  result.note("/run", of_rank_0(run));
  EXPECT_EQ(result.add_job(of_rank_0(job)), "/run/jobs/000");
  result.note("/run/jobs/000", of_rank_0(end_of_job));
  result.flush();
  auto resumed = ResultFile::open(folder / "plate.h5", MPI_COMM_WORLD);
  EXPECT_EQ(resumed.add_job(of_rank_0(job)), "/run/jobs/001");
  resumed.flush();

  auto expected = run;
  auto first = job;
  first.update(end_of_job);
  expected["jobs"] = {first, job};
  EXPECT_EQ(read(folder / "plate.h5")["run"], expected);
  EXPECT_THAT(contents::describe(folder / "plate.h5"),
              AllOf(HasSubstr("step 0.333333 s: 12 steps per audio sample, surface read every 4"),
                    HasSubstr("body plate: 70 nodes, 7 tet10 elements, 3 surface triangles, 0.25 kg"),
                    HasSubstr("job 1: 2 ranks, AVX2, from audio sample 0 to 100, 4.0 s of computing, 2.5 million"),
                    HasSubstr("motion 75.0 %  store 25.0 %"), HasSubstr("it did not stop in good order")));
}

TEST(ResultFacts, AreWrittenOnce) {
  const Folder folder;
  auto result = make_result(folder / "plate.h5", 0);
  result.note("/run", of_rank_0({{"step", 1.0}}));
  EXPECT_THAT(error_of([&] { result.note("/run", of_rank_0({{"step", 2.0}})); }), HasSubstr("step"));
}

TEST(ResultFacts, DatasetsHaveTheirAttributes) {
  const Folder folder;
  make_result(folder / "plate.h5", 0);
  const auto all = read(folder / "plate.h5");
  EXPECT_EQ(all["name"], "plate & hammer");
  EXPECT_FALSE(all.contains("run"));
  const auto& sound = all["datasets"]["/audio/ears"];
  EXPECT_EQ(sound["shape"], nlohmann::json({100, 2}));
  EXPECT_EQ(sound["columns"], nlohmann::json({"ears.left", "ears.right"}));
  EXPECT_EQ(sound["positions"], nlohmann::json(ears.positions));
  EXPECT_EQ(sound["rate"], 44100.0);
  EXPECT_NEAR(sound["loudest"].get<double>(), 2.0 / 3.0, 1e-12);
  EXPECT_EQ(all["datasets"]["/deck"]["text"], nlohmann::json({origin.deck_text}));
}

}  // namespace
}  // namespace idiophone::results
