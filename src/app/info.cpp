#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "idiophone/store/describe.hpp"
#include "idiophone/store/verification.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

void print_verification(const std::filesystem::path& file, const store::Verification& result) {
  for (const auto& [path, problem, since] : result.damaged) {
    fmt::print("  {}: DAMAGED{}: {}\n", path, since ? fmt::format(" from {:.6g} s on", *since) : "", problem);
  }
  fmt::print("{}: {}; {} datasets have their checksums", file.string(),
             result.damaged.empty() ? "nothing is damaged" : fmt::format("{} parts are damaged", result.damaged.size()),
             result.intact);
  fmt::print("{}\n", result.unproved == 0 ? "" : fmt::format(", {} can be read but have none", result.unproved));
}

void print_as_json(const std::filesystem::path& file, const store::Verification& result) {
  auto damaged = nlohmann::json::array();
  for (const auto& [path, problem, since] : result.damaged) {
    damaged.push_back(
        {{"path", path}, {"problem", problem}, {"since", since ? nlohmann::json(*since) : nlohmann::json()}});
  }
  const nlohmann::json answer = {
      {"file", file.string()}, {"damaged", damaged}, {"intact", result.intact}, {"without_checksum", result.unproved}};
  fmt::print("{}\n", answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

int info(const InfoOptions& options) {
  if (options.verify) {
    const store::Verification result = store::verify(options.file);
    (options.style == Style::json ? print_as_json : print_verification)(options.file, result);
    return result.damaged.empty() ? exit_finished : exit_failed;
  }
  fmt::print("{}",
             options.style == Style::json ? store::describe_as_json(options.file) : store::describe(options.file));
  return exit_finished;
}

}  // namespace idiophone::app
