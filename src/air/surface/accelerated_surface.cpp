#include "idiophone/air/surface/accelerated_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "surface_kernel_files.hpp"

namespace idiophone::surface {

namespace {

/// Places in the ring of reads are 32-bit numbers.
Surface& countable(Surface& surface, std::size_t slots) {
  if (3 * slots * surface.vertices() > std::numeric_limits<int>::max()) {
    throw std::runtime_error(fmt::format(
        "accelerator: it can't count the {} vertices of a surface; start more ranks, or leave finite elements "
        "to the processor by --accelerate waves",
        surface.vertices()));
  }
  return surface;
}

/// Calls visit(place among the sums of an accelerator, number) for the outputs of all signals, the oldest first.
template <class Visitor>
void for_each_sum(LowPass& low_pass, std::size_t signals, Visitor visit) {
  for (std::size_t output = 0; output < low_pass.outputs(); ++output) {
    for (std::size_t signal = 0; signal < signals; ++signal) {
      visit(output * signals + signal, low_pass.sum(signal, output));
    }
  }
}

}  // namespace

AcceleratedSurface::Filter::Filter(accelerator::Accelerator& accelerator, const LowPass& low_pass, std::size_t numbers)
    : signals(numbers),
      outputs(static_cast<int>(low_pass.outputs())),
      taps(accelerator, low_pass.taps()),
      sums(accelerator, low_pass.outputs() * numbers),
      complete(accelerator, numbers),
      read(accelerator, numbers) {}

void AcceleratedSurface::Filter::load(LowPass& low_pass) {
  std::vector<double> values(sums.size());
  for_each_sum(low_pass, signals, [&](std::size_t place, double sum) { values[place] = sum; });
  sums.write(values);
  oldest = 0;
}

void AcceleratedSurface::Filter::save(LowPass& low_pass) const {
  std::vector<double> values(sums.size());
  sums.read(values);
  std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(oldest * signals), values.end());
  for_each_sum(low_pass, signals, [&](std::size_t place, double& sum) { sum = values[place]; });
}

AcceleratedSurface::AcceleratedSurface(accelerator::Accelerator& accelerator,
                                       const std::vector<std::array<Index, 3>>& triangles, Surface& surface)
    : surface_(countable(surface, slots)),
      triangles_(static_cast<int>(surface.triangles())),
      values_(static_cast<int>(3 * surface.vertices())),
      program_(accelerator, fmt::format("#define SLOTS {}\n", slots) + std::string(surface_file)),
      copy_displacements_(program_, "copy_displacements"),
      filter_displacements_(program_, "filter_displacements"),
      filter_pressures_(program_, "filter_pressures"),
      corners_(accelerator, triangles),
      reference_(accelerator, std::span(surface.reference_).first(values_)),
      ring_(accelerator, static_cast<std::size_t>(slots) * values_),
      pressure_(accelerator, surface.pressure_, surface.triangles()),
      displacement_(accelerator, surface.displacement_, 3 * surface.vertices()) {}

void AcceleratedSurface::load() {
  pressure_.load(surface_.pressure_);
  displacement_.load(surface_.displacement_);
  ring_.write(std::span<const double>(surface_.slots_[0]).first(values_));
  begin_ = 0;
}

void AcceleratedSurface::save() const {
  if (reads_ != 0 || reads_filtered_ != 0) {
    throw std::logic_error("AcceleratedSurface::save: only between two audio samples, after take()");
  }
  pressure_.save(surface_.pressure_);
  displacement_.save(surface_.displacement_);
  ring_.read(std::span(surface_.slots_[0]).first(values_), static_cast<std::size_t>(begin_) * values_);
}

void AcceleratedSurface::displace(std::size_t first, const accelerator::Array<Index>& nodes,
                                  const accelerator::Array<double>& displacement) {
  const int slot = (begin_ + reads_ + 1) % slots;
  copy_displacements_({nodes.size(), 1, 1}, static_cast<int>(nodes.size()), nodes, displacement,
                      slot * values_ + static_cast<int>(3 * first), ring_);
}

void AcceleratedSurface::read() {
  const int reads_per_sample = surface_.sampling().reads_per_sample();
  if (reads_filtered_ == reads_per_sample) {
    throw std::logic_error("AcceleratedSurface::read: the audio sample is complete; take it first");
  }
  ++reads_;
  const bool completes = reads_filtered_ + reads_ == reads_per_sample;
  if (completes || reads_ == slots - 1) {
    filter_reads(completes ? 1 : 0);
  }
}

void AcceleratedSurface::filter_reads(int completes) {
  const Sampling& sampling = surface_.sampling();
  const double scale = sampling.impedance * sampling.rate * sampling.reads_per_sample() / 3.0;
  Filter& d = displacement_;
  filter_displacements_({d.signals, 1, 1}, values_, reads_, begin_, reads_filtered_, d.outputs, d.oldest, completes,
                        d.taps, ring_, reference_, d.sums, d.complete);
  Filter& p = pressure_;
  filter_pressures_({p.signals, 1, 1}, triangles_, reads_, begin_, reads_filtered_, p.outputs, p.oldest, completes,
                    p.taps, ring_, reference_, values_, scale, corners_, p.sums, p.complete);
  begin_ = (begin_ + reads_) % slots;
  reads_filtered_ += reads_;
  reads_ = 0;
  if (completes != 0) {
    p.read.begin(p.complete);
    d.read.begin(d.complete);
  }
}

void AcceleratedSurface::take(SurfaceMotion& motion) {
  if (reads_filtered_ != surface_.sampling().reads_per_sample()) {
    throw std::logic_error("AcceleratedSurface::take: reads of this audio sample are missing");
  }
  reads_filtered_ = 0;
  motion.pressure.assign(padded(surface_.triangles()), 0.0);
  motion.position.assign(SurfaceMotion::position_length(surface_.vertices()), 0.0);
  std::ranges::copy(pressure_.read.finish(), motion.pressure.begin());
  std::ranges::copy(displacement_.read.finish(), motion.position.begin());
  pressure_.oldest = (pressure_.oldest + 1) % pressure_.outputs;
  displacement_.oldest = (displacement_.oldest + 1) % displacement_.outputs;
}

}  // namespace idiophone::surface
