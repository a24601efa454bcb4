#include "idiophone/solids/mesher/mesher_program.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

#include "confinement.hpp"
#include "make_mesh.hpp"
#include "start_gmsh.hpp"

namespace idiophone::mesher {

namespace {

std::string read_all(int descriptor) {
  std::string bytes;
  std::array<char, 4096> part = {};
  for (ssize_t count = 0; (count = read(descriptor, part.data(), part.size())) > 0;) {
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
  return bytes;
}

[[noreturn]] void leave(int status, const std::string& message) {
  std::fflush(nullptr);
  std::fprintf(stderr, "%s\n", message.c_str());
  std::fflush(nullptr);
  _exit(status);  // without destructors: the file may have left gmsh in any state
}

/// The text of the exception that ends the program, wherever it came from: gmsh throws a std::string inside parallel
/// regions, where no one can catch it.
[[noreturn]] void leave_by_exception() {
  try {
    std::rethrow_exception(std::current_exception());
  } catch (const std::string& error) {
    leave(mesh::exit_exception, error);
  } catch (const std::bad_alloc&) {
    leave(mesh::exit_out_of_memory, "out of memory");
  } catch (const std::length_error&) {
    leave(mesh::exit_exception, "the file asks for a list of impossible length; it is damaged");
  } catch (const std::exception& error) {
    leave(mesh::exit_exception, error.what());
  } catch (...) {
    leave(mesh::exit_exception, "an unknown exception");
  }
}

void send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = write(mesh::answer_descriptor, bytes.data() + sent, bytes.size() - sent);
    if (count < 0) {
      leave(mesh::exit_exception, "the answer can't be sent");
    }
    sent += static_cast<std::size_t>(count);
  }
}

}  // namespace

int run_program(int argument_count, char** arguments) {
  if (argument_count != 2 || std::string(arguments[1]) != "--for-idiophone") {
    std::fputs("idiophone_gmsh is started by idiophone, which runs gmsh in it\n", stderr);
    return EXIT_FAILURE;
  }
  std::set_terminate(leave_by_exception);
  syscall(SYS_close_range, mesh::answer_descriptor + 1, ~0U, 0);  // what the MPI library left open
  const mesh::MeshingRequest request = mesh::request_from(read_all(STDIN_FILENO));
  try {
    const GeoScripts scripts(request);
    limit_resources(request.memory_limit);
    confine_files(std::filesystem::path(request.file).parent_path());
    start_gmsh();
    confine_calls();
    send(mesh::to_bytes(make_mesh(request, scripts)));
  } catch (...) {
    leave_by_exception();
  }
  _exit(mesh::exit_answered);
}

}  // namespace idiophone::mesher
