#include "idiophone/run/bodies/channel.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {
namespace {

using namespace support;
using ::testing::ElementsAre;

/// Two channels of one measurement, whose rows are on rank 0 only.
class Pendulum : public ChannelGroup {
 public:
  Pendulum()
      : ChannelGroup({{"/pendulum/angle", "rad", 100.0, {"angle"}, "angle", {}},
                      {"/pendulum/energy", "J", 100.0, {"kinetic", "potential"}, "energies", {}}}) {}

  void note(std::int64_t sample) override { samples_.push_back(static_cast<double>(sample)); }
  std::vector<std::vector<double>> collect() override {
    std::vector<std::vector<double>> rows(2);
    for (const double sample : samples_) {
      if (rank() == 0) {
        rows[0].push_back(sample);
        rows[1].insert(rows[1].end(), {sample, -sample});
      }
    }
    samples_.clear();
    return rows;
  }

 private:
  std::vector<double> samples_;
};

ON_RANKS(1, 3);

TEST(Channels, GivesTheRowsOfOneChannelToItsSubscriberOnce) {
  Pendulum pendulum;
  Channels channels({&pendulum});
  std::vector<double> energies;
  channels.subscribe("pendulum/energy", [&](const spectra::Series& channel, std::span<const double> rows) {
    EXPECT_EQ(channel.unit, "J");
    energies.insert(energies.end(), rows.begin(), rows.end());
  });
  pendulum.note(1);
  pendulum.note(2);
  channels.deliver();
  channels.deliver();
  pendulum.note(3);
  channels.deliver();
  EXPECT_EQ(energies, rank() == 0 ? (std::vector<double>{1, -1, 2, -2, 3, -3}) : std::vector<double>());
}

TEST(Channels, GivesEveryChannelToASubscriberOfAll) {
  Pendulum pendulum;
  Channels channels({&pendulum});
  std::vector<std::string> paths;
  channels.subscribe([&](const spectra::Series& channel, std::span<const double>) { paths.push_back(channel.path); });
  channels.deliver();
  EXPECT_THAT(paths, ElementsAre("/pendulum/angle", "/pendulum/energy"));
  EXPECT_EQ(channels.all().size(), 2U);
}

TEST(Channels, NamesTheNearestChannelWhenThereIsNoneOfThatName) {
  Pendulum pendulum;
  Channels channels({&pendulum});
  EXPECT_EQ(error_of([&] { channels.subscribe("/pendulum/angel", {}); }),
            "there is no channel /pendulum/angel (did you mean '/pendulum/angle'?)");
}

}  // namespace
}  // namespace idiophone::bodies
