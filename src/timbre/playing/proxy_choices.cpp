// What the engine of proxies chose.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <fstream>
#include <stdexcept>

#include "cast.hpp"

namespace idiophone::timbre {

namespace {

const char* name_of(proxies::Choice::Kind kind) {
  switch (kind) {
    case proxies::Choice::Kind::begin:
      return "begin";
    case proxies::Choice::Kind::end:
      return "end";
    case proxies::Choice::Kind::stop:
      return "stop";
    case proxies::Choice::Kind::refuse:
      return "refuse";
  }
  return "";
}

void write_choices(const std::filesystem::path& path, const std::vector<proxies::Choice>& choices,
                   const voices::ProxyVoices& proxies, int rate) {
  std::ofstream file(path);
  file << "time,body,choice,level,rate,springs_per_second\n";
  for (const proxies::Choice& choice : choices) {
    file << fmt::format("{:.6f},{},{},{},{},{:.6g}\n", static_cast<double>(choice.sample) / rate,
                        proxies.name_of(choice.body), name_of(choice.kind), choice.level,
                        static_cast<double>(rate) / choice.divisor, choice.cost);
  }
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("can't write {}", path.string()));
  }
}

}  // namespace

ProxyFacts report_choices(voices::ProxyVoices& proxies, const ProxySettings& settings, int rate) {
  const std::vector<proxies::Choice> choices = proxies.take_choices();
  if (!settings.report.empty()) {
    write_choices(settings.report, choices, proxies, rate);
  }
  ProxyFacts facts{.levels = {}, .choices = {{"begin", 0}, {"end", 0}, {"stop", 0}, {"refuse", 0}}, .breaks = {}};
  for (const proxies::Choice& choice : choices) {
    ++facts.choices[name_of(choice.kind)];
  }
  spdlog::info("{} proxies began to sound, {} became stable, {} were faded out for others", facts.choices["begin"],
               facts.choices["end"], facts.choices["stop"]);
  for (std::size_t parts = proxies.bodies().size(); const proxies::Fracture& fracture : proxies.fractures()) {
    parts += fracture.pieces.size() - 1;
    facts.breaks.push_back({.time = static_cast<double>(fracture.sample) / rate,
                            .body = proxies.name_of(fracture.body),
                            .pieces = fracture.pieces.size(),
                            .released = fracture.released});
    const Break& last = facts.breaks.back();
    spdlog::info("{:.4f} s: {} broke into {} pieces and released {:.3g} J; {} parts", last.time, last.body, last.pieces,
                 last.released, parts);
  }
  if (facts.choices["refuse"] > 0) {
    spdlog::warn("{} forces were left out: --most-active or --budget is too small for them", facts.choices["refuse"]);
  }
  return facts;
}

}  // namespace idiophone::timbre
