#include "CancelDeadline.h"
#include "Console.h"
#include "Interruption.h"

#include <gtest/gtest.h>

#include <csignal>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace palpate::cancel_deadline_test
{
namespace
{
// Each dies in a process of its own, since the program ends.
TEST(CancelDeadlineDeathTest, EndsTheProgramIfTheWorkDoesNotReact)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto work = []
  {
    const Interruption interruption;
    cli::Console console(std::cout, std::cerr, false);
    std::raise(SIGINT);
    cli::Cancellably(console,
                     []
                     {
                       while (true)
                       {
                         pause();
                       }
                     });
  };
  EXPECT_EXIT(work(), testing::ExitedWithCode(130), "palpate: cancelled");
}

TEST(CancelDeadline, WorkThatReactsKeepsItsResult)
{
  const Interruption interruption;
  std::ostringstream said;
  cli::Console console(said, said, false);
  const int result = cli::Cancellably(console,
                                      []
                                      {
                                        std::raise(SIGTERM);
                                        return Interruption::WasAsked() ? 7 : 0;
                                      });
  EXPECT_EQ(result, 7);
  EXPECT_EQ(said.str(), "");
}
} // namespace
} // namespace palpate::cancel_deadline_test
