// What `play` and `proxies` print with --json.

#include <nlohmann/json.hpp>

#include "answer.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

namespace {

nlohmann::json to_json(const timbre::ProxyFacts& proxies) {
  nlohmann::json facts = {
      {"levels", nlohmann::json::array()}, {"choices", proxies.choices}, {"breaks", nlohmann::json::array()}};
  for (const timbre::LevelSize& size : proxies.levels) {
    facts["levels"].push_back(
        {{"body", size.body}, {"level", size.level}, {"masses", size.masses}, {"springs", size.springs}});
  }
  for (const timbre::Break& found : proxies.breaks) {
    facts["breaks"].push_back(
        {{"time", found.time}, {"body", found.body}, {"pieces", found.pieces}, {"released", found.released}});
  }
  return facts;
}

nlohmann::json to_json(const timbre::MapFacts& maps) {
  return {{"mean_cost", maps.mean_cost},
          {"largest_cost", maps.largest_cost},
          {"most_sounding", maps.most_sounding},
          {"heard", maps.heard},
          {"left_out_db", maps.left_out}};
}

}  // namespace

void print_facts(const timbre::PlaySettings& settings, const timbre::Performance& done) {
  nlohmann::json facts = {
      {"output", settings.output.empty() ? nlohmann::json() : nlohmann::json(settings.output.string())},
      {"bodies", done.bodies},
      {"rate", done.rate},
      {"duration", done.duration},
      {"processor_time", done.processor_time},
      {"gaps", done.told.gaps},
      {"midi_messages", done.midi_messages},
      {"sound_maps", done.maps ? to_json(*done.maps) : nlohmann::json()},
      {"proxies", done.proxies ? to_json(*done.proxies) : nlohmann::json()}};
  if (done.told.waits.count > 0) {
    facts["waits"] = {{"mean", done.told.waits.mean}, {"longest", done.told.waits.longest}};
  }
  print_answer(facts);
}

}  // namespace idiophone::app
