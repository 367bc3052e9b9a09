#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace palpate::test
{
/// Whether `condition` holds for a user who may not write everywhere, unlike root. Evaluated in a
/// child process, which drops root's rights if it has them.
template <typename Condition>
bool HoldsUnprivileged(const Condition& condition)
{
  bool holds = false;
  const auto ask = [&condition]
  {
    constexpr uid_t Nobody = 65534;
    const bool isUnprivileged = geteuid() != 0 || setuid(Nobody) == 0;
    _exit(isUnprivileged && condition() ? 0 : 1);
  };
  const auto ended = [&holds](int status)
  {
    holds = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return true;
  };
  EXPECT_EXIT(ask(), ended, "");
  return holds;
}

/// For root, in a test of missing permissions: runs that test again in a process of the user
/// nobody, and fails if it fails. Skips if nobody may not run this program.
inline void RunAgainUnprivileged()
{
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(test->test_suite_name()) + "." + test->name();
  const std::string nobody = "env -u UMOCKDEV_DIR setpriv --reuid=65534 --regid=65534 "
                             "--clear-groups '";
  const std::string quiet = "' --gtest_brief=1 --gtest_filter=";
  if (std::system((nobody + program + quiet + "None").c_str()) != 0)
  {
    GTEST_SKIP() << "nobody may not run " << program;
  }
  EXPECT_EQ(std::system((nobody + program + quiet + name).c_str()), 0);
}
} // namespace palpate::test
