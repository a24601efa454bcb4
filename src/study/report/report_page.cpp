#include "idiophone/study/report/report_page.hpp"

#include <algorithm>
#include <vector>

#include "idiophone/study/contents/describe.hpp"
#include "page_modes.hpp"
#include "page_motion.hpp"
#include "page_sounds.hpp"
#include "report_page_files.hpp"

namespace idiophone::report {

namespace {

using nlohmann::json;

/// Frequencies to expect: the deck's references, and the modes of its bodies with their kinds.
json references_of(const std::filesystem::path& result, const json& modes) {
  json all = json::array();
  for (const auto& [name, frequencies] : results::read_references(result)) {
    all.push_back({{"name", name}, {"frequencies", frequencies}, {"kinds", json::array()}});
  }
  for (const json& body : modes["bodies"]) {
    json frequencies = json::array(), kinds = json::array();
    for (const json& mode : body["modes"]) {
      frequencies.push_back(mode["frequency"]);
      kinds.push_back(mode["kind"]);
    }
    all.push_back(
        {{"name", "modes of " + body["body"].get<std::string>()}, {"frequencies", frequencies}, {"kinds", kinds}});
  }
  return all;
}

/// All of one result.
json report_on(const std::filesystem::path& result, const Sounds& sounds) {
  const json described = json::parse(contents::describe_as_json(result));
  const json run = described.value("run", json::object());
  const json modes = modes_beside(result, run);
  json report = {{"file", result.filename().string()},
                 {"name", described.value("name", result.stem().string())},
                 {"code_version", described.value("code_version", "")},
                 {"run", run},
                 {"impacts", json::array()},
                 {"impacts_left_out", sounds.left_out},
                 {"channels", json::array()},
                 {"modes", modes},
                 {"references", references_of(result, modes)},
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
    if (sounds[0].channels[i].unit == sounds[1].channels[i].unit) {
      data["compared"].push_back(compared(sounds[0].channels[i], sounds[1].channels[i]));
    }
  }
  return web::filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::report
