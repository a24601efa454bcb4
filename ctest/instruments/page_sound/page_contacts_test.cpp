#include "page_contacts.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace idiophone::page_sound {

namespace {

constexpr int samples_per_second = 48000;
constexpr double duration = 1.0 / 240.0;

touching::ContactEvent impact(std::uint64_t contact, double impulse) {
  return {.contact = contact, .normal = {0, 0, 1}, .impulse = impulse, .mass = 0.1, .moment = 0.5};
}

PageContacts contacts(std::size_t most_forces) {
  return {{touching::Surface{}}, samples_per_second, 2, most_forces, 1};
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

TEST(PageContacts, WhatSlidesComesBeforeImpacts) {
  PageContacts sliding = contacts(1);
  touching::ContactEvent slide = impact(7, 0.01);
  slide.slip = {0.4, 0, 0};
  int strokes = 0;
  for (int step = 0; step < 48; ++step) {
    const auto forces = sliding.step(std::vector{slide, impact(100 + step, 1.0)}, step * 200, duration);
    ASSERT_EQ(forces.size(), 1);
    strokes += forces[0].impulse == std::numeric_limits<double>::infinity() ? 1 : 0;
  }
  EXPECT_GE(strokes, 17);  // a piece in each 512 of 9600 audio samples, after the first step
}

}  // namespace idiophone::page_sound
