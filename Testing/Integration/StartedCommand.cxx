#include "StartedCommand.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sys/prctl.h>
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
                                const TemporaryFolder& streams, StartedCommand::Errors errors)
{
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
  {
    std::signal(signal, SIG_DFL);
  }
  SendTo(streams / "out", STDOUT_FILENO);
  SendTo(streams / "err", STDERR_FILENO);
  std::array<int, 2> ends{};
  if (errors == StartedCommand::Errors::ReadByNobody && pipe(ends.data()) == 0)
  {
    close(ends[0]);
    dup2(ends[1], STDERR_FILENO);
  }
  // Never the user's; a test may choose one.
  setenv("PALPATE_CACHE_DIR", (streams / "cache").c_str(), 0);
  if (chdir(folder.c_str()) == 0)
  {
    execvp(words.front(), words.data());
  }
  _exit(127);
}
} // namespace

StartedCommand::StartedCommand(const std::string& program,
                               const std::vector<std::string>& arguments,
                               const std::filesystem::path& folder, Errors errors)
{
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> words;
  words.reserve(all.size() + 1);
  for (std::string& word : all)
  {
    words.push_back(word.data());
  }
  words.push_back(nullptr);
  this->Child = fork();
  if (this->Child == 0)
  {
    BecomeProgram(words, folder, this->Streams, errors);
  }
  setpgid(this->Child, this->Child); // whichever comes first
}

StartedCommand::~StartedCommand()
{
  if (!this->HasEnded())
  {
    kill(-this->Child, SIGKILL);
    waitpid(this->Child, nullptr, 0);
  }
}

void StartedCommand::Send(int signal) const
{
  kill(-this->Child, signal);
}

bool StartedCommand::HasTakenSignals() const
{
  std::ifstream status("/proc/" + std::to_string(this->Child) + "/status");
  for (std::string word; status >> word;)
  {
    std::string mask;
    if ((word == "SigPnd:" || word == "ShdPnd:") &&
        (!(status >> mask) || mask.find_first_not_of('0') != std::string::npos))
    {
      return false;
    }
  }
  return true;
}

bool StartedCommand::IsStopped() const
{
  std::ifstream status("/proc/" + std::to_string(this->Child) + "/status");
  std::string word;
  while (status >> word && word != "State:")
  {
  }
  return status >> word && word == "T";
}

bool StartedCommand::HasEnded()
{
  this->IsOver = this->IsOver || waitpid(this->Child, &this->Outcome, WNOHANG) == this->Child;
  return this->IsOver;
}

CommandRun StartedCommand::Finish()
{
  if (!this->IsOver)
  {
    this->IsOver = waitpid(this->Child, &this->Outcome, 0) == this->Child;
  }
  CommandRun run;
  run.Code = WIFEXITED(this->Outcome) ? WEXITSTATUS(this->Outcome) : -1;
  run.Output = ReadAll(this->Streams / "out");
  run.Errors = ReadAll(this->Streams / "err");
  return run;
}
} // namespace palpate::test
