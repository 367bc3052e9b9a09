#include "FalconGuard.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr const char* Program = "palpate-falcon-guard";

// Where the program may be; without a slash it is looked for on the PATH.
std::string ProgramPath()
{
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  const std::filesystem::path beside = self.parent_path() / Program;
  return !unknown && access(beside.c_str(), X_OK) == 0 ? beside.string() : Program;
}

// Reads `input`; everything else of this process stays here, so that the guard holds no pipe open
// that somebody waits for.
class SpawnSettings
{
public:
  explicit SpawnSettings(int input)
  {
    posix_spawn_file_actions_init(&this->Files);
    posix_spawn_file_actions_adddup2(&this->Files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&this->Files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&this->Files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
    posix_spawn_file_actions_addclosefrom_np(&this->Files, STDERR_FILENO + 1);
#endif
    sigset_t signals;
    posix_spawnattr_init(&this->Attributes);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&this->Attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&this->Attributes, &signals);
    posix_spawnattr_setflags(&this->Attributes,
                             POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnSettings()
  {
    posix_spawnattr_destroy(&this->Attributes);
    posix_spawn_file_actions_destroy(&this->Files);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t Files{};
  posix_spawnattr_t Attributes{};
};
} // namespace

FalconGuard::~FalconGuard()
{
  if (this->HasCalled)
  {
    close(this->Socket);
    return;
  }
  this->Dismiss();
}

bool FalconGuard::Start(const std::string& busPath)
{
  this->Dismiss();
  int sockets[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    return false;
  }
  std::string program = ProgramPath();
  std::string argument = busPath;
  char* const words[] = {program.data(), argument.data(), nullptr};
  const SpawnSettings settings(sockets[1]);
  const int error = posix_spawnp(&this->Process, program.c_str(), &settings.Files,
                                 &settings.Attributes, words, environ);
  close(sockets[1]);
  if (error != 0)
  {
    close(sockets[0]);
    return false;
  }
  this->Socket = sockets[0];
  this->HasCalled = false;
  return true;
}

void FalconGuard::Say(char word) const noexcept
{
  // Fails if the guard has ended, that is, has done its work.
  static_cast<void>(send(this->Socket, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT));
}

void FalconGuard::Call() noexcept
{
  if (this->IsRunning())
  {
    this->HasCalled = true;
    this->Say(Stop);
  }
}

void FalconGuard::Dismiss() noexcept
{
  if (!this->IsRunning())
  {
    return;
  }
  this->Say(Quit);
  close(this->Socket);
  this->Socket = -1;
  this->HasCalled = false;
  int status = 0;
  while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
  {
  }
}
} // namespace palpate
