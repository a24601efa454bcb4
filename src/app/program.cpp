#include "idiophone/app/program.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <slepcsys.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "command_line.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/terminal_text.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/timbre/body_nodes/body_nodes.hpp"
#include "memory_limit.hpp"
#include "program_start.hpp"

namespace idiophone::app {

namespace {

/// Splits the command line: PETSc's options come last, from the first argument with a single dash on ("-log_view").
std::pair<std::vector<char*>, std::vector<char*>> split(int count, char** arguments) {
  std::vector<char*> ours(arguments, arguments + count);
  const auto first = std::find_if(ours.begin() + 1, ours.end(), [](const std::string_view text) {
    return text.size() > 2 && text[0] == '-' && text[1] != '-' &&
           std::isalpha(static_cast<unsigned char>(text[1])) != 0;
  });
  std::vector<char*> petscs = {arguments[0]};
  petscs.insert(petscs.end(), first, ours.end());
  ours.erase(first, ours.end());
  return {ours, petscs};
}

/// A job of one rank just ends.
bool is_alone() {
  return parallel::size_of(MPI_COMM_WORLD) == 1;
}

/// Takes the whole job down. Where all ranks failed alike, rank 0 speaks and the others hold their tongues.
[[noreturn]] void abort_job(int rank, const std::string& message) {
  if (rank != 0) {
    std::this_thread::sleep_for(std::chrono::seconds(3));
  }
  fmt::print(stderr, "idiophone: rank {}: {}\n", rank, for_terminal(message));
  std::fflush(nullptr);
  MPI_Abort(MPI_COMM_WORLD, loop::exit_failed);
  std::abort();
}

int guarded_call(const CommandLine& line, int rank) {
  try {
    loop::require_one_instruction_set(loop::instruction_set(), MPI_COMM_WORLD);
    return call(line.command());
  } catch (const deck::DeckError& error) {
    if (rank == 0) {
      fmt::print(stderr, "{}\n", for_terminal(error.what()));
      return loop::exit_wrong_deck;  // the others learn of it as a RemoteFailure
    }
    abort_job(rank, error.what());
  } catch (const parallel::RemoteFailure&) {
    return loop::exit_wrong_deck;  // rank 0 speaks; if its failure is of another kind, it takes the job down
  } catch (const std::exception& error) {
    if (is_alone()) {
      fmt::print(stderr, "idiophone: {}\n", for_terminal(error.what()));
      return loop::exit_failed;
    }
    abort_job(rank, error.what());
  }
}

/// The message of a log, for a terminal.
class LoggedText : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm& /*time*/, spdlog::memory_buf_t& line) override {
    const std::string text = for_terminal({message.payload.data(), message.payload.size()});
    line.append(text.data(), text.data() + text.size());
  }
  [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<LoggedText>(); }
};

void set_up_log(Style style, bool speaks) {
  spdlog::set_default_logger(style == Style::text ? spdlog::stdout_logger_mt("idiophone")
                                                  : spdlog::stderr_logger_mt("idiophone"));
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<LoggedText>('*').set_pattern("%*");
  spdlog::set_formatter(std::move(formatter));
  spdlog::set_level(speaks ? spdlog::level::info : spdlog::level::err);
}

}  // namespace

int run_program(int argument_count, char** arguments) {
  loop::watch_signals(loop::OnSignal::end);
  auto [ours, petscs] = split(argument_count, arguments);
  CommandLine line;
  timbre::add_body_nodes();
  avoid_semaphores_of_files();
  start_quickly_if_alone();
  MPI_Init(&argument_count, &arguments);
  const int rank = parallel::rank_of(MPI_COMM_WORLD);
  loop::note_rank(rank, parallel::size_of(MPI_COMM_WORLD));
  end_without_memory(rank);
  int status = 0;
  try {
    line.parser().parse(static_cast<int>(ours.size()), ours.data());
  } catch (const CLI::ParseError& error) {
    if (rank == 0) {
      status = line.parser().exit(error);
    }
    parallel::broadcast(status, MPI_COMM_WORLD);
    MPI_Finalize();
    return status;
  }
  set_up_log(line.command().style(), rank == 0);
  int petsc_count = static_cast<int>(petscs.size());
  petscs.push_back(nullptr);
  char** petsc_arguments = petscs.data();
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");  // PETSc would replace ours
  if (SlepcInitialize(&petsc_count, &petsc_arguments, nullptr, nullptr) != 0) {
    abort_job(rank, "PETSc can't be started");
  }
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
  status = guarded_call(line, rank);
  PetscOptionsLeft(nullptr);  // names those that nobody asked for: misspelt ones
  PetscPopErrorHandler();
  SlepcFinalize();
  MPI_Finalize();
  return status;
}

}  // namespace idiophone::app
