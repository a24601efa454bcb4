#include "idiophone/run/bodies/contact_channels.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/results/contact_spread.hpp"

namespace idiophone::bodies {

namespace {

/// One channel of every contact.
struct ContactChannel {
  const char* name;
  const char* unit;
  std::vector<std::string> columns;
  const char* description;
};

const std::array<ContactChannel, 6>& contact_channels() {
  static const std::vector<std::string> xyz = {"x", "y", "z"};
  static const std::array<ContactChannel, 6> all = {{
      {"force", "N", xyz, "force on the first body, mean over the audio sample before"},
      {"point", "m", xyz, "where it acts, mean weighted by pressure; zero where nothing touches"},
      {"normal", "1", xyz, "unit vector from the partner to the first body, likewise"},
      {"slip", "m/s", xyz, "tangential velocity of the first body against the partner, likewise"},
      {"overlap", "m3", {"volume"}, "volume of the overlap, mean over the audio sample before"},
      {"spread", "m2", results::spread_column_names(),
       "covariance of the places where it acts, mean weighted by pressure"},
  }};
  return all;
}

constexpr std::size_t row_width = 19;

std::array<double, row_width> row(const contact::ContactMotion& motion) {
  std::array<double, row_width> row;
  auto* next = row.data();
  for (const Vector3& vector : {motion.force, motion.point, motion.normal, motion.slip}) {
    next = std::copy(vector.begin(), vector.end(), next);
  }
  *next++ = motion.overlap;
  std::ranges::copy(results::spread_row(motion.spread), next);
  return row;
}

std::vector<spectra::Series> contact_series(const scene::Scene& scene) {
  std::vector<spectra::Series> all;
  for (const auto& contact : scene.contacts) {
    for (const ContactChannel& channel : contact_channels()) {
      all.push_back({"/contacts/" + contact.name + "/" + channel.name,
                     channel.unit,
                     static_cast<double>(scene.audio.rate),
                     channel.columns,
                     channel.description,
                     {}});
    }
  }
  return all;
}

}  // namespace

ContactChannels::ContactChannels(const scene::Scene& scene, motion::Motion& motion, MPI_Comm communicator)
    : ChannelGroup(contact_series(scene)), motion_(motion), communicator_(communicator), rows_(scene.contacts.size()) {}

void ContactChannels::note(std::int64_t sample) {
  for (std::size_t c = 0; c < rows_.size() && sample > 0; ++c) {
    const auto next = row(motion_.contacts().motion(c));
    rows_[c].insert(rows_[c].end(), next.begin(), next.end());
  }
}

std::vector<std::vector<double>> ContactChannels::collect() {
  std::vector<std::vector<double>> series;
  for (std::vector<double>& noted : rows_) {
    // All ranks but the one that reports the contact have zeros: the sum is exact.
    parallel::sum_on_root(std::span(noted), communicator_);
    const std::vector<double> rows =
        parallel::is_root(communicator_) ? std::exchange(noted, {}) : std::vector<double>{};
    noted.clear();
    std::size_t first = 0;
    for (const ContactChannel& channel : contact_channels()) {
      auto& values = series.emplace_back();
      for (std::size_t begin = first; begin < rows.size(); begin += row_width) {
        const auto columns = std::span(rows).subspan(begin, channel.columns.size());
        values.insert(values.end(), columns.begin(), columns.end());
      }
      first += channel.columns.size();
    }
  }
  return series;
}

}  // namespace idiophone::bodies
