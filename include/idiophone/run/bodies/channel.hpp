#pragma once
// Motion channels: named series of the motion (a contact's force, a body's orientation, energies). They go to the
// result file and to other users, by name.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/spectra/series.hpp"

namespace idiophone::bodies {

/// Channels that are noted together, since one measurement gives all of them.
class ChannelGroup {
 public:
  virtual ~ChannelGroup() = default;
  ChannelGroup(const ChannelGroup&) = delete;
  ChannelGroup& operator=(const ChannelGroup&) = delete;
  ChannelGroup(ChannelGroup&&) = delete;
  ChannelGroup& operator=(ChannelGroup&&) = delete;

  /// The path, unit, columns, rate and description of each. The same on all ranks.
  [[nodiscard]] const std::vector<spectra::Series>& channels() const { return channels_; }

  /// Notes a row of each channel if one is due; the source calls this. No communication.
  /// @param sample  audio sample that the source's motion has reached, from 0 on
  virtual void note(std::int64_t sample) = 0;

  /// Takes all rows noted since the last call. Collective, at the end of a block.
  /// @return [channels][columns x rows] on rank 0, a row's columns side by side; empty vectors elsewhere
  [[nodiscard]] virtual std::vector<std::vector<double>> collect() = 0;

  /// What decides the future when all rows are collected.
  virtual void archive(parallel::Archive& /*archive*/) {}

 protected:
  explicit ChannelGroup(std::vector<spectra::Series> channels) : channels_(std::move(channels)) {}

 private:
  std::vector<spectra::Series> channels_;
};

/// All channels of a run.
class Channels {
 public:
  /// Gets the new rows of a channel at the end of each block, [columns x rows]; on every rank, but rows are on rank 0
  /// only. It may make collective calls.
  using Subscriber = std::function<void(const spectra::Series& channel, std::span<const double> rows)>;

  /// @param groups  must outlive this object
  explicit Channels(std::vector<ChannelGroup*> groups);

  /// Every channel, in the order of the groups.
  [[nodiscard]] std::vector<spectra::Series> all() const;

  /// From now on, the subscriber gets the rows of one channel.
  /// @param name  e.g. "/contacts/blow/force", see spectra::find_series()
  /// @throws std::invalid_argument when there is no such channel; it names the nearest one
  void subscribe(const std::string& name, Subscriber subscriber);

  /// From now on, the subscriber gets the rows of every channel.
  void subscribe(Subscriber subscriber);

  /// Collects all rows and gives them to the subscribers. Collective, at the end of a block.
  void deliver();

 private:
  struct Subscription {
    std::string path;  ///< empty for all
    Subscriber subscriber;
  };
  std::vector<ChannelGroup*> groups_;
  std::vector<Subscription> subscriptions_;
};

}  // namespace idiophone::bodies
