#include "idiophone/instruments/resonators/elastic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "touching_bodies.hpp"

namespace idiophone::resonators {

namespace {

scene::Course always(double gap) {
  return {.points = {{.time = 0.0, .value = gap}}};
}

/// A mode that is too slow to swing while something touches it.
std::vector<TouchedMode> movable(double mass) {
  return {{.frequency = 0.01, .decay = 0.0, .participation = 1.0 / std::sqrt(mass)}};
}

std::vector<TouchedMode> undamped_modes(int count, double lowest) {
  std::vector<TouchedMode> modes;
  for (int n = 1; n <= count; ++n) {
    modes.push_back({.frequency = lowest * n * std::sqrt(n), .decay = 0.0, .participation = 6.0 * std::cos(n)});
  }
  return modes;
}

/// At another place, the modes take part in another way.
std::vector<double> elsewhere(int place) {
  std::vector<double> times;
  for (int n = 0; n < 40; ++n) {
    times.push_back(std::cos(0.7 * place * n));
  }
  return times;
}

constexpr ElasticContact::Mass stop{};

}  // namespace

TEST(ElasticContact, HasThePeriodOfABilinearOscillator) {
  // Half a period on the spring of the mode, the other half on that and the stop: exact.
  constexpr double frequency = 100.0, participation = 3.0, stiffness = 2e5;
  ElasticContact contact({.hardness = stiffness, .exponent = 1.0}, always(0.0), stop, rate);
  TouchingBodies body({{{.frequency = frequency, .decay = 0.0, .participation = participation}}});
  body.add(contact, {{.body = 0}});
  body.push(0, 0.01);
  std::vector<double> onsets;  // s
  for (int sample = 0; sample < rate && onsets.size() < 42; ++sample) {
    const double before = contact.approach();
    body.advance(1);
    if (before <= 0.0 && contact.approach() > 0.0) {
      onsets.push_back((sample - before / (contact.approach() - before)) / rate);
    }
  }
  ASSERT_EQ(onsets.size(), 42U);
  const double angular = 2.0 * std::numbers::pi * frequency;
  const double stiffer = std::sqrt(angular * angular + stiffness * participation * participation);
  const double period = std::numbers::pi / angular + std::numbers::pi / stiffer;
  EXPECT_NEAR((onsets[41] - onsets[1]) / 40.0, period, 1e-4 * period);
}

TEST(ElasticContact, LetsTwoBodiesBounceOffAsHertzFound) {
  constexpr double first = 0.02, second = 0.03, speed = 0.5;
  const double reduced = first * second / (first + second);
  const score::Hammer hammer{.mass = reduced, .hardness = 1e5, .speed = speed};
  for (const double loss : {0.0, 0.02}) {
    ElasticContact contact({.hardness = hammer.hardness, .loss = loss}, always(1e-3), stop, rate);
    TouchingBodies bodies({movable(first), movable(second)});
    bodies.add(contact, {{.body = 0, .times = {-1.0}}, {.body = 1}});
    bodies.push(0, first * speed);
    int touching = 0;
    for (int sample = 0; sample < rate / 50; ++sample) {
      bodies.advance(1);
      touching += contact.approach() > 0.0 ? 1 : 0;
    }
    const double after = bodies.velocity(1) - bodies.velocity(0);
    EXPECT_NEAR(first * bodies.velocity(0) + second * bodies.velocity(1), first * speed, 2e-5 * first * speed);
    EXPECT_NEAR(after / speed, 1.0 - 2.0 / 3.0 * loss * speed, 2e-4) << "Hunt and Crossley, for small losses";
    EXPECT_NEAR(static_cast<double>(touching) / rate / hammer.contact_duration(), 1.0, 0.01);
  }
}

TEST(ElasticContact, NeverCreatesEnergy) {
  constexpr double rivet = 2e-3;  // kg
  for (const double loss : {0.0, 0.3}) {
    ElasticContact between({.hardness = 1e8, .loss = loss}, always(2e-6), stop, rate);
    ElasticContact beside({.hardness = 1e9, .loss = loss}, always(0.0), stop, rate);
    ElasticContact beneath({.hardness = 1e6, .exponent = 1.0, .loss = loss}, always(1e-5), stop, rate);
    ElasticContact on_top({.hardness = 1e7, .loss = loss}, always(1e-6), {.mass = rivet}, rate);
    TouchingBodies bodies({undamped_modes(40, 90.0), undamped_modes(25, 210.0)});
    bodies.add(between, {{.body = 0}, {.body = 1, .times = elsewhere(1)}});
    bodies.add(beside, {{.body = 0, .times = elsewhere(2)}, {.body = 1, .times = elsewhere(3)}});
    bodies.add(beneath, {{.body = 1}});
    bodies.add(on_top, {{.body = 0, .times = elsewhere(4)}});
    bodies.push(0, 0.02);
    const auto stored = [&] {
      return between.stored_energy() + beside.stored_energy() + beneath.stored_energy() + on_top.stored_energy();
    };
    const auto energy = [&] { return bodies.energy() + stored() + 0.5 * rivet * on_top.speed() * on_top.speed(); };
    const double whole = energy();
    double before = whole, most_stored = 0.0;
    for (int sample = 0; sample < 4000; ++sample) {
      bodies.advance(1);
      ASSERT_LE(energy(), before + 1e-13 * whole) << sample;
      before = energy();
      most_stored = std::max(most_stored, stored());
    }
    EXPECT_GT(most_stored, 0.01 * whole);
    if (loss == 0.0) {
      EXPECT_NEAR(before, whole, 1e-12 * whole);
    }
  }
}

TEST(ElasticContact, KeepsTheEnergyOfManyStiffContactsAtNearlyTheSamePlace) {
  std::vector<std::unique_ptr<ElasticContact>> contacts;
  TouchingBodies bodies({undamped_modes(40, 90.0), undamped_modes(25, 210.0)});
  for (int i = 0; i < 8; ++i) {
    contacts.push_back(
        std::make_unique<ElasticContact>(score::Elasticity{.hardness = 1e11}, always(1e-7 * i), stop, rate));
    bodies.add(*contacts.back(), {{.body = 0, .times = {1.0 + 1e-3 * i}}, {.body = 1}});
  }
  bodies.push(0, 0.02);
  const auto energy = [&] {
    double sum = bodies.energy();
    for (const auto& contact : contacts) {
      sum += contact->stored_energy();
    }
    return sum;
  };
  const double whole = energy();
  double most_off = 0.0;
  for (int sample = 0; sample < 1000; ++sample) {
    bodies.advance(1);
    most_off = std::max(most_off, std::abs(energy() - whole));
  }
  EXPECT_LT(most_off, 1e-11 * whole);
}

TEST(ElasticContact, PressesAsTheGapSays) {
  // A stop comes near slowly and stays: spring of the mode and spring of the stop share the way.
  constexpr double frequency = 200.0, participation = 3.0, stiffness = 1e5, way = 1e-4;
  const scene::Course gap{.points = {{.time = 0.0, .value = 1e-5}, {.time = 0.2, .value = -way}}};
  ElasticContact contact({.hardness = stiffness, .exponent = 1.0}, gap, stop, rate);
  TouchingBodies body({{{.frequency = frequency, .decay = 60.0, .participation = participation}}});
  body.add(contact, {{.body = 0}});
  body.advance(rate / 2);
  const double compliance = std::pow(participation / (2.0 * std::numbers::pi * frequency), 2);
  EXPECT_NEAR(contact.approach(), way / (1.0 + stiffness * compliance), 1e-4 * way);
}

TEST(ElasticContact, GivesTheWorkOfTheGap) {
  constexpr double speed = 0.05;
  const scene::Course gap{.points = {{.time = 0.01, .value = 1e-4}, {.time = 0.02, .value = 1e-4 - speed * 0.01}}};
  ElasticContact contact({.hardness = 1e7}, gap, stop, rate);
  Witness witness(contact);
  TouchingBodies body({undamped_modes(20, 90.0)});
  body.add(witness, {{.body = 0}});
  body.advance(rate / 50);
  double work = 0.0;
  for (const double force : witness.force_on_body) {
    work += force * speed / rate;
  }
  EXPECT_GT(work, 0.0);
  EXPECT_NEAR(body.energy() + contact.stored_energy(), work, 1e-12 * work);
}

TEST(ElasticContact, BeginsWithoutAJump) {
  // The force of a negative gap rises over 10 ms.
  ElasticContact contact({.hardness = 1e8}, always(-1e-4), stop, rate);
  double before = 0.0, most_change = 0.0, last = 0.0;
  for (int sample = 0; sample < rate / 50; ++sample) {
    last = contact.force(0.0, 0.0);
    contact.advance(0.0, last);
    most_change = std::max(most_change, std::abs(last - before));
    before = last;
  }
  EXPECT_NEAR(last, 1e8 * std::pow(1e-4, 1.5), 1e-9);
  EXPECT_LT(most_change, 5e-3 * last);
}

TEST(ElasticContact, LetsALooseMassFallAndBounce) {
  constexpr double mass = 2e-3, load = 0.02, height = 1e-4, ramp = 0.01;
  ElasticContact contact({.hardness = 1e8}, always(height), {.mass = mass, .load = load}, rate);
  const auto advance = [&] { contact.advance(0.0, contact.force(0.0, 0.0)); };
  int fall = 0;
  for (; contact.approach() <= 0.0 && fall < rate; ++fall) {
    advance();
  }
  EXPECT_NEAR(static_cast<double>(fall) / rate, std::cbrt(6.0 * height * mass * ramp / load), 2.0 / rate)
      << "the load rises evenly";
  const auto energy = [&] {
    return 0.5 * mass * contact.speed() * contact.speed() + contact.stored_energy() - load * contact.approach();
  };
  while (fall++ < ramp * rate) {
    advance();
  }
  const double whole = energy();
  double highest = 0.0;
  for (int sample = 0; sample < rate / 5; ++sample) {
    advance();
    ASSERT_NEAR(energy(), whole, 1e-12 * whole);
    highest = std::max(highest, -contact.approach());
  }
  EXPECT_NEAR(highest, whole / load, 1e-3 * height);
  EXPECT_FALSE(contact.is_at_rest());
}

}  // namespace idiophone::resonators
