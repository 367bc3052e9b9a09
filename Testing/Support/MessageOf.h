#pragma once

#include "InputError.h"

#include <gtest/gtest.h>
#include <string>

namespace palpate::test
{
/// The message of the InputError thrown by `action`.
template <typename Action>
std::string MessageOf(const Action& action)
{
  try
  {
    action();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "no error";
}

/// EXPECT_TRUE(Contains(text, part)) shows the text when it fails.
inline testing::AssertionResult Contains(const std::string& text, const std::string& part)
{
  if (text.find(part) != std::string::npos)
  {
    return testing::AssertionSuccess() << text;
  }
  return testing::AssertionFailure() << "no '" << part << "' in: " << text;
}
} // namespace palpate::test
