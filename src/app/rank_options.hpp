#pragma once
// Options of `check` that predict a run on many ranks.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

#include "idiophone/study/advice/network.hpp"
#include "idiophone/study/advice/rank_prediction.hpp"

namespace idiophone::app {

struct RankOptions {
  std::optional<int> ranks;                        ///< none: no prediction
  std::optional<double> latency;                   ///< of a message between two ranks, s; see advice::usual_network
  std::optional<double> overhead;                  ///< of it, processor time at each end, s
  double bandwidth = advice::Network{}.bandwidth;  ///< of a host, bytes/s
  int ranks_on_host = advice::Network{}.ranks_on_host;
  std::filesystem::path exchanges;  ///< file of what each rank computes and receives; empty: none
};

/// --ranks, --latency, --overhead, --bandwidth, --ranks-on-host and --exchanges
void add_ranks(CLI::App& app, RankOptions& options);

/// Ranks whose latency is given exchange messages.
/// @throws std::runtime_error if the overhead at both ends exceeds the latency
[[nodiscard]] advice::Network network_of(const RankOptions& options);

/// @throws std::runtime_error if the file cannot be written
void write_exchanges(const advice::RankPrediction& prediction, const std::filesystem::path& file);

}  // namespace idiophone::app
