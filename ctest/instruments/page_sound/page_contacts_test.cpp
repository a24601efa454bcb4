#include "page_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace idiophone::page_sound {

namespace {

constexpr int samples_per_second = 48000;
constexpr double duration = 1.0 / 240.0;

touching::ContactEvent impact(std::uint64_t contact, double impulse) {
  return {.contact = contact, .normal = {0, 0, 1}, .impulse = impulse, .mass = 0.1, .moment = 0.5};
}

PageContacts contacts(std::size_t most_impacts) {
  return {{touching::Surface{}}, samples_per_second, 4, most_impacts, 1};
}

bool is_stroke(const touching::ContactForce& force) {
  return force.impulse == std::numeric_limits<double>::infinity();
}

}  // namespace

TEST(PageContacts, LeavesOutTheWeakestImpacts) {
  std::vector<touching::ContactEvent> events;
  for (const double impulse : {0.3, 0.1, 0.5, 0.2, 0.4}) {
    events.push_back(impact(events.size(), impulse));
  }
  const auto forces = contacts(3).step(events, 100, duration);
  ASSERT_EQ(forces.size(), 3);
  EXPECT_EQ(forces[0].impulse, 0.5);
  EXPECT_EQ(forces[1].impulse, 0.4);
  EXPECT_EQ(forces[2].impulse, 0.3);
  EXPECT_EQ(forces[0].force.start, 200);  // in the middle of the step
  EXPECT_EQ(contacts(9).step(events, 100, duration).size(), 5);
}

TEST(PageContacts, StrokesAndImpactsAreLimitedApart) {
  PageContacts sliding = contacts(1);
  std::ptrdiff_t pieces = 0;
  for (int step = 0; step < 48; ++step) {
    std::vector<touching::ContactEvent> events{impact(100 + 2 * step, 1.0), impact(101 + 2 * step, 2.0)};
    for (std::uint64_t contact = 0; contact < 6; ++contact) {  // more than may slide at once
      events.push_back(impact(contact, 0.01));
      events.back().slip = {0.4, 0, 0};
    }
    const auto forces = sliding.step(events, step * 800, 4 * duration);  // more than a piece of 512 audio samples
    const auto strokes = std::ranges::count_if(forces, is_stroke);
    if (step > 0) {  // when what slides begins, it hits
      ASSERT_EQ(std::ssize(forces), strokes + 1);
      EXPECT_EQ(forces.back().impulse, 2.0);
    }
    pieces += strokes;
  }
  EXPECT_NEAR(static_cast<double>(pieces), 4 * 47 * 800 / 512.0, 4);
}

TEST(PageContacts, LeavesOutWhatHasNoMass) {
  std::vector<touching::ContactEvent> events;
  for (const double mass : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0.0,
                            touching::ContactEvent::unknown, 0.1}) {
    events.push_back(impact(events.size(), 0.1 + 0.1 * static_cast<double>(events.size())));
    events.back().mass = mass;
  }
  const auto forces = contacts(9).step(events, 0, duration);
  ASSERT_EQ(forces.size(), 1);
  EXPECT_EQ(forces[0].impulse, 0.5);
}

}  // namespace idiophone::page_sound
