#include "FuzzRun.h"
#include "InputError.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <map>

// Driver for all targets, see README.md in this folder.
namespace
{
using namespace palpate;
using namespace palpate::test;

struct Options
{
  std::vector<std::string> Targets;
  std::uint64_t Inputs = std::numeric_limits<std::uint64_t>::max();
  double Seconds = 0.0;
  std::uint64_t Seed = 1;
  std::filesystem::path Output = "fuzz-failures";
  std::string Replay;
  bool Lists = false;
};

// Reads one file in this process, for use with a debugger.
int Replay(const FuzzTarget& target, const std::string& file)
{
  try
  {
    target.MakeReader()(ReadAll(file));
    std::cout << "read\n";
  }
  catch (const InputError& refusal)
  {
    std::cout << "refused: " << refusal.what() << "\n";
  }
  return 0;
}

void Save(const FuzzTarget& target, const FuzzFailure& failure, const Options& options)
{
  const std::filesystem::path file =
      options.Output / (target.Name + "-" + std::to_string(options.Seed) + "-" +
                        std::to_string(failure.Number) + "-" + target.FileName);
  std::filesystem::create_directories(options.Output);
  WriteAll(file, failure.Bytes);
  // Present if the sanitizers write their reports into the same folder.
  const auto report = options.Output / ("report." + std::to_string(failure.Process));
  std::error_code none;
  std::filesystem::rename(report, file.string() + ".txt", none);
  std::cout << "  " << file.string() << " " << failure.What << "\n";
}

FuzzAccount RunTarget(const FuzzTarget& target, const Options& options, std::size_t share)
{
  const double seconds = options.Seconds > 0.0 ? options.Seconds / static_cast<double>(share) : 1e9;
  const FuzzAccount account =
      FuzzRun(target, options.Seed).Run(options.Inputs, std::chrono::duration<double>(seconds));
  std::printf("%-30s %10llu %10llu %10llu %8zu %9.0f %8.0f\n", target.Name.c_str(),
              static_cast<unsigned long long>(account.Inputs()),
              static_cast<unsigned long long>(account.Read),
              static_cast<unsigned long long>(account.Refused), account.Failures.size(),
              1e3 * account.LongestSeconds, 1e-6 * static_cast<double>(account.LargestBytes));
  std::fflush(stdout);
  // Keep the first three of each kind.
  std::map<std::string, int> kinds;
  for (const FuzzFailure& failure : account.Failures)
  {
    if (++kinds[failure.What] <= 3)
    {
      Save(target, failure, options);
    }
  }
  return account;
}

int RunAll(const Options& options)
{
  std::vector<const FuzzTarget*> targets;
  for (const std::string& name : options.Targets)
  {
    targets.push_back(&FindFuzzTarget(name));
  }
  for (std::size_t i = 0; options.Targets.empty() && i < FuzzTargets().size(); ++i)
  {
    targets.push_back(&FuzzTargets()[i]);
  }
  // Removes the readers' files even if their processes crash.
  const TemporaryFolder scratch;
  setenv("TMPDIR", scratch.Path().c_str(), 1);
  std::printf("%-30s %10s %10s %10s %8s %9s %8s\n", "reader", "inputs", "read", "refused",
              "failures", "most ms", "most MB");
  std::uint64_t inputs = 0;
  std::size_t failures = 0;
  for (const FuzzTarget* target : targets)
  {
    const FuzzAccount account = RunTarget(*target, options, targets.size());
    inputs += account.Inputs();
    failures += account.Failures.size();
  }
  std::cout << inputs << " inputs of seed " << options.Seed << ", " << failures << " failures\n";
  return failures == 0 && inputs > 0 ? 0 : 1;
}
} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app(
      "Reads mutated files by every reader; inputs that are neither read nor refused fail");
  app.add_option("targets", options.Targets, "Readers (see --list); all by default");
  app.add_option("--inputs", options.Inputs, "Number of inputs per reader");
  app.add_option("--seconds", options.Seconds, "Total time, shared among the readers");
  app.add_option("--seed", options.Seed, "Seed of the mutations");
  app.add_option("--output", options.Output, "Folder for inputs that fail");
  app.add_option("--replay", options.Replay, "Reads this file by the given reader in this process");
  app.add_flag("--list", options.Lists, "Lists the readers");
  CLI11_PARSE(app, argc, argv);
  try
  {
    if (options.Lists)
    {
      for (const FuzzTarget& target : FuzzTargets())
      {
        std::cout << target.Name << "\n";
      }
      return 0;
    }
    if (!options.Replay.empty())
    {
      return Replay(FindFuzzTarget(options.Targets.empty() ? "" : options.Targets.front()),
                    options.Replay);
    }
    if (options.Seconds <= 0.0 && options.Inputs == Options().Inputs)
    {
      throw std::invalid_argument("missing --inputs or --seconds");
    }
    return RunAll(options);
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
