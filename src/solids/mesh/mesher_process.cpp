#include "mesher_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>

#include "mesher_messages.hpp"
#include "spawned_mesher.hpp"

namespace idiophone::mesh {

namespace {

using Clock = std::chrono::steady_clock;

void send(Descriptor& target, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(target.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) {
      break;  // it ended: its status gives the reason
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  target.close();
}

/// Waits a little for either, and hands what came to `take`.
template <class Take>
void receive(Descriptor& source, short events, Take&& take) {
  if (events == 0) {
    return;
  }
  static std::array<char, 1U << 16U> buffer;
  const ssize_t count = read(source.number(), buffer.data(), buffer.size());
  if (count > 0) {
    take(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
    source.close();
  }
}

std::string reason(const ExitState& end, const MesherMessages& messages, const MeshingRequest& request) {
  std::string last = messages.last();
  const std::string memory = fmt::format(" (meshing.memory_limit is {:.3g} bytes)", double(request.memory_limit));
  if (WIFSIGNALED(end.status)) {
    const int signal = WTERMSIG(end.status);
    if (signal == SIGSYS) {  // instead of exit_forbidden, where the C library had blocked signals
      return "the file tried to start another program or the like, which isn't allowed";
    }
    return fmt::format("it crashed by signal {} ({}){}; last message: {}", signal, strsignal(signal),
                       end.memory > 0.6 * static_cast<double>(request.memory_limit)
                           ? fmt::format(", out of memory perhaps{}", memory)
                           : "",
                       last.empty() ? "none" : last);
  }
  switch (WEXITSTATUS(end.status)) {
    case exit_answered:
      return messages.last_error().empty() ? "it ended without a mesh (does the file say Exit?)"
                                           : messages.last_error();
    case exit_no_sandbox:
      return "it isn't run, because the file could do harm: " + last;
    case exit_forbidden:
      return last + ", which isn't allowed";
    case exit_out_of_memory:
      return "it ran out of memory" + memory;
    case exit_exception:
      return last;
    default:
      return fmt::format("it ended with status {}; last message: {}", WEXITSTATUS(end.status),
                         last.empty() ? "none" : last);
  }
}

}  // namespace

MeshingAnswer run_mesher(const MeshingRequest& request, double time_limit) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(time_limit);
  SpawnedMesher process;
  send(process.request.ours, to_bytes(request));
  MesherMessages messages;
  std::string bytes;
  std::optional<ExitState> end;
  Descriptor& talk = process.messages.ours;
  Descriptor& answer = process.answer.ours;
  while (talk.is_open() || answer.is_open() || !(end = process.end())) {
    if (Clock::now() > deadline) {
      throw MesherFailure(
          fmt::format("it takes longer than {:g} s (meshing.time_limit); last message: {}{}", time_limit,
                      messages.last().empty() ? "none" : messages.last(), messages.complaints()),
          MesherFailure::Kind::limit);
    }
    std::array<pollfd, 2> waiting = {pollfd{talk.number(), POLLIN, 0}, pollfd{answer.number(), POLLIN, 0}};
    constexpr int a_moment = 50;  // ms
    poll(waiting.data(), waiting.size(), a_moment);
    receive(talk, waiting[0].revents, [&](std::string_view part) { messages.add(part); });
    receive(answer, waiting[1].revents, [&](std::string_view part) { bytes += part; });
    if (bytes.size() > request.memory_limit) {
      throw MesherFailure("its mesh is larger than meshing.memory_limit", MesherFailure::Kind::limit);
    }
  }
  if (WIFEXITED(end->status) && WEXITSTATUS(end->status) == exit_answered && !bytes.empty()) {
    try {
      return answer_from(bytes);
    } catch (const std::runtime_error& error) {
      throw MesherFailure(error.what() + messages.complaints(), MesherFailure::Kind::limit);
    }
  }
  const bool failed =
      WIFEXITED(end->status) ? WEXITSTATUS(end->status) == exit_exception : WTERMSIG(end->status) != SIGSYS;
  throw MesherFailure(reason(*end, messages, request) + messages.complaints(),
                      failed ? MesherFailure::Kind::gmsh : MesherFailure::Kind::limit);
}

}  // namespace idiophone::mesh
