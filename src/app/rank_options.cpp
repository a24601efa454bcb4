#include "rank_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace idiophone::app {

void add_ranks(CLI::App& app, RankOptions& options) {
  CLI::Option* ranks =
      app.add_option(
             "-n,--ranks", options.ranks,
             "predict sizes, memory and speed-up of a run on so many ranks; start without mpirun unless meshes are "
             "read in parts")
          ->check(CLI::Range(1, 1 << 20));
  app.add_option("--latency", options.latency,
                 "s: of a message between two ranks, for --ranks (default: 2e-6, or 4e-7 if this machine has a "
                 "processor for each rank)")
      ->needs(ranks)
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--overhead", options.overhead,
                 "s: of the latency, processor time at each end (default: 3e-7, or half of a shorter latency; 2e-7 "
                 "where the latency is 4e-7)")
      ->needs(ranks)
      ->check(CLI::Range(0.0, 0.5));
  app.add_option("--bandwidth", options.bandwidth, "bytes/s: of a host, for --ranks")
      ->needs(ranks)
      ->check(CLI::Range(1.0, 1e15))
      ->capture_default_str();
  app.add_option("--ranks-on-host", options.ranks_on_host,
                 "they exchange messages through its memory and share its bandwidth, for --ranks")
      ->needs(ranks)
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--exchanges", options.exchanges,
                 "file (JSON) of what each rank computes and receives in a step, for programs that simulate a network")
      ->needs(ranks);
}

advice::Network network_of(const RankOptions& options) {
  advice::Network network = advice::usual_network(options.ranks.value());
  if (options.latency) {
    network = {.latency = *options.latency};
    network.overhead = std::min(network.overhead, network.latency / 2);
  }
  network.overhead = options.overhead.value_or(network.overhead);
  network.bandwidth = options.bandwidth;
  network.ranks_on_host = options.ranks_on_host;
  if (2 * network.overhead > network.latency) {
    throw std::runtime_error(
        fmt::format("messages with an --overhead of {} s at each end take longer than their latency of {} s: give the "
                    "--latency that a ping-pong of messages measures, which includes both",
                    network.overhead, network.latency));
  }
  return network;
}

void write_exchanges(const advice::RankPrediction& prediction, const std::filesystem::path& file) {
  const bool has_times = prediction.waves && prediction.waves->times;
  const nlohmann::json facts = {
      {"motion", advice::facts_of(prediction.steps)},
      {"waves", has_times ? advice::facts_of(prediction.waves->times->steps) : nlohmann::json()}};
  if (!(std::ofstream(file) << facts).flush()) {
    throw std::runtime_error(fmt::format("cannot write {}", file.string()));
  }
}

}  // namespace idiophone::app
