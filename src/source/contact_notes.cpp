#include "idiophone/source/contact_notes.hpp"

#include <array>
#include <span>

namespace idiophone::source {

namespace {

/// One series of every contact.
struct Channel {
  const char* name;
  const char* unit;
  std::vector<std::string> columns;
  const char* description;
};

const std::array<Channel, 5>& channels() {
  static const std::vector<std::string> xyz = {"x", "y", "z"};
  static const std::array<Channel, 5> all = {{
      {"force", "N", xyz, "force on the first body, mean over the audio sample before"},
      {"point", "m", xyz, "where it acts, mean weighted by pressure; zero where nothing touches"},
      {"normal", "1", xyz, "unit vector from the partner to the first body, likewise"},
      {"slip", "m/s", xyz, "tangential velocity of the first body against the partner, likewise"},
      {"overlap", "m3", {"volume"}, "volume of the overlap, mean over the audio sample before"},
  }};
  return all;
}

constexpr std::size_t row_width = 13;

std::array<double, row_width> row(const contact::ContactMotion& motion) {
  std::array<double, row_width> row;
  auto* next = row.data();
  for (const Vector3& vector : {motion.force, motion.point, motion.normal, motion.slip}) {
    next = std::copy(vector.begin(), vector.end(), next);
  }
  *next = motion.overlap;
  return row;
}

}  // namespace

ContactNotes::ContactNotes(const Preparation& ready, MPI_Comm communicator)
    : ready_(ready), communicator_(communicator), notes_(ready.scene.contacts.size()) {}

void ContactNotes::declare(store::ResultFile& result) const {
  for (const auto& contact : ready_.scene.contacts) {
    for (const Channel& channel : channels()) {
      result.declare({"/contacts/" + contact.name + "/" + channel.name,
                      channel.unit,
                      static_cast<double>(ready_.scene.audio.rate),
                      channel.columns,
                      channel.description,
                      {}});
    }
  }
}

void ContactNotes::note(std::int64_t sample, motion::Motion& motion) {
  for (std::size_t c = 0; c < notes_.size() && sample > 0; ++c) {
    const auto next = row(motion.contacts().motion(c));
    notes_[c].insert(notes_[c].end(), next.begin(), next.end());
  }
}

void ContactNotes::write(store::ResultFile& result) {
  for (std::size_t c = 0; c < notes_.size(); ++c) {
    // All ranks but the one that speaks for the contact have zeros: the sum is exact.
    std::vector<double> rows(notes_[c].size());
    MPI_Reduce(notes_[c].data(), rows.data(), static_cast<int>(rows.size()), MPI_DOUBLE, MPI_SUM, 0, communicator_);
    notes_[c].clear();
    std::size_t first = 0;
    for (const Channel& channel : channels()) {
      std::vector<double> series;
      for (std::size_t begin = first; begin < rows.size(); begin += row_width) {
        series.insert(series.end(), rows.begin() + static_cast<std::ptrdiff_t>(begin),
                      rows.begin() + static_cast<std::ptrdiff_t>(begin + channel.columns.size()));
      }
      first += channel.columns.size();
      result.append("/contacts/" + ready_.scene.contacts[c].name + "/" + channel.name, series);
    }
  }
}

}  // namespace idiophone::source
