#include "campaign.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "answer.hpp"
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>

// HDF5 answers where malloc returns null; operator new with a huge size is a failure with sanitizers, too.
extern "C" [[gnu::visibility("default")]] const char*
__asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
  return "max_allocation_size_mb=4096:allocator_may_return_null=1:exitcode=99";
}
#endif

namespace idiophone::mutants {

namespace {

constexpr std::uint64_t seed = 20261122;
#ifdef __SANITIZE_ADDRESS__
constexpr unsigned time_limit = 600;  // s of a busy machine
#else
constexpr unsigned time_limit = 60;
#endif
enum Status : int { accepted = 0, ended_by_reading_limit = 1, refused = 10, wrong = 11, leaking = 12 };

std::size_t number_from(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

Status status_of(const std::function<void()>& action, const std::string& named) {
  try {
    action();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", typeid(error).name(), error.what());
    return is_answer(error, named) ? refused : wrong;
  } catch (...) {
    fmt::print(stderr, "an exception that is none of std::exception\n");
    return wrong;
  }
  return accepted;
}

/// What the new process says goes to a file.
void limit_process(const std::filesystem::path& said) {
  const int file = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);  // NOLINT(*-vararg): POSIX
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::alarm(time_limit);
#ifndef __SANITIZE_ADDRESS__                   // which reserves addresses for itself
  constexpr rlim_t memory = rlim_t{4} << 30U;  // bytes
  const rlimit data{memory, memory};
  ::setrlimit(RLIMIT_DATA, &data);
#endif
}

/// The status of a process that does something, as waitpid() gives it.
int status_of_process(const std::function<void()>& action, const std::string& named,
                      const std::filesystem::path& said) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    limit_process(said);
    int status = status_of(action, named);
#ifdef __SANITIZE_ADDRESS__
    status = __lsan_do_recoverable_leak_check() != 0 ? leaking : status;
#endif
    std::fflush(nullptr);
    ::_exit(status);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// In words; empty for a failure. The reading limit of damaged HDF5 files ends the program with a message.
std::string outcome(int status, const std::string& said) {
  if (!WIFEXITED(status)) {
    return "";
  }
  switch (WEXITSTATUS(status)) {
    case accepted:
      return "accepted";
    case refused:
      return "refused";
    case ended_by_reading_limit:
      return said.find("is damaged: reading it crashes, or does not end") != std::string::npos ? "ended by the limit"
                                                                                               : "";
    default:
      return "";
  }
}

std::string in_words(int status) {
  return WIFSIGNALED(status)              ? fmt::format("signal {}", WTERMSIG(status))
         : WEXITSTATUS(status) == wrong   ? "an exception that is no answer"
         : WEXITSTATUS(status) == leaking ? "a leak"
                                          : fmt::format("exit status {}", WEXITSTATUS(status));
}

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

}  // namespace

void mutate_text(const std::filesystem::path& file, Random& random) {
  write(file, mutated_text(content_of(file), random));
}

void mutate_bytes(const std::filesystem::path& file, Random& random) {
  write(file, mutated_bytes(content_of(file), random));
}

void expect_answers(const Subject& subject) {
  const auto folder = subject.originals.front().parent_path();
  const auto said = folder / "said";
  const auto mutant = folder / ("mutant" + subject.originals.front().extension().string());
  const std::string named = subject.named.empty() ? mutant.filename().string() : subject.named;
  for (const auto& original : subject.originals) {
    const int status = status_of_process([&] { subject.read(original); }, "", said);
    ASSERT_EQ(outcome(status, ""), "accepted") << original << ": " << in_words(status) << "\n" << content_of(said);
  }
  const std::size_t only = number_from("IDIOPHONE_MUTANT", 0);
  const std::size_t count = std::max<std::size_t>(number_from("IDIOPHONE_MUTANTS", 25) / subject.share, 1);
  std::map<std::string, std::size_t> outcomes;
  for (std::size_t number = only > 0 ? only : 1; number <= (only > 0 ? only : count); ++number) {
    std::filesystem::copy_file(subject.originals[number % subject.originals.size()], mutant,
                               std::filesystem::copy_options::overwrite_existing);
    const auto mutate_and_read = [&] {
      Random random(seed + number);
      subject.mutate(mutant, random);
      subject.read(mutant);
    };
    const int status = status_of_process(mutate_and_read, named, said);
    const std::string found = outcome(status, content_of(said));
    ++outcomes[found];
    if (found.empty()) {
      const std::string kept = fmt::format("mutant_{}_{}{}", subject.type, number, mutant.extension().string());
      std::filesystem::copy_file(mutant, kept, std::filesystem::copy_options::overwrite_existing);
      ADD_FAILURE() << subject.type << " " << number << ": " << in_words(status) << " (" << kept << ")\n"
                    << content_of(said).substr(0, 6000);
    }
  }
  std::string summary;
  for (const auto& [found, times] : outcomes) {
    summary += fmt::format(", {} {}", times, found.empty() ? "WRONG" : found);
  }
  fmt::print("{}: {} mutants{}\n", subject.type, count, summary);
}

}  // namespace idiophone::mutants
