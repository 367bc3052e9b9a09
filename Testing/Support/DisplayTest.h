#pragma once

#include "DisplayServer.h"

#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>

namespace palpate::test
{
/// Tests that draw with OpenGL; skipped, saying so, where there is no X server and none can be
/// started.
class DisplayTest : public testing::Test
{
protected:
  void SetUp() override
  {
    try
    {
      this->Display = std::make_unique<DisplayServer>();
    }
    catch (const std::runtime_error& error)
    {
      GTEST_SKIP() << error.what();
    }
  }

private:
  std::unique_ptr<DisplayServer> Display;
};
} // namespace palpate::test
