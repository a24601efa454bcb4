#include "mesher_process.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "mesher_messages.hpp"

namespace idiophone::mesh {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void cannot_start(const std::string& why) {
  throw std::runtime_error("idiophone_gmsh, which runs gmsh, can't be started: " + why);
}

/// The folder of the shared object that this code is part of, as in the extension of Python; else of the program.
std::filesystem::path own_folder() {
  static const char inside = 0;
  Dl_info object = {};
  if (::dladdr(&inside, &object) != 0 && std::filesystem::path(object.dli_fname).extension() == ".so") {
    return std::filesystem::canonical(object.dli_fname).parent_path();
  }
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

std::filesystem::path mesher_program() {
  if (const char* chosen = std::getenv("IDIOPHONE_GMSH")) {
    return chosen;
  }
  const auto folder = own_folder();
  for (const char* place : {".", "..", "../libexec/idiophone", "../..", "../../../../libexec/idiophone"}) {
    if (auto program = folder / place / "idiophone_gmsh"; std::filesystem::exists(program)) {
      return program;
    }
  }
  cannot_start("there is none in " + folder.string() + "; set IDIOPHONE_GMSH to its path");
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  void close() {
    if (number_ >= 0) {
      ::close(std::exchange(number_, -1));
    }
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

/// Two connected descriptors: ours and the process's. A socket: writing to a process that died raises no signal.
struct Channel {
  Channel() : Channel(make()) {}
  Descriptor ours, its;

 private:
  static std::array<int, 2> make() {
    std::array<int, 2> ends = {};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      cannot_start(std::strerror(errno));
    }
    return ends;
  }
  explicit Channel(std::array<int, 2> ends) : ours(ends[0]), its(ends[1]) {}
};

/// What is left of a process that ended.
struct ExitState {
  int status = 0;       ///< of wait()
  double memory = 0.0;  ///< the most that it held, bytes
};

/// idiophone_gmsh. It does not outlive this object.
class Process {
 public:
  Process() {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, request.its.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, messages.its.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, messages.its.number(), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&files, answer.its.number(), answer_descriptor);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);  // Ctrl-C in a terminal is for us to act on
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::string program = mesher_program().string();
    std::string word = "--for-idiophone";
    std::array<char*, 3> arguments = {program.data(), word.data(), nullptr};
    auto variables = environment();
    std::vector<char*> pointers;
    pointers.reserve(variables.size() + 1);
    for (auto& variable : variables) {
      pointers.push_back(variable.data());
    }
    pointers.push_back(nullptr);
    const int error = posix_spawn(&id_, program.c_str(), &files, &attributes, arguments.data(), pointers.data());
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) {
      id_ = 0;
      cannot_start(program + ": " + std::strerror(error));
    }
    request.its.close();
    messages.its.close();
    answer.its.close();
  }
  ~Process() {
    if (id_ != 0) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process(Process&&) = delete;
  Process& operator=(Process&&) = delete;

  /// How it ended, if it did.
  [[nodiscard]] std::optional<ExitState> end() {
    ExitState end;
    rusage usage = {};
    if (wait4(id_, &end.status, WNOHANG, &usage) != id_) {
      return std::nullopt;
    }
    id_ = 0;
    end.memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
    return end;
  }

  Channel request, messages, answer;

 private:
  /// A geometry file can read its environment: it gets nothing of the user's.
  static std::vector<std::string> environment() {
    std::vector<std::string> variables = {"LC_ALL=C", "OMP_NUM_THREADS=1", "PATH=/usr/bin:/bin"};
    for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
      if (const char* value = std::getenv(name)) {
        variables.push_back(fmt::format("{}={}", name, value));
      }
    }
    return variables;
  }
  pid_t id_ = 0;
};

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
  Process process;
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
