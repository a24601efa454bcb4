// Impacts and loads of contacts.

#include "idiophone/instruments/touching/contact_track.hpp"

#include <gtest/gtest.h>

namespace idiophone::touching {

namespace {

constexpr double step = 1.0 / 60.0;

TEST(ContactTrack, WhatComesNewIsAnImpactAndWhatStaysALoad) {
  ContactTrack track;
  EXPECT_EQ(track.follow(0.3, step).impact, 0.3);
  ContactTrack::Share share;
  for (int i = 0; i < 60; ++i) {
    share = track.follow(0.02, step);
    EXPECT_EQ(share.impact, 0.0);
  }
  EXPECT_NEAR(share.load, 0.02 / step, 1e-3 * 0.02 / step);
}

TEST(ContactTrack, TheLoadGoesWithTheContact) {
  ContactTrack track;
  for (int i = 0; i < 30; ++i) {
    static_cast<void>(track.follow(0.02, step));
  }
  for (int i = 0; i < 7; ++i) {
    static_cast<void>(track.follow(0.0, step));
  }
  EXPECT_EQ(track.follow(0.0, step).load, 0.0);
}

/// A body that rests may touch and leave in turn: no impact in each step.
TEST(ContactTrack, TremblingIsNoMachineGun) {
  ContactTrack track;
  int impacts = 0;
  for (int i = 0; i < 600; ++i) {
    impacts += track.follow(i % 2 == 0 ? 0.02 : 0.0, step).impact > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(impacts, 1);
}

TEST(ContactTrack, BouncesAreImpacts) {
  ContactTrack track;
  int impacts = 0;
  double impulse = 1.0;
  for (int bounce = 0; bounce < 6; ++bounce, impulse *= 0.7) {
    impacts += track.follow(impulse, step).impact > 0.6 * impulse ? 1 : 0;
    for (int i = 0; i < 14; ++i) {
      static_cast<void>(track.follow(0.0, step));
    }
  }
  EXPECT_EQ(impacts, 6);
}

TEST(ContactTrack, AHarderBlowOnALoadedContactIsAnImpact) {
  ContactTrack track;
  for (int i = 0; i < 60; ++i) {
    static_cast<void>(track.follow(0.02, step));
  }
  EXPECT_NEAR(track.follow(0.5, step).impact, 0.48, 0.01);
}

}  // namespace

}  // namespace idiophone::touching
