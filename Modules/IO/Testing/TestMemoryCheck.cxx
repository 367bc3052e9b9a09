#include "MemoryCheck.h"
#include "MessageOf.h"

#include <gtest/gtest.h>
#include <limits>

using namespace palpate;
using namespace palpate::test;

TEST(MemoryCheck, CountsDataTwice)
{
  EXPECT_NO_THROW(CheckMemory("x.nii", 500.0, 1000));
  EXPECT_EQ(
      MessageOf([] { CheckMemory("x.nii", 2e9, 1000000000); }),
      "x.nii needs about 4 GB of memory to read but 1 GB are free; crop or resample it, or use "
      "a larger machine.");
  EXPECT_NE(MessageOf([] { CheckMemory("x.nii", std::numeric_limits<double>::quiet_NaN(), 1000); }),
            "no error");
}
