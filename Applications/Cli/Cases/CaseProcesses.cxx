#include "CaseProcesses.h"

#include "Console.h"
#include "Interruption.h"
#include "Progress.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <map>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palpate::cli
{
namespace
{
bool WriteAll(int file, const std::string& text)
{
  for (std::size_t done = 0; done < text.size();)
  {
    const ssize_t count = write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  return true;
}

// Each text after its length in a line of its own.
std::string Packed(const CaseOutput& output)
{
  std::string bytes;
  for (const std::string* text : {&output.Results, &output.Messages, &output.Record})
  {
    bytes += std::to_string(text->size()) + '\n' + *text;
  }
  return bytes;
}

CaseOutput Unpacked(const std::string& bytes)
{
  CaseOutput output;
  std::size_t from = 0;
  for (std::string* text : {&output.Results, &output.Messages, &output.Record})
  {
    const std::size_t line = bytes.find('\n', from);
    const std::size_t length = std::stoul(bytes.substr(from, line - from));
    *text = bytes.substr(line + 1, length);
    from = line + 1 + length;
  }
  return output;
}

std::string ReasonOf(int status)
{
  return WIFSIGNALED(status) ? "its process was ended by signal " + std::to_string(WTERMSIG(status))
         : WEXITSTATUS(status) != 0 ? "its process ended without a result"
                                    : std::string();
}

struct Child
{
  std::size_t Case = 0;
  pid_t Process = -1;
  int Pipe = -1;
  std::string Text;
};

class ProcessPool
{
public:
  explicit ProcessPool(const std::function<CaseOutput(std::size_t)>& run) : Run(run) {}
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;
  ~ProcessPool()
  {
    for (const Child& child : this->Children)
    {
      kill(child.Process, SIGTERM);
    }
    for (Child& child : this->Children)
    {
      Await(child);
    }
  }

  std::size_t Size() const { return this->Children.size(); }

  void Start(std::size_t number)
  {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
    {
      throw std::runtime_error("no further process can be started; try fewer --jobs");
    }
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process == 0)
    {
      // A case ends with the process that asked for it, however that ends.
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      close(ends[0]);
      if (getppid() != parent)
      {
        _exit(EXIT_FAILURE);
      }
      this->RunChild(number, ends[1]);
    }
    close(ends[1]);
    if (process < 0)
    {
      close(ends[0]);
      throw std::runtime_error("no further process can be started; try fewer --jobs");
    }
    this->Children.push_back({number, process, ends[0], {}});
  }

  // Waits until a child writes or ends; returns those that ended, with their status.
  std::vector<std::pair<Child, int>> Wait()
  {
    std::vector<pollfd> files;
    for (const Child& child : this->Children)
    {
      files.push_back({child.Pipe, POLLIN, 0});
    }
    std::vector<std::pair<Child, int>> ended;
    if (poll(files.data(), files.size(), -1) <= 0)
    {
      return ended; // by a signal
    }
    std::vector<Child> left;
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      Child& child = this->Children[i];
      if (files[i].revents != 0 && !TakeText(child))
      {
        const int status = Await(child);
        ended.emplace_back(std::move(child), status);
      }
      else
      {
        left.push_back(std::move(child));
      }
    }
    this->Children = std::move(left);
    return ended;
  }

private:
  [[noreturn]] void RunChild(std::size_t number, int file) const
  {
    // The other cases use the other processors.
    vtkSMPTools::Initialize(1);
    int code = EXIT_FAILURE;
    try
    {
      code = WriteAll(file, Packed(this->Run(number))) ? 0 : EXIT_FAILURE;
    }
    catch (const std::exception&)
    {
      // Cancelled, or without memory: the parent sees that there is no result.
    }
    _exit(code); // without the parent's unwritten output and its objects' destructors
  }

  // False at the end of the text.
  static bool TakeText(Child& child)
  {
    std::array<char, 4096> bytes{};
    const ssize_t count = read(child.Pipe, bytes.data(), bytes.size());
    if (count > 0)
    {
      child.Text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return count > 0 || (count < 0 && errno == EINTR);
  }

  static int Await(Child& child)
  {
    close(child.Pipe);
    int status = 0;
    while (waitpid(child.Process, &status, 0) < 0 && errno == EINTR)
    {
    }
    return status;
  }

  const std::function<CaseOutput(std::size_t)>& Run;
  std::vector<Child> Children;
};
} // namespace

void RunInProcesses(
    std::size_t count, unsigned jobs, const std::function<CaseOutput(std::size_t)>& run,
    const std::function<void(std::size_t, const CaseOutput&, const std::string& reason)>& take,
    const std::function<void(std::size_t ended)>& step)
{
  ProcessPool pool(run);
  std::map<std::size_t, std::pair<CaseOutput, std::string>> waiting; // for cases before them
  std::size_t started = 0;
  std::size_t taken = 0;
  while (taken < count)
  {
    for (; started < count && pool.Size() < jobs; ++started)
    {
      pool.Start(started);
    }
    for (const auto& [child, status] : pool.Wait())
    {
      const std::string reason = ReasonOf(status);
      waiting[child.Case] = {reason.empty() ? Unpacked(child.Text) : CaseOutput(), reason};
    }
    if (Interruption::WasAsked())
    {
      throw Cancelled();
    }
    step(taken + waiting.size());
    for (auto next = waiting.find(taken); next != waiting.end(); next = waiting.find(++taken))
    {
      take(taken, next->second.first, next->second.second);
      waiting.erase(next);
    }
  }
}

void RunCases(std::size_t count, unsigned jobs, Console& console,
              const std::function<std::string(std::size_t, Console&)>& run,
              const std::function<void(std::size_t, const std::string&, const std::string&)>& take)
{
  if (jobs > 1 && count > 1)
  {
    RunInProcesses(
        count, jobs,
        [&](std::size_t number)
        {
          std::ostringstream results;
          std::ostringstream messages;
          Console own(results, messages, false);
          own.SetQuiet(console.IsQuiet());
          std::string record = run(number, own);
          return CaseOutput{results.str(), messages.str(), std::move(record)};
        },
        [&](std::size_t number, const CaseOutput& output, const std::string& reason)
        {
          console.Relay(output.Results, output.Messages);
          take(number, output.Record, reason);
        },
        [&](std::size_t ended)
        {
          console.Progress(static_cast<double>(ended) / static_cast<double>(count),
                           std::to_string(ended) + " of " + std::to_string(count) + " cases");
        });
  }
  else
  {
    for (std::size_t number = 0; number < count; ++number)
    {
      if (Interruption::WasAsked())
      {
        throw Cancelled();
      }
      take(number, run(number, console), {});
    }
  }
  console.EndProgress();
}
} // namespace palpate::cli
