#include "FileEnding.h"

#include <gtest/gtest.h>

using palpate::FileEnding;

TEST(FileEnding, IsLowerCaseWithItsDot)
{
  EXPECT_EQ(FileEnding("a/b.VTP"), ".vtp");
  EXPECT_EQ(FileEnding("case.1.json"), ".json");
}

TEST(FileEnding, RecognizesCompoundEndings)
{
  EXPECT_EQ(FileEnding("a.Nii.Gz"), ".nii.gz");
  EXPECT_EQ(FileEnding("a.seg.nrrd"), ".seg.nrrd");
  EXPECT_EQ(FileEnding("a.x.nrrd"), ".nrrd");
}

TEST(FileEnding, IsEmptyWithoutADot)
{
  EXPECT_EQ(FileEnding("folder.d/model"), "");
  EXPECT_EQ(FileEnding(""), "");
}
