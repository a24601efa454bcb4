#include "idiophone/run/bodies/observation.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::bodies {

namespace {

constexpr std::size_t words_per_sum = std::tuple_size_v<ReproducibleSum::Words>;

}  // namespace

double Observation::kinetic() const {
  double sum = 0.0;
  for (const motion::BodyMotion& body : bodies) {
    sum += body.kinetic;
  }
  return sum;
}

double Observation::elastic() const {
  double sum = 0.0;
  for (const motion::BodyMotion& body : bodies) {
    sum += body.elastic;
  }
  return sum;
}

double Observation::energy() const {
  return kinetic() + elastic() + contact + joint + gravitational;
}

void append(std::vector<std::int64_t>& words, const ReproducibleSum& sum) {
  const ReproducibleSum::Words own = sum.words();
  words.insert(words.end(), own.begin(), own.end());
}

ReproducibleSum take_sum(std::span<const std::int64_t>& words) {
  ReproducibleSum::Words first;
  std::ranges::copy(words.first(words_per_sum), first.begin());
  words = words.subspan(words_per_sum);
  return ReproducibleSum::from_words(first);
}

std::vector<std::int64_t> observation_words(const Preparation& ready, motion::Motion& motion) {
  std::vector<std::int64_t> row;
  const auto put = [&](const ReproducibleSum& sum) { append(row, sum); };
  for (const motion::BodySums& sums : motion::measure(motion, ready.initial_state)) {
    motion::BodySums::for_each(sums, put);
  }
  ReproducibleSum contact;
  for (std::size_t c = 0; c < motion.contacts().count(); ++c) {
    contact.add(motion.contacts().energy(c));
  }
  ReproducibleSum joint;
  motion.dynamics().acting_joints().add_energy(motion.state(), joint);
  put(contact);
  put(joint);
  put(motion.work());
  return row;
}

std::size_t words_per_observation(const Preparation& ready) {
  const std::size_t measured = ready.scene.bodies.size() + ready.initial_state.pieces.size();
  return words_per_sum * (motion::BodySums::count * measured + 3);
}

std::vector<std::int64_t> sum_over_ranks(const std::vector<std::int64_t>& words, MPI_Comm communicator) {
  std::vector<std::int64_t> sums = words;
  parallel::sum_on_root(std::span(sums), communicator);
  return parallel::is_root(communicator) ? sums : std::vector<std::int64_t>{};
}

Observation observation(const Preparation& ready, std::span<const std::int64_t> words) {
  const auto take = [&] {
    motion::BodySums sums;
    motion::BodySums::for_each(sums, [&](ReproducibleSum& sum) { sum = take_sum(words); });
    return sums;
  };
  Observation seen;
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    seen.bodies.push_back(motion::body_motion(take(), ready.initial_state, b));
    seen.gravitational -= ready.initial_state.masses[b] * seen.bodies.back().centre.dot(ready.scene.gravity);
  }
  for (std::size_t p = 0; p < ready.initial_state.pieces.size(); ++p) {
    seen.pieces.push_back(motion::piece_motion(take(), ready.initial_state, p));
  }
  seen.contact = take_sum(words).value();
  seen.joint = take_sum(words).value();
  seen.work = take_sum(words).value();
  return seen;
}

Observation observe(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator) {
  const std::vector<std::int64_t> sums = sum_over_ranks(observation_words(ready, motion), communicator);
  return sums.empty() ? Observation{} : observation(ready, sums);
}

}  // namespace idiophone::bodies
