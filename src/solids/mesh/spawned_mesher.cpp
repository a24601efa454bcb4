#include "spawned_mesher.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesh {

namespace {

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

/// A geometry file can read its environment: it gets nothing of the user's.
std::vector<std::string> environment() {
  std::vector<std::string> variables = {"LC_ALL=C", "OMP_NUM_THREADS=1", "PATH=/usr/bin:/bin"};
  for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name)) {
      variables.push_back(fmt::format("{}={}", name, value));
    }
  }
  return variables;
}

}  // namespace

std::array<int, 2> Channel::make() {
  std::array<int, 2> ends = {};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    cannot_start(std::strerror(errno));
  }
  return ends;
}

SpawnedMesher::SpawnedMesher() {
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

SpawnedMesher::~SpawnedMesher() {
  if (id_ != 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
}

std::optional<ExitState> SpawnedMesher::end() {
  ExitState end;
  rusage usage = {};
  if (wait4(id_, &end.status, WNOHANG, &usage) != id_) {
    return std::nullopt;
  }
  id_ = 0;
  end.memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return end;
}

}  // namespace idiophone::mesh
