#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

namespace palpate::test
{
/// Whether `condition` holds for a user who may not write everywhere, as root may. It is asked in a
/// child process, which gives up root's rights where it has them.
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
} // namespace palpate::test
