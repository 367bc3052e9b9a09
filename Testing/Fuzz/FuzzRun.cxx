#include "FuzzRun.h"

#include "InputError.h"
#include "InputLimits.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace palpate::test
{
/// Progress of a child, in memory shared with its parent.
struct FuzzRun::Progress
{
  std::uint64_t Number = 0; ///< current or next input
  std::uint64_t Read = 0;
  std::uint64_t Refused = 0;
  double LongestSeconds = 0.0;
  std::uint64_t LargestBytes = 0;
  char Problem[1000] = {};

  void Say(const char* text) { std::snprintf(this->Problem, sizeof(this->Problem), "%s", text); }
};

namespace
{
// Exit codes of a child that reports a problem: with one input, or before the first.
constexpr int ReportedProblem = 77;
constexpr int CannotBegin = 78;
constexpr std::uint64_t InputsOfChild = 2000; // limits the effect of leaks in libraries

// Of this process and of the decoders that it has waited for.
double ProcessorSeconds()
{
  const auto seconds = [](const timeval& t)
  { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  double sum = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN})
  {
    rusage usage{};
    getrusage(who, &usage);
    sum += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  return sum;
}

// The largest of all so far, with its program and libraries. Linux counts what a child shares with
// this process between fork and exec, so that a peak below this process's own says nothing.
std::uint64_t DecoderPeakBytes()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

// Peak of resident memory since ForgetPeak, or since the start if the system does not support it.
std::uint64_t PeakBytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

void ForgetPeak()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}

// Address space and resident memory, from /proc/self/statm.
struct ProcessSize
{
  std::uint64_t Addresses = 0;
  std::uint64_t Resident = 0;

  ProcessSize()
  {
    std::ifstream("/proc/self/statm") >> this->Addresses >> this->Resident;
    const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    this->Addresses *= page;
    this->Resident *= page;
  }
};

void LimitSoftly(int resource, rlim_t most)
{
  rlimit limit{};
  getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  limit.rlim_cur = std::min(most, limit.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

// Ends the process with SIGPROF after this much processor time; 0 removes the limit.
void LimitTime(double seconds)
{
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// Not under sanitizers, whose shadow memory needs more address space than any limit.
void LimitAddresses()
{
  if (InputLimits::MemoryFactor == 1)
  {
    LimitSoftly(RLIMIT_AS, ProcessSize().Addresses + InputLimits::Addresses);
  }
}

std::string EndOf(int status, const char* problem, std::size_t inputSize)
{
  if (WIFEXITED(status) &&
      (WEXITSTATUS(status) == ReportedProblem || WEXITSTATUS(status) == CannotBegin))
  {
    return problem;
  }
  if (WIFEXITED(status))
  {
    return "ended the process with code " + std::to_string(WEXITSTATUS(status));
  }
  switch (WTERMSIG(status))
  {
  case SIGPROF:
    return "took more than " + std::to_string(InputLimits::Seconds(inputSize)) +
           " s of processor time";
  case SIGALRM:
    return "hung";
  default:
    return std::string("ended the process: ") + strsignal(WTERMSIG(status));
  }
}
} // namespace

FuzzRun::FuzzRun(const FuzzTarget& target, std::uint64_t seed)
    : Target(target), Seed(seed), Seeds(target.MakeSeeds())
{
}

std::string FuzzRun::Input(std::uint64_t number) const
{
  if (number < this->Seeds.size())
  {
    return this->Seeds[number];
  }
  // Targets get different random numbers for the same seed; FNV-1a is the same on every machine.
  std::uint64_t mixed = 0xCBF29CE484222325;
  for (const char sign : this->Target.Name)
  {
    mixed = (mixed ^ static_cast<unsigned char>(sign)) * 0x100000001B3;
  }
  std::seed_seq sequence{this->Seed, this->Seed >> 32, mixed, mixed >> 32, number, number >> 32};
  Random random(sequence);
  std::string bytes = Choose(this->Seeds, random);
  static constexpr int Mutations[] = {1, 1, 1, 2, 3};
  for (int n = Choose(Mutations, random); n > 0; --n)
  {
    this->Target.Mutate(bytes, random);
    bytes.resize(std::min(bytes.size(), InputLimits::LargestInput));
  }
  return bytes;
}

void FuzzRun::ReadOne(const InputReader& read, Progress& progress) const
{
  const std::string bytes = this->Input(progress.Number);
  ForgetPeak();
  const std::uint64_t before = ProcessSize().Resident;
  const std::uint64_t earlierPeak = PeakBytes();
  const std::uint64_t earlierDecoder = DecoderPeakBytes();
  const double start = ProcessorSeconds();
  LimitAddresses();
  alarm(InputLimits::HangSeconds);
  LimitTime(InputLimits::Seconds(bytes.size()));
  bool isRead = true;
  try
  {
    read(bytes);
  }
  catch (const InputError& error)
  {
    isRead = false;
    progress.Say(error.what());
  }
  catch (const std::exception& error)
  {
    progress.Say((std::string("let another exception out: ") + error.what()).c_str());
    _exit(ReportedProblem);
  }
  LimitTime(0.0);
  alarm(0);
  const std::uint64_t peak = PeakBytes();
  const std::uint64_t own = peak > std::max(before, earlierPeak) ? peak - before : 0;
  const std::uint64_t decoder = DecoderPeakBytes();
  const std::uint64_t used = std::max(own, decoder > std::max(earlierDecoder, peak) ? decoder : 0);
  const double seconds = ProcessorSeconds() - start;
  progress.LargestBytes = std::max(progress.LargestBytes, used);
  progress.LongestSeconds = std::max(progress.LongestSeconds, seconds);
  if (seconds > InputLimits::Seconds(bytes.size()))
  {
    progress.Say("took too much processor time, with its decoder");
    _exit(ReportedProblem);
  }
  if (used > InputLimits::Bytes(bytes.size()))
  {
    progress.Say(("took " + std::to_string(used >> 20) + " MB of memory").c_str());
    _exit(ReportedProblem);
  }
  ++(isRead ? progress.Read : progress.Refused);
}

void FuzzRun::ReadInChild(Progress& progress, std::uint64_t end, Clock::time_point until)
{
  constexpr rlim_t Stack = rlim_t{8} << 20; // Debian's
  LimitSoftly(RLIMIT_STACK, Stack);
  LimitSoftly(RLIMIT_CORE, 0);
  try
  {
    const InputReader read = this->Target.MakeReader();
    // Loads and maps what the first use of a library needs, which counts for no input.
    for (const std::string& seed : this->Seeds)
    {
      read(seed);
    }
    for (; progress.Number < end && Clock::now() < until; ++progress.Number)
    {
      this->ReadOne(read, progress);
    }
  }
  catch (const std::exception& error)
  {
    progress.Say((std::string("cannot read its seeds: ") + error.what()).c_str());
    _exit(CannotBegin);
  }
  _exit(0);
}

FuzzAccount FuzzRun::Run(std::uint64_t inputs, std::chrono::duration<double> time)
{
  // A longer duration could overflow the clock.
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::min(time, std::chrono::duration<double>(1e9)));
  void* shared =
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED)
  {
    throw std::system_error(errno, std::generic_category(), "no memory to share");
  }
  auto* progress = new (shared) Progress;
  FuzzAccount account;
  while (progress->Number < inputs && Clock::now() < until &&
         account.Failures.size() < MostFailures)
  {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0)
    {
      this->ReadInChild(*progress, std::min(inputs, progress->Number + InputsOfChild), until);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
    {
      throw std::system_error(errno, std::generic_category(), "no child process");
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    {
      std::string bytes = this->Input(progress->Number);
      const std::string what = EndOf(status, progress->Problem, bytes.size());
      account.Failures.push_back({progress->Number++, what, std::move(bytes), child});
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == CannotBegin)
    {
      break;
    }
  }
  account.Read = progress->Read;
  account.Refused = progress->Refused;
  account.LongestSeconds = progress->LongestSeconds;
  account.LargestBytes = progress->LargestBytes;
  munmap(shared, sizeof(Progress));
  return account;
}
} // namespace palpate::test
