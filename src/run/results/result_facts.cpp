// Facts in a result, such as the description of the run: /run.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "result_state.hpp"

namespace idiophone::results {

namespace {

void write_facts(hid_t file, const std::string& path, const nlohmann::json& facts, MPI_Comm communicator) {
  const auto group = hdf5::open_group(file, path);
  for (const auto& [key, fact] : facts.items()) {
    if (fact.is_object()) {
      write_facts(file, fmt::format("{}/{}", path, key), fact, communicator);
    } else if (fact.is_array()) {
      const auto numbers = fact.get<std::vector<double>>();
      files::write_from_rank_0(file, fmt::format("{}/{}", path, key), std::span<const double>(numbers), communicator);
    } else if (fact.is_number_integer()) {
      hdf5::put(group.id(), key, fact.get<std::int64_t>());
    } else if (fact.is_number()) {
      hdf5::put(group.id(), key, fact.get<double>());
    } else if (const auto text = fact.get<std::string>(); text.find('\n') != std::string::npos) {
      hdf5::put_dataset(file, fmt::format("{}/{}", path, key), {text}, communicator);
    } else {
      hdf5::put(group.id(), key, text);
    }
  }
}

}  // namespace

void ResultFile::note(const std::string& group, const nlohmann::json& facts) {
  MPI_Comm communicator = state_->communicator;
  std::string bytes;  // CBOR, because names of files need not be UTF-8, as JSON would have to be
  if (parallel::is_root(communicator)) {
    nlohmann::json::to_cbor(facts, bytes);
  }
  parallel::broadcast(bytes, communicator);
  const auto file = state_->opened();
  parallel::collectively(communicator,
                         [&] { write_facts(file, group, nlohmann::json::from_cbor(bytes), communicator); });
}

std::string ResultFile::add_job(const nlohmann::json& facts) {
  const auto file = state_->opened();
  std::string group;
  parallel::collectively(state_->communicator, [&] {
    group = fmt::format("/run/jobs/{:03}", hdf5::entries_of(hdf5::open_group(file, "/run/jobs").id()).size());
  });
  note(group, facts);
  return group;
}

}  // namespace idiophone::results
