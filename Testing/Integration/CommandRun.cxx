#include "CommandRun.h"

#include "TemporaryFolder.h"

#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate::test
{
namespace
{
void SendTo(const std::filesystem::path& file, int descriptor)
{
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
}

[[noreturn]] void BecomeProgram(std::vector<char*>& words, const std::filesystem::path& folder,
                                const TemporaryFolder& streams)
{
  SendTo(streams / "out", STDOUT_FILENO);
  SendTo(streams / "err", STDERR_FILENO);
  unsetenv("DISPLAY");
  if (chdir(folder.c_str()) == 0)
  {
    execvp(words.front(), words.data());
  }
  _exit(127);
}
} // namespace

CommandRun RunCommand(const std::string& program, const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder)
{
  const TemporaryFolder streams;
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  words.reserve(all.size() + 1);
  for (std::string& word : all)
  {
    words.push_back(word.data());
  }
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0)
  {
    BecomeProgram(words, folder, streams);
  }
  int status = 0;
  CommandRun run;
  if (waitpid(child, &status, 0) == child && WIFEXITED(status))
  {
    run.Code = WEXITSTATUS(status);
  }
  run.Output = ReadAll(streams / "out");
  run.Errors = ReadAll(streams / "err");
  return run;
}

CommandRun RunPalpate(const std::vector<std::string>& arguments,
                      const std::filesystem::path& folder)
{
  return RunCommand(PALPATE_PROGRAM, arguments, folder);
}
} // namespace palpate::test
