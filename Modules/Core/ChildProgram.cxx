#include "ChildProgram.h"

#include <cerrno>
#include <csignal>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate
{
namespace
{
namespace fs = std::filesystem;

// Without a slash the program is looked for on the PATH.
std::string ProgramPath(const std::string& name)
{
  std::error_code unknown;
  std::vector<fs::path> places{fs::read_symlink("/proc/self/exe", unknown).parent_path() / name};
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&StartChildProgram), &library) != 0)
  {
    // The link of the library's name may lie in another folder than its file.
    const fs::path folder = fs::weakly_canonical(library.dli_fname, unknown).parent_path();
    places.push_back(folder.parent_path() / "bin" / name);
    places.push_back(folder.parent_path().parent_path() / "bin" / name);
  }
  for (const fs::path& place : places)
  {
    if (access(place.c_str(), X_OK) == 0)
    {
      return place.string();
    }
  }
  return name;
}

// Everything of this process but `input` stays here, so that the child holds no pipe open that
// somebody waits for, and no device.
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

pid_t StartChildProgram(const std::string& name, const std::vector<std::string>& arguments,
                        int input)
{
  std::vector<std::string> words{ProgramPath(name)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const SpawnSettings settings(input);
  pid_t process = -1;
  const int error = posix_spawnp(&process, words.front().c_str(), &settings.Files,
                                 &settings.Attributes, pointers.data(), environ);
  return error == 0 ? process : -1;
}

void WaitForChildProgram(pid_t process) noexcept
{
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR)
  {
  }
}
} // namespace palpate
