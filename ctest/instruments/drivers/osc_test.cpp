#include "idiophone/instruments/drivers/osc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <lo/lo.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "idiophone/instruments/drivers/players.hpp"
#include "osc_packet.hpp"

namespace idiophone::drivers {

namespace {

class Osc : public testing::Test {
 protected:
  /// Waits until messages were handled.
  void poll() {
    const std::size_t before = handled();
    for (int i = 0; i < 1000 && handled() == before; ++i) {
      server.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] std::size_t handled() const {
    return played.size() + moved.size() + begun.size() + led.size() + server.refused();
  }

  std::vector<score::ScoreEvent> played;
  std::vector<Vector3> moved;
  std::vector<std::pair<std::string, score::ScoreEvent>> begun;
  std::vector<std::string> led;
  OscServer server{"127.0.0.1",
                   0,  // tests run beside each other, so each takes a free port
                   {"bar", "bowl"},
                   {.play = [this](const score::ScoreEvent& event) { played.push_back(event); },
                    .begin_stroke = [this](const std::string& name,
                                           const score::ScoreEvent& event) { begun.emplace_back(name, event); },
                    .change_stroke = [this](const std::string& name, double speed,
                                            double load) { led.push_back(fmt::format("{} {} {}", name, speed, load)); },
                    .end_stroke = [this](const std::string& name) { led.push_back(name + " ends"); },
                    .move_listener = [this](const Vector3& place) { moved.push_back(place); }}};
  lo_address here = lo_address_new("127.0.0.1", std::to_string(server.port()).c_str());
};

TEST_F(Osc, PlaysABlow) {
  lo_send(here, "/blow", "sfffffffff", "bowl", 0.5, 0.25, 0.0, 0.0, 0.0, -2.0, 0.125, 1e8, 1.5);
  poll();
  ASSERT_EQ(played.size(), 1U);
  EXPECT_EQ(played[0].body, 1U);
  const auto& blow = std::get<score::HammerBlow>(played[0].action);
  EXPECT_EQ(blow.at, Vector3(0.5, 0.25, 0.0));
  EXPECT_EQ(blow.direction, Vector3(0.0, 0.0, -1.0));
  EXPECT_EQ(blow.hammer.mass, 0.125);
  EXPECT_EQ(blow.hammer.hardness, 1e8);
  EXPECT_EQ(blow.hammer.speed, 1.5);
}

TEST_F(Osc, PlaysAnEventInYaml) {
  lo_send(here, "/event", "s",
          "{type: force, body: bar, at: [0, 0, 0], force: [0, 0, 1], shape: half_sine, duration: 1e-3}");
  poll();
  ASSERT_EQ(played.size(), 1U);
  EXPECT_EQ(std::get<score::AppliedForce>(played[0].action).signal.duration, 1e-3);
}

TEST_F(Osc, Bows) {
  lo_send(here, "/bow", "sfffffffffff", "bowl", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 2.0, 0.75, 0.25, 3.0);
  poll();
  ASSERT_EQ(played.size(), 1U);
  const auto& bow = std::get<score::Bow>(played[0].action);
  EXPECT_EQ(bow.direction, Vector3::UnitY());
  EXPECT_EQ(bow.speed.at(0.0), 0.5);
  EXPECT_EQ(bow.load.at(0.0), 2.0);
  EXPECT_EQ(bow.friction.sticking, 0.75);
  EXPECT_EQ(bow.friction.sliding, 0.25);
  EXPECT_EQ(bow.duration, 3.0);
  lo_send(here, "/bow/begin", "ssffffffffff", "finger", "bowl", 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 2.0, 0.75, 0.25);
  poll();
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(begun[0].first, "finger");
  EXPECT_TRUE(std::holds_alternative<score::Bow>(begun[0].second.action));
}

TEST_F(Osc, ScrapesAndRolls) {
  lo_send(here, "/scrape", "sffffffffffffffff", "bar", 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.5, 2.0, 0.125,
          1e8, 1e-3, 0.25, 0.5);
  poll();
  ASSERT_EQ(played.size(), 1U);
  EXPECT_EQ(std::get<score::Stroke>(played[0].action).friction, 0.5);
  EXPECT_EQ(std::get<score::Stroke>(played[0].action).roughness.height, 0.25);
  EXPECT_NO_THROW(static_cast<void>(event_text("/roll", OscArguments(16, "1"))));
}

TEST_F(Osc, LeadsAStroke) {
  lo_send(here, "/roll/begin", "ssfffffffffffffff", "left hand", "bar", 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0,
          0.5, 2.0, 0.125, 1e8, 1e-3, 0.25);
  poll();
  ASSERT_EQ(begun.size(), 1U);
  EXPECT_EQ(begun[0].first, "left hand");
  EXPECT_EQ(std::get<score::Stroke>(begun[0].second.action).load, 2.0);
  lo_send(here, "/stroke/change", "sff", "left hand", 0.25, 3.5);
  poll();
  lo_send(here, "/stroke/end", "s", "left hand");
  poll();
  EXPECT_EQ(led, (std::vector<std::string>{"left hand 0.25 3.5", "left hand ends"}));
  lo_send(here, "/stroke/change", "ssf", "left hand", "fast", 3.5);
  poll();
  lo_send(here, "/stroke/end", "");
  poll();
  lo_send(here, "/roll/begin", "");
  poll();
  EXPECT_EQ(server.refused(), 3U);
}

TEST_F(Osc, TunesABody) {
  lo_send(here, "/tune", "sff", "bowl", 0.5, 4.0);
  poll();
  ASSERT_EQ(played.size(), 1U);
  EXPECT_EQ(played[0].body, 1U);
  EXPECT_EQ(std::get<score::Tuning>(played[0].action).size, 0.5);
  EXPECT_EQ(std::get<score::Tuning>(played[0].action).friction, 4.0);
}

TEST_F(Osc, MovesTheListener) {
  lo_send(here, "/listener", "ffi", 0.5, 0.25, 3);
  poll();
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0], Vector3(0.5, 0.25, 3.0));
}

TEST_F(Osc, RefusesWhatIsWrong) {
  lo_send(here, "/blow", "sf", "bowl", 0.5);
  poll();
  lo_send(here, "/bolw", "s", "bowl");
  poll();
  lo_send(here, "/listener", "ff", 0.0, 0.0);
  poll();
  lo_send(here, "/listener", "sff", "nan", 0.0, 0.0);
  poll();
  lo_send(here, "/blow", "sfffffffff", "plate", 0.5, 0.25, 0.0, 0.0, 0.0, -2.0, 0.125, 1e8, 1.5);
  poll();
  lo_send(here, "/event", "s", "{type: blow, body: [");
  poll();
  lo_send(here, "/event", "s", "{type: blow, body: bar, time: 3}");
  poll();
  EXPECT_EQ(server.refused(), 7U);
  EXPECT_EQ(played.size() + moved.size(), 0U);
}

TEST_F(Osc, RefusesAPortInUse) {
  EXPECT_THROW(OscServer("127.0.0.1", server.port(), {}, {}), std::runtime_error);
  EXPECT_THROW(OscServer("my computer", 0, {}, {}), std::runtime_error);
}

/// The local address of a UDP port in /proc/net/udp.
std::string address_of(int port) {
  std::ifstream table("/proc/net/udp");
  for (std::string line; std::getline(table, line);) {
    const std::size_t place = line.find(fmt::format(":{:04X} ", port));
    if (place != std::string::npos && place < 20) {
      return line.substr(place - 8, 8);
    }
  }
  return "";
}

TEST_F(Osc, IsClosedToTheNetworkUnlessToldOtherwise) {
  EXPECT_EQ(address_of(server.port()), "0100007F");
  const OscServer open("0.0.0.0", 0, {}, {});
  EXPECT_EQ(address_of(open.port()), "00000000");
}

TEST_F(Osc, HandlesFewMessagesOfAFloodAtOnce) {
  for (int i = 0; i < 150; ++i) {
    lo_send(here, "/stroke/end", "s", "hand");
  }
  server.poll();
  EXPECT_LE(handled(), OscServer::most_packets);
  for (int i = 0; i < 10; ++i) {
    server.poll();
  }
  EXPECT_EQ(handled(), 150U) << "none of them is lost";
}

TEST_F(Osc, HandlesBundlesAndRefusesDamagedOnes) {
  const auto packet = [](std::string bytes) {
    std::vector<std::string> paths;
    read_osc_packet(bytes, [&](const std::string& path, const OscArguments& arguments) {
      paths.push_back(fmt::format("{} {}", path, fmt::join(arguments, " ")));
    });
    return paths;
  };
  const std::string message("/a\0\0,is\0\0\0\0\5hand\0\0\0\0", 20), head("#bundle\0\0\0\0\0\0\0\0\1", 16);
  const std::string size("\0\0\0\x14", 4);
  EXPECT_EQ(packet(message), std::vector<std::string>{"/a 5 hand"});
  const std::string bundle = head + size + message + size + message;
  EXPECT_EQ(packet(bundle).size(), 2U);
  const std::string nested = head + std::string("\0\0\0\x40", 4) + bundle;
  EXPECT_EQ(packet(nested).size(), 2U);
  for (const std::string& wrong : {std::string(), std::string("/a"), message.substr(0, 7), head + size,
                                   head + std::string("\xff\xff\xff\xff", 4) + message, head + std::string(4, '\0')}) {
    EXPECT_THROW((void)packet(wrong), std::runtime_error);
  }
  std::string many = head;
  for (int i = 0; i < 200; ++i) {
    many += size + message;
  }
  EXPECT_THROW((void)packet(many), std::runtime_error);
  std::string deep = message;
  for (int i = 0; i < 20; ++i) {
    deep = head + std::string("\0\0", 2) + static_cast<char>(deep.size() / 256) + static_cast<char>(deep.size() % 256) +
           deep;
  }
  EXPECT_THROW((void)packet(deep), std::runtime_error);
}

TEST_F(Osc, ReadsNoFileThatTheNetworkNames) {
  lo_send(here, "/event", "s",
          "{type: force, body: bar, at: [0, 0, 0], force: [0, 0, 1], shape: table, table: /etc/hosts}");
  testing::internal::CaptureStdout();
  poll();
  EXPECT_EQ(played.size(), 0U);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), testing::HasSubstr("can't name files"));
}

/// Messages of a player until all have come in.
std::vector<Event> events_of(OscPlayer& player, std::int64_t now) {
  std::vector<Event> events;
  for (int i = 0; i < 20; ++i) {
    player.ask(now, now + 512, events);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return events;
}

TEST(OscPlayer, AsksForNoMoreForceThanFitsIntoMemory) {
  constexpr int slow_rate = 8000;
  OscPlayer player("127.0.0.1", 0, {"bar"}, 1, slow_rate);
  const lo_address there = lo_address_new("127.0.0.1", std::to_string(player.port()).c_str());
  const auto scrape = [&] {  // for 25 s
    lo_send(there, "/scrape", "sffffffffffffffff", "bar", 0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01, 2.0,
            0.125, 1e8, 1e-3, 1e-6, 0.5);
  };
  for (int i = 0; i < 40; ++i) {
    scrape();
  }
  EXPECT_EQ(events_of(player, 0).size(), 2U);
  EXPECT_EQ(player.complaint(), "38 OSC messages were wrong and left out");
  scrape();
  EXPECT_EQ(events_of(player, 26 * slow_rate).size(), 1U) << "those before are over";
  lo_address_free(there);
}

}  // namespace

}  // namespace idiophone::drivers
