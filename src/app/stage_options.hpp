#pragma once
// Options of `play` and `proxies`.

#include <CLI/CLI.hpp>

#include "idiophone/timbre/playing/playing.hpp"

namespace idiophone::app {

/// Who drives the bodies, and where their sound goes.
void add_stage(CLI::App& app, timbre::PlaySettings& settings);

/// How stiff the springs of proxies are.
void add_springs(CLI::App& app, proxy_bodies::Springs& springs);

/// How bodies of decks become proxies.
void add_proxies(CLI::App& app, timbre::ProxySettings& settings);

/// Prints what a performance was, as JSON.
void print_facts(const timbre::PlaySettings& settings, const timbre::Performance& done);

}  // namespace idiophone::app
