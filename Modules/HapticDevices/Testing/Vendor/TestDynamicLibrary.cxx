#include "DynamicLibrary.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace palpate::dynamic_library_test
{
namespace
{
TEST(DynamicLibrary, FirstNameThatTheSystemFindsIsOpened)
{
  DynamicLibrary library("PALPATE_NO_SUCH_VARIABLE", {"libno-such.so", "libm.so.6"});
  ASSERT_TRUE(library.IsOpen());
  double (*cosine)(double) = nullptr;
  library.Find("cos", cosine);
  EXPECT_TRUE(library.IsWhole());
  EXPECT_EQ(cosine(0.0), 1.0);
  library.Find("no_such_function", cosine);
  EXPECT_FALSE(library.IsWhole());
}

TEST(DynamicLibrary, OnlyTheGivenOneIsOpened)
{
  setenv("PALPATE_TEST_LIBRARY", "/no/such/library.so", 1);
  EXPECT_FALSE(DynamicLibrary("PALPATE_TEST_LIBRARY", {"libm.so.6"}).IsOpen());
  unsetenv("PALPATE_TEST_LIBRARY");
}
} // namespace
} // namespace palpate::dynamic_library_test
