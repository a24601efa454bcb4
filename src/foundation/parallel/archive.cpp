#include "idiophone/foundation/parallel/archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::parallel {

namespace {

template <class Value>
Value only_value(const std::string& name, const std::vector<Value>& values) {
  if (values.size() != 1) {
    throw std::runtime_error(fmt::format("archive: {} holds {} values instead of one", name, values.size()));
  }
  return values.front();
}

}  // namespace

void Archive::root(const std::string& name, double& value) {
  std::vector<double> values = {value};
  root(name, values);
  value = only_value(name, values);
}

void Archive::root(const std::string& name, std::int64_t& value) {
  std::vector<std::int64_t> values = {value};
  root(name, values);
  value = only_value(name, values);
}

void Archive::sum(const std::string& name, ReproducibleSum& share) {
  ReproducibleSum::Words words = share.words();
  if (!restoring()) {
    reduce(words, MPI_SUM, communicator_);
  }
  std::vector<std::int64_t> values(words.begin(), words.end());
  root(name, values);
  if (!restoring()) {
    return;
  }
  if (values.size() != words.size()) {
    throw std::runtime_error(
        fmt::format("archive: {} holds {} values instead of {}", name, values.size(), words.size()));
  }
  std::ranges::copy(values, words.begin());
  share = is_root(communicator_) ? ReproducibleSum::from_words(words) : ReproducibleSum();
}

std::size_t Archive::largest_width(std::size_t here) const {
  return largest(here, communicator_);
}

void ArchiveNames::exchange_rows(const std::string& name, const Rows& /*rows*/, int /*width*/,
                                 std::vector<double>& /*values*/) {
  add(name);
}

void ArchiveNames::exchange_root(const std::string& name, std::vector<double>& /*values*/) {
  add(name);
}

void ArchiveNames::exchange_root(const std::string& name, std::vector<std::int64_t>& /*values*/) {
  add(name);
}

void ArchiveNames::add(const std::string& name) {
  if (!names_.insert(name).second) {
    throw std::logic_error(fmt::format("archive: {} is named twice", name));
  }
}

}  // namespace idiophone::parallel
