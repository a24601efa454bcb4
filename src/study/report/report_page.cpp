#include "idiophone/study/report/report_page.hpp"

#include <algorithm>
#include <vector>

#include "idiophone/study/contents/describe.hpp"
#include "page_motion.hpp"
#include "page_sounds.hpp"
#include "report_page_files.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

/// Frequencies to expect: the deck's references, and the modes of NAME_modes.h5 beside the result.
json references_of(const std::filesystem::path& result) {
  json all = json::array();
  for (const auto& [name, frequencies] : results::read_references(result)) {
    all.push_back({{"name", name}, {"frequencies", frequencies}});
  }
  const std::filesystem::path modes = result.parent_path() / (result.stem().string() + "_modes.h5");
  if (std::filesystem::exists(modes)) {
    for (const auto& [body, frequencies] : results::read_mode_frequencies(modes)) {
      all.push_back({{"name", "modes of " + body}, {"frequencies", frequencies}});
    }
  }
  return all;
}

/// All of one result.
json report_on(const std::filesystem::path& result, const Sounds& sounds) {
  const json described = json::parse(contents::describe_as_json(result));
  json report = {{"file", result.filename().string()},
                 {"name", described.value("name", result.stem().string())},
                 {"code_version", described.value("code_version", "")},
                 {"run", described.value("run", json::object())},
                 {"impacts", json::array()},
                 {"impacts_left_out", sounds.left_out},
                 {"channels", json::array()},
                 {"references", references_of(result)},
                 {"series", channels_over_time(result)},
                 {"frames", frames(result)}};
  for (const Impact& impact : sounds.impacts) {
    report["impacts"].push_back(to_json(impact));
  }
  for (const Channel& channel : sounds.channels) {
    report["channels"].push_back(to_json(channel));
  }
  return report;
}

}  // namespace

std::string page(std::span<const std::filesystem::path> results) {
  json data = {{"results", json::array()}, {"compared", json::array()}};
  std::vector<Sounds> sounds;
  for (const std::filesystem::path& result : results) {
    sounds.push_back(read_sounds(result));
    data["results"].push_back(report_on(result, sounds.back()));
  }
  for (std::size_t i = 0; sounds.size() == 2 && i < std::min(sounds[0].channels.size(), sounds[1].channels.size());
       ++i) {
    data["compared"].push_back(compared(sounds[0].channels[i], sounds[1].channels[i]));
  }
  return web::filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::report
