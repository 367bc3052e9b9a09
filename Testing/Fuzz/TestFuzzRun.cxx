#include "FuzzRun.h"

#include "InputError.h"
#include "InputLimits.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

namespace palpate::test::fuzz_run_test
{
namespace
{
constexpr std::chrono::seconds LongEnough(600);

// Inputs are sequences of digits.
FuzzTarget Digits(InputReader read)
{
  return {"digits", "a.txt",
          [] {
            return std::vector<std::string>{"0", "00"};
          },
          [](std::string& bytes, Random& random)
          { bytes += static_cast<char>('0' + random() % 10); },
          [reader = std::move(read)] { return reader; }};
}

bool EndsWithSeven(const std::string& bytes)
{
  return bytes.back() == '7';
}

// Runs until `sevens` inputs end with 7 and expects exactly these to fail.
void ExpectSevensFail(const FuzzTarget& target, std::size_t sevens, const std::string& what)
{
  FuzzRun run(target, 5);
  std::set<std::uint64_t> expected;
  std::uint64_t inputs = 0;
  for (; expected.size() < sevens; ++inputs)
  {
    if (EndsWithSeven(run.Input(inputs)))
    {
      expected.insert(inputs);
    }
  }
  ++inputs; // the run continues after the last failure
  const FuzzAccount account = run.Run(inputs, LongEnough);
  EXPECT_EQ(account.Inputs(), inputs);
  std::set<std::uint64_t> found;
  for (const FuzzFailure& failure : account.Failures)
  {
    found.insert(failure.Number);
    EXPECT_EQ(failure.Bytes, run.Input(failure.Number));
    EXPECT_NE(failure.What.find(what), std::string::npos) << failure.What;
  }
  EXPECT_EQ(found, expected);
}

TEST(FuzzRun, CountsReadAndRefusedInputs)
{
  const FuzzTarget target = Digits(
      [](const std::string& bytes)
      {
        if (EndsWithSeven(bytes))
        {
          throw InputError("ends with 7");
        }
      });
  FuzzRun run(target, 5);
  std::uint64_t refused = 0;
  constexpr std::uint64_t Inputs = 5000; // more than one child process reads
  for (std::uint64_t n = 0; n < Inputs; ++n)
  {
    refused += EndsWithSeven(run.Input(n)) ? 1 : 0;
  }
  const FuzzAccount account = run.Run(Inputs, LongEnough);
  EXPECT_EQ(account.Refused, refused);
  EXPECT_EQ(account.Read, Inputs - refused);
  EXPECT_TRUE(account.Failures.empty());
}

TEST(FuzzRun, InputsDependOnTargetSeedAndNumber)
{
  const FuzzTarget target = Digits([](const std::string&) {});
  FuzzTarget other = target;
  other.Name = "other";
  int otherSeed = 0;
  int otherTarget = 0;
  for (std::uint64_t n = 2; n < 200; ++n)
  {
    EXPECT_EQ(FuzzRun(target, 5).Input(n), FuzzRun(target, 5).Input(n));
    otherSeed += FuzzRun(target, 5).Input(n) != FuzzRun(target, 6).Input(n) ? 1 : 0;
    otherTarget += FuzzRun(target, 5).Input(n) != FuzzRun(other, 5).Input(n) ? 1 : 0;
  }
  EXPECT_GT(otherSeed, 100);
  EXPECT_GT(otherTarget, 100);
}

TEST(FuzzRun, FindsCrashes)
{
  ExpectSevensFail(Digits(
                       [](const std::string& bytes)
                       {
                         if (EndsWithSeven(bytes))
                         {
                           std::abort();
                         }
                       }),
                   3, "ended the process");
}

TEST(FuzzRun, FindsUnexpectedExceptions)
{
  ExpectSevensFail(Digits(
                       [](const std::string& bytes)
                       {
                         if (EndsWithSeven(bytes))
                         {
                           throw std::out_of_range("seven");
                         }
                       }),
                   3, "let another exception out: seven");
}

TEST(FuzzRun, FindsEndlessLoops)
{
  ExpectSevensFail(Digits(
                       [](const std::string& bytes)
                       {
                         for (volatile bool goesOn = EndsWithSeven(bytes); goesOn;)
                         {
                         }
                       }),
                   1, "of processor time");
}

TEST(FuzzRun, FindsExcessiveMemory)
{
  ExpectSevensFail(Digits(
                       [](const std::string& bytes)
                       {
                         const std::uint64_t all = InputLimits::Bytes(bytes.size());
                         const std::vector<char> much(EndsWithSeven(bytes) ? all + (all >> 3) : 1,
                                                      'x');
                         ASSERT_EQ(much.back(), 'x');
                       }),
                   2, "MB of memory");
}

TEST(FuzzRun, FindsRefusedSeeds)
{
  const FuzzTarget target = Digits(
      [](const std::string& bytes)
      {
        if (bytes == "00")
        {
          throw InputError("two digits");
        }
      });
  const FuzzAccount account = FuzzRun(target, 5).Run(2, LongEnough);
  ASSERT_FALSE(account.Failures.empty());
  EXPECT_NE(account.Failures.front().What.find("two digits"), std::string::npos);
}

TEST(FuzzRun, EndsInTime)
{
  const FuzzTarget target = Digits([](const std::string&) {});
  const auto start = std::chrono::steady_clock::now();
  const FuzzAccount account =
      FuzzRun(target, 5).Run(std::numeric_limits<std::uint64_t>::max(), std::chrono::seconds(1));
  EXPECT_GT(account.Read, 0U);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(FuzzTargets, HaveUniqueNames)
{
  std::set<std::string> names;
  for (const FuzzTarget& target : FuzzTargets())
  {
    EXPECT_TRUE(names.insert(target.Name).second) << target.Name;
  }
  EXPECT_GE(names.size(), 30U);
  EXPECT_THROW(FindFuzzTarget("nothing"), std::invalid_argument);
}
} // namespace
} // namespace palpate::test::fuzz_run_test
