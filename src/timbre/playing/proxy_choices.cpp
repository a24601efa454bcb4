// What the engine of proxies chose.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
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

void report_choices(voices::ProxyVoices& proxies, const ProxySettings& settings, int rate) {
  const std::vector<proxies::Choice> choices = proxies.take_choices();
  if (!settings.report.empty()) {
    write_choices(settings.report, choices, proxies, rate);
  }
  std::array<int, 4> counts{};
  for (const proxies::Choice& choice : choices) {
    ++counts[static_cast<std::size_t>(choice.kind)];
  }
  spdlog::info("{} proxies began to sound, {} became stable, {} were faded out for others", counts[0], counts[1],
               counts[2]);
  for (std::size_t parts = proxies.bodies().size(); const proxies::Fracture& fracture : proxies.fractures()) {
    parts += fracture.pieces.size() - 1;
    spdlog::info("{:.4f} s: {} broke into {} pieces and released {:.3g} J; {} parts",
                 static_cast<double>(fracture.sample) / rate, proxies.name_of(fracture.body), fracture.pieces.size(),
                 fracture.released, parts);
  }
  if (counts[3] > 0) {
    spdlog::warn("{} forces were left out: --most-active or --budget is too small for them", counts[3]);
  }
}

}  // namespace idiophone::timbre
