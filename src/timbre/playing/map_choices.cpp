// What was heard of the sound maps.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "cast.hpp"

namespace idiophone::timbre {

namespace {

double decibels(double power_ratio) {
  return 10.0 * std::log10(std::max(power_ratio, 1e-30));
}

void write_choices(const std::filesystem::path& path, const std::vector<voices::MapChoice>& choices, int rate) {
  std::ofstream file(path);
  file << "time,sounding,silent,modes,heard,cost,left_out_db\n";
  for (const voices::MapChoice& choice : choices) {
    file << fmt::format("{:.6f},{},{},{},{},{:.6g},{:.2f}\n", static_cast<double>(choice.sample) / rate,
                        choice.sounding, choice.silent, choice.modes, choice.heard, choice.cost,
                        decibels(choice.left_out));
  }
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("can't write {}", path.string()));
  }
}

}  // namespace

std::optional<MapFacts> report_detail(voices::SoundMapVoices& maps, const PlaySettings& settings, int rate) {
  const std::vector<voices::MapChoice> choices = maps.take_choices();
  if (!settings.detail_report.empty()) {
    write_choices(settings.detail_report, choices, rate);
  }
  if (choices.empty()) {
    return {};
  }
  MapFacts facts;
  double modes = 0.0, heard = 0.0, all = 0.0, left_out = 0.0;
  for (const voices::MapChoice& choice : choices) {
    facts.mean_cost += choice.cost / static_cast<double>(choices.size());
    facts.largest_cost = std::max(facts.largest_cost, choice.cost);
    facts.most_sounding = std::max(facts.most_sounding, choice.sounding);
    modes += static_cast<double>(choice.modes);
    heard += static_cast<double>(choice.heard);
    all += choice.power;
    left_out += choice.left_out * choice.power;
  }
  facts.heard = modes > 0.0 ? heard / modes : 1.0;
  facts.left_out = all > 0.0 ? decibels(left_out / all) : decibels(0.0);
  spdlog::info(
      "sound maps: cost {:.3g} on average, {:.3g} at most; {:.3g} % of the modes were heard; what was left out is "
      "{:.1f} dB",
      facts.mean_cost, facts.largest_cost, 100.0 * facts.heard, facts.left_out);
  return facts;
}

}  // namespace idiophone::timbre
