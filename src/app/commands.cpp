#include "commands.hpp"

namespace idiophone::app {

// Each is defined in the file of its name: run.cpp, check.cpp, ...
Command run_command(), check_command(), mesh_command(), modes_command(), map_command(), export_command(),
    explore_command(), report_command(), radiate_command(), identify_command(), tune_command(), bench_command(),
    listen_command(), play_command(), timbre_command(), evolve_command(), proxies_command(), info_command(),
    analyze_command(), abx_command();

std::vector<Command> commands() {
  return {run_command(),    check_command(),   mesh_command(),   modes_command(),   map_command(),
          export_command(), explore_command(), report_command(), radiate_command(), identify_command(),
          tune_command(),   bench_command(),   listen_command(), play_command(),    timbre_command(),
          evolve_command(), proxies_command(), info_command(),   analyze_command(), abx_command()};
}

}  // namespace idiophone::app
