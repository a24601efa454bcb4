// libFuzzer's entry: writes its bytes to a file in the working folder and reads that. IDIOPHONE_READER names the
// reader; IDIOPHONE_READER=list prints all. A reader accepts a file or throws an error of the project; all else ends
// the program with a report.

#include <gmsh.h>
#include <mpi.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "answer.hpp"
#include "readers.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace idiophone::fuzz;
namespace mutants = idiophone::mutants;

std::vector<Reader> all_readers() {
  auto all = text_readers();
  for (const auto& others : {binary_readers(), stored_readers()}) {
    all.insert(all.end(), others.begin(), others.end());
  }
  return all;
}

Reader named_reader() {
  const char* variable = std::getenv("IDIOPHONE_READER");
  const std::string_view name = variable == nullptr ? "" : variable;
  const auto all = all_readers();
  for (const auto& reader : all) {
    if (reader.name == name) {
      return reader;
    }
  }
  for (const auto& reader : all) {
    std::printf("%s %s\n", reader.name.c_str(), reader.extension.c_str());
  }
  std::exit(name == "list" ? 0 : 2);
}

const Reader& chosen_reader() {
  static const Reader reader = named_reader();
  return reader;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
  static_cast<void>(chosen_reader());
  MPI_Init(nullptr, nullptr);
  for (const int fatal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE}) {
    std::signal(fatal, SIG_DFL);  // MPI has handlers of its own, which libFuzzer would leave in place
  }
  gmsh::initialize();
  gmsh::option::setNumber("General.Terminal", 0);
  spdlog::set_level(spdlog::level::off);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libFuzzer finds out which words are no answer, and writes them into files, from which answers quote.
  if (mutants::has_library_words({reinterpret_cast<const char*>(data), size})) {
    return -1;
  }
  const Reader& reader = chosen_reader();
  static const std::filesystem::path file = std::filesystem::current_path() / ("input" + reader.extension);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    reader.read(file);
  } catch (const std::exception& error) {
    if (!mutants::is_answer(error, reader.names_file ? file.filename().string() : "")) {
      std::fprintf(stderr, "ERROR: no answer: %s: %s\n", typeid(error).name(), error.what());
      std::abort();
    }
  }
  return 0;
}

/// Every second change is libFuzzer's own.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  mutants::Random random(seed);
  if (size == 0 || mutants::below(2, random) == 0) {
    return LLVMFuzzerMutate(data, size, most);
  }
  const std::string changed = chosen_reader().mutated({reinterpret_cast<const char*>(data), size}, random);
  if (changed.empty() || changed.size() > most) {
    return LLVMFuzzerMutate(data, size, most);
  }
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}
