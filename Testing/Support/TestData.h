#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace palpate::test
{
/// Path of a real test file; the folder is the CMake entry PALPATE_TEST_DATA.
inline std::filesystem::path DataPath(const std::string& name)
{
  return std::filesystem::path(PALPATE_TEST_DATA) / name;
}
} // namespace palpate::test

/// Skips the test, with a message, if a real data file is absent.
#define PALPATE_REQUIRE_FILE(path)                                                                 \
  if (!std::filesystem::exists(path))                                                              \
  {                                                                                                \
    GTEST_SKIP() << "real data absent: " << (path);                                                \
  }
