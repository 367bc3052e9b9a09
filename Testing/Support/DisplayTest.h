#pragma once

#include "DisplayCheck.h"

#include <gtest/gtest.h>

namespace palpate::test
{
/// Tests that draw with OpenGL. They need an X server: Utilities/test.sh runs them under xvfb-run.
class DisplayTest : public testing::Test
{
protected:
  void SetUp() override { ASSERT_NO_THROW(RequireDisplay()); }
};
} // namespace palpate::test
