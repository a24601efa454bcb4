#include "idiophone/run/results/checkpoint_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <functional>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"

namespace idiophone::results {

namespace {

const std::string name_begin = "checkpoint_";
const std::string name_end = ".h5";

}  // namespace

std::string checkpoint_name(std::int64_t step) {
  return fmt::format("{}{:012}{}", name_begin, step, name_end);
}

std::optional<std::int64_t> step_of(const std::filesystem::path& name) {
  const auto text = name.filename().string();
  if (!text.starts_with(name_begin) || !text.ends_with(name_end)) {
    return {};
  }
  std::int64_t step = 0;
  const auto digits = std::span(text).subspan(name_begin.size(), text.size() - name_begin.size() - name_end.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), step);
  return error == std::errc() && checkpoint_name(step) == text ? std::optional(step) : std::nullopt;
}

std::vector<std::filesystem::path> list_checkpoints(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> found;
  if (std::filesystem::is_directory(directory)) {
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
      if (step_of(entry.path())) {
        found.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(found, std::greater<>(), [](const auto& path) { return step_of(path); });
  return found;
}

std::uint32_t end_marker(const Identity& identity, const Moment& moment, const Checksums& checksums) {
  auto text = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n", files::version_of(files::checkpoint_format), moment.step,
                          moment.sample, identity.code_version, identity.mesh_hash, identity.deck_text,
                          fmt::join(identity.overrides, "\n"));
  for (const auto& [path, sum] : checksums) {
    text += fmt::format("{} {:08x}\n", path, sum);
  }
  return files::checksum(std::as_bytes(std::span(text)));
}

void write_header(hid_t file, const Identity& identity, const Moment& moment, MPI_Comm communicator) {
  hdf5::put(file, "format", files::checkpoint_format);
  hdf5::put(file, "format_version", files::version_of(files::checkpoint_format));
  hdf5::put(file, "code_version", identity.code_version);
  hdf5::put(file, "mesh_hash", identity.mesh_hash);
  hdf5::put(file, "step", moment.step);
  hdf5::put(file, "sample", moment.sample);
  hdf5::put_dataset(file, "/deck", {identity.deck_text}, communicator);
  hdf5::put_dataset(file, "/overrides", identity.overrides, communicator);
}

Identity read_identity(hid_t file) {
  return {.code_version = hdf5::text_of(file, "code_version"),
          .mesh_hash = hdf5::text_of(file, "mesh_hash"),
          .deck_text = hdf5::text_in(file, "/deck"),
          .overrides = hdf5::texts_in(file, "/overrides")};
}

Moment read_moment(hid_t file) {
  return {.step = hdf5::integer_of(file, "step"), .sample = hdf5::integer_of(file, "sample")};
}

}  // namespace idiophone::results
