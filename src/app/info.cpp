// `idiophone info`: what is in a result, recording, checkpoint, sound map, mesh file or file of `radiate`.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/foundation/terminal_text.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"

namespace idiophone::app {

namespace {

struct InfoOptions {
  std::filesystem::path file;
  std::string channel;  ///< of a result, whose rows are printed; empty for what is in the file
  bool verify = false;  ///< read all of it and compare it with its checksums
  Style style = Style::text;
};

void declare(CLI::App& app, InfoOptions& options) {
  app.add_option("file", options.file,
                 "NAME.h5, a recording, a checkpoint, a sound map, a mesh file or NAME_radiation.h5")
      ->required();
  app.add_option("--channel", options.channel,
                 "print the rows of this channel of a result as CSV, e.g. motion/plate/velocity or energy");
  app.add_flag("--verify", options.verify,
               "read all of it, compare it with its checksums, and name what is damaged; status 1 if anything is");
  add_json(app, options.style);
}

void print_verification(const std::filesystem::path& file, const results::Verification& result) {
  for (const auto& [path, problem, since] : result.damaged) {
    fmt::print("  {}: DAMAGED{}: {}\n", for_terminal(path), since ? fmt::format(" from {:.6g} s on", *since) : "",
               for_terminal(problem));
  }
  fmt::print("{}: {}; {} datasets have their checksums", for_terminal(file.string()),
             result.damaged.empty() ? "nothing is damaged" : fmt::format("{} parts are damaged", result.damaged.size()),
             result.intact);
  fmt::print("{}\n", result.unproved == 0 ? "" : fmt::format(", {} can be read but have none", result.unproved));
}

void print_as_json(const std::filesystem::path& file, const results::Verification& result) {
  auto damaged = nlohmann::json::array();
  for (const auto& [path, problem, since] : result.damaged) {
    damaged.push_back(
        {{"path", path}, {"problem", problem}, {"since", since ? nlohmann::json(*since) : nlohmann::json()}});
  }
  const nlohmann::json answer = {
      {"file", file.string()}, {"damaged", damaged}, {"intact", result.intact}, {"without_checksum", result.unproved}};
  print_answer(answer);
}

/// Calls with the number of each row and its values, [columns]. By pieces, so that long channels need little memory.
template <class Visit>
void for_each_row(const results::SeriesReader& reader, const spectra::Series& channel, const Visit& visit) {
  constexpr std::int64_t rows_at_once = 65536;
  const std::size_t width = channel.columns.size();
  const std::int64_t rows = reader.rows(channel);
  for (std::int64_t begin = 0; begin < rows; begin += rows_at_once) {
    const std::int64_t count = std::min(rows_at_once, rows - begin);
    const std::vector<double> values = reader.read(channel, begin, count);
    for (std::int64_t row = 0; row < count; ++row) {
      visit(begin + row, std::span(values).subspan(row * width, width));
    }
  }
}

/// CSV: the time of each row and its values.
void print_channel(const results::SeriesReader& reader, const spectra::Series& channel) {
  fmt::print("time (s)");
  for (const std::string& column : channel.columns) {
    fmt::print(",{} ({})", for_terminal(column), for_terminal(channel.unit));
  }
  fmt::print("\n");
  for_each_row(reader, channel, [&](std::int64_t row, std::span<const double> values) {
    fmt::print("{:.9g}", static_cast<double>(row) / channel.rate);
    for (const double value : values) {
      fmt::print(",{:.17g}", value);
    }
    fmt::print("\n");
  });
}

void print_channel_as_json(const results::SeriesReader& reader, const spectra::Series& channel) {
  nlohmann::json answer = {{"path", channel.path},
                           {"unit", channel.unit},
                           {"rate", channel.rate},
                           {"columns", channel.columns},
                           {"description", channel.description},
                           {"rows", nlohmann::json::array()}};
  for_each_row(reader, channel, [&](std::int64_t, std::span<const double> values) {
    answer["rows"].push_back(std::vector<double>(values.begin(), values.end()));
  });
  print_answer(answer);
}

void print_channel(const InfoOptions& options) {
  const results::SeriesReader reader(options.file);
  try {
    const spectra::Series& channel = reader.find(options.channel);
    reader.require_intact(channel);
    options.style == Style::json ? print_channel_as_json(reader, channel) : print_channel(reader, channel);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{}: {}", options.file.string(), error.what()));
  }
}

int info(const InfoOptions& options) {
  if (options.verify) {
    const results::Verification result = results::verify(options.file);
    (options.style == Style::json ? print_as_json : print_verification)(options.file, result);
    return result.damaged.empty() ? loop::exit_finished : loop::exit_failed;
  }
  if (!options.channel.empty()) {
    print_channel(options);
    return loop::exit_finished;
  }
  fmt::print("{}", options.style == Style::json ? contents::describe_as_json(options.file)
                                                : for_terminal(contents::describe(options.file)));
  return loop::exit_finished;
}

}  // namespace

Command info_command() {
  return make_command<InfoOptions>(
      "info", "tell what is in a result, a recording, a checkpoint, a sound map, a mesh file or a file of `radiate`",
      Ranks::one, declare, info);
}

}  // namespace idiophone::app
