#include "confinement.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#ifdef IDIOPHONE_HAS_SECCOMP
#include <seccomp.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <string>

#include "idiophone/foundation/signal_safe.hpp"
#include "idiophone/solids/mesh/meshing.hpp"
#include "visible_files.hpp"

namespace idiophone::mesher {

namespace {

[[noreturn]] void end_unconfined(const std::string& what) {
  write_to_stderr(what + ": " + std::strerror(errno) + "\n");
  _exit(mesh::exit_no_sandbox);
}

#ifdef IDIOPHONE_HAS_SECCOMP

/// What a forbidden system call would have done, in words.
const char* deed(int call) {
  switch (call) {
    case SYS_clone:
    case SYS_clone3:
    case SYS_execve:
    case SYS_execveat:
#ifdef SYS_fork
    case SYS_fork:
    case SYS_vfork:
#endif
      return "start another program\n";
    case SYS_socket:
    case SYS_connect:
      return "use the network\n";
    case SYS_openat:
#ifdef SYS_open
    case SYS_open:
#endif
      return "write a file\n";
#ifdef SYS_mkdir
    case SYS_mkdir:
    case SYS_rmdir:
    case SYS_unlink:
    case SYS_rename:
#endif
    case SYS_mkdirat:
    case SYS_unlinkat:
    case SYS_renameat:
    case SYS_renameat2:
      return "make, move or remove a file or folder\n";
    default:
      return nullptr;
  }
}

/// Called instead of a forbidden system call. Everything in it may be called from a signal handler.
void end_forbidden(int /*signal*/, siginfo_t* information, void* /*context*/) {
  write_to_stderr("\nthe file tried to ");
  if (const char* known = deed(information->si_syscall)) {
    write_to_stderr(known);
  } else {
    std::array<char, 12> digits = {};
    auto* place = digits.end();
    for (int number = information->si_syscall; number > 0 && place != digits.begin(); number /= 10) {
      *--place = static_cast<char>('0' + number % 10);
    }
    write_to_stderr("make system call ");
    write_to_stderr({place, digits.end()});
    write_to_stderr("\n");
  }
  _exit(mesh::exit_forbidden);
}

#endif

void limit(__rlimit_resource resource, std::uint64_t most) {
  const rlimit both = {most, most};
  if (setrlimit(resource, &both) != 0) {
    end_unconfined("idiophone_gmsh can't limit its resources");
  }
}

/// Lets files beneath `folder` be read, and no others be opened, listed, made, removed or run.
/// @return whether this kernel can
bool confine_to(const std::filesystem::path& folder) {
  landlock_ruleset_attr ruleset = {};
  ruleset.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;  // all of Landlock's first version
  const auto rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &ruleset, sizeof(ruleset), 0));
  if (rules < 0) {
    return false;
  }
  landlock_path_beneath_attr readable = {};
  readable.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
  readable.parent_fd = open(folder.c_str(), O_PATH | O_CLOEXEC);
  if (readable.parent_fd < 0 || syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &readable, 0) != 0 ||
      syscall(SYS_landlock_restrict_self, rules, 0) != 0) {
    end_unconfined("Landlock can't confine idiophone_gmsh to " + folder.string());
  }
  close(readable.parent_fd);
  close(rules);
  return true;
}

#ifdef IDIOPHONE_HAS_SECCOMP

/// A list of system calls, and what happens to them or to all others.
class Filter {
 public:
  explicit Filter(std::uint32_t others) : filter_(seccomp_init(others)), good_(filter_ != nullptr) {}
  ~Filter() { seccomp_release(filter_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;
  Filter(Filter&&) = delete;
  Filter& operator=(Filter&&) = delete;

  void add(std::uint32_t action, std::initializer_list<int> calls) {
    for (const int call : calls) {
      good_ = good_ && seccomp_rule_add(filter_, action, call, 0) == 0;
    }
  }
  void add_if(std::uint32_t action, int call, const scmp_arg_cmp& condition) {
    good_ = good_ && seccomp_rule_add_array(filter_, action, call, 1, &condition) == 0;
  }
  void load() {
    if (!good_ || seccomp_load(filter_) != 0) {
      end_unconfined("seccomp can't confine idiophone_gmsh");
    }
  }

 private:
  scmp_filter_ctx filter_;
  bool good_;
};

/// A condition on an argument of a system call, which has a number from 0 on.
/// @param second  what a masked comparison expects; the first is the mask
scmp_arg_cmp argument(unsigned number, scmp_compare comparison, scmp_datum_t first, scmp_datum_t second = 0) {
  return {number, comparison, first, second};
}

#endif

}  // namespace

void limit_resources([[maybe_unused]] std::uint64_t memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
#ifndef __SANITIZE_ADDRESS__  // whose shadow memory is larger than any limit
  limit(RLIMIT_DATA, memory);
#endif
}

void confine_files(const std::filesystem::path& folder) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
    end_unconfined("idiophone_gmsh can't give up privileges");
  }
  [[maybe_unused]] const bool by_landlock = confine_to(folder);
  show_only(folder);
#ifdef IDIOPHONE_HAS_SECCOMP
  Filter filter(SCMP_ACT_ALLOW);
  const auto fail = SCMP_ACT_ERRNO(EACCES);
  for (const scmp_datum_t mode : {O_WRONLY, O_RDWR}) {
    filter.add_if(fail, SCMP_SYS(open), argument(1, SCMP_CMP_MASKED_EQ, O_ACCMODE, mode));
    filter.add_if(fail, SCMP_SYS(openat), argument(2, SCMP_CMP_MASKED_EQ, O_ACCMODE, mode));
  }
  filter.add(fail, {SCMP_SYS(creat), SCMP_SYS(mkdir), SCMP_SYS(mkdirat), SCMP_SYS(unlink), SCMP_SYS(unlinkat),
                    SCMP_SYS(chmod), SCMP_SYS(fchmodat), SCMP_SYS(rename), SCMP_SYS(renameat), SCMP_SYS(renameat2)});
  filter.load();
#else
  if (!by_landlock) {
    end_unconfined("idiophone_gmsh was built without libseccomp, and this kernel can't confine it by Landlock");
  }
#endif
}

void confine_calls() {
#ifdef IDIOPHONE_HAS_SECCOMP
  struct sigaction action = {};
  action.sa_sigaction = end_forbidden;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  sigaction(SIGSYS, &action, nullptr);

  Filter filter(SCMP_ACT_TRAP);
  const auto allow = SCMP_ACT_ALLOW;
  filter.add(allow, {SCMP_SYS(read), SCMP_SYS(pread64), SCMP_SYS(readv), SCMP_SYS(write), SCMP_SYS(writev),
                     SCMP_SYS(lseek), SCMP_SYS(close), SCMP_SYS(fstat), SCMP_SYS(newfstatat), SCMP_SYS(stat),
                     SCMP_SYS(lstat), SCMP_SYS(statx), SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2),
                     SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd), SCMP_SYS(fadvise64)});
  filter.add(allow,
             {SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect), SCMP_SYS(madvise),
              SCMP_SYS(mbind), SCMP_SYS(futex), SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity)});
  filter.add(allow, {SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep), SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres),
                     SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(times), SCMP_SYS(getrusage), SCMP_SYS(getrlimit),
                     SCMP_SYS(sysinfo), SCMP_SYS(uname), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(getuid),
                     SCMP_SYS(geteuid), SCMP_SYS(getgid), SCMP_SYS(getegid), SCMP_SYS(getrandom)});
  filter.add(allow, {SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
                     SCMP_SYS(exit), SCMP_SYS(exit_group)});
  filter.add(allow, {SCMP_SYS(unlink)});  // gmsh tries when it clears its state; the first filter lets it fail
  constexpr auto writes = static_cast<scmp_datum_t>(O_ACCMODE | O_CREAT | O_TRUNC);
  filter.add_if(allow, SCMP_SYS(open), argument(1, SCMP_CMP_MASKED_EQ, writes, O_RDONLY));
  filter.add_if(allow, SCMP_SYS(openat), argument(2, SCMP_CMP_MASKED_EQ, writes, O_RDONLY));
  filter.add_if(allow, SCMP_SYS(ioctl), argument(1, SCMP_CMP_EQ, TCGETS));  // is it a terminal?
  filter.add_if(allow, SCMP_SYS(tgkill), argument(0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid())));  // abort()
#ifdef __SANITIZE_ADDRESS__
  filter.add(allow, {SCMP_SYS(pipe), SCMP_SYS(pipe2)});  // by which sanitizers find out whether memory can be read
#endif
  filter.add_if(allow, SCMP_SYS(prlimit64),
                argument(0, SCMP_CMP_EQ, 0));  // only its own, which are at their hard limit
  filter.load();
#endif
}

}  // namespace idiophone::mesher
