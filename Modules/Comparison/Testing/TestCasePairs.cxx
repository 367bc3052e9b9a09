#include "CasePairs.h"

#include "InputError.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::case_pairs_test
{
namespace
{
using namespace palpate::test;

// Files of these names; nothing reads them here.
void MakeFiles(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
  std::filesystem::create_directories(folder);
  for (const std::string& name : names)
  {
    WriteAll(folder / name, "-");
  }
}

TEST(CasePairs, FoldersArePairedByNamesWithoutEndings)
{
  const TemporaryFolder folder;
  MakeFiles(folder / "one", {"a.nii.gz", "b.nii.gz", "c.1.nrrd", "alone.nii.gz"});
  MakeFiles(folder / "two", {"c.1.nii", "b.mha", "a.nii.gz", "other.nii.gz"});
  const CasePairs pairs = CasePairs::OfFolders(folder / "one", folder / "two");
  ASSERT_EQ(pairs.Pairs.size(), 3u);
  EXPECT_EQ(pairs.Pairs[0].Case, "a");
  EXPECT_EQ(pairs.Pairs[1].One, folder / "one" / "b.nii.gz");
  EXPECT_EQ(pairs.Pairs[1].Other, folder / "two" / "b.mha");
  EXPECT_EQ(pairs.Pairs[2].Case, "c.1");
  ASSERT_EQ(pairs.Unpaired.size(), 2u);
  EXPECT_NE(pairs.Unpaired[0].find("alone.nii.gz has no partner"), std::string::npos);
  EXPECT_NE(pairs.Unpaired[1].find("other.nii.gz has no partner"), std::string::npos);
}

TEST(CasePairs, ModelsArePairedWithMasks)
{
  const TemporaryFolder folder;
  MakeFiles(folder / "masks", {"a.nii.gz", "b.nii.gz"});
  MakeFiles(folder / "models", {"a.json", "b.coef", "notes.txt"});
  const CasePairs pairs = CasePairs::OfFolders(folder / "masks", folder / "models");
  ASSERT_EQ(pairs.Pairs.size(), 2u);
  EXPECT_EQ(pairs.Pairs[1].Other, folder / "models" / "b.coef");
}

TEST(CasePairs, FoldersWithoutCommonNamesAreRefused)
{
  const TemporaryFolder folder;
  MakeFiles(folder / "one", {"a.nii.gz"});
  MakeFiles(folder / "two", {"b.nii.gz"});
  MakeFiles(folder / "empty", {});
  EXPECT_NE(MessageOf([&] { CasePairs::OfFolders(folder / "one", folder / "two"); })
                .find("no two files of one name"),
            std::string::npos);
  EXPECT_THROW(CasePairs::OfFolders(folder / "one", folder / "empty"), InputError);
}

TEST(CasePairs, TableListsPairs)
{
  const TemporaryFolder folder;
  WriteAll(folder / "pairs.csv", "case,first,reference,label\n"
                                 "p1,r1/x.nii.gz,r2/y.nii.gz,Prostate\n"
                                 ",r1/z.nii.gz,model.json,\n");
  const CasePairs pairs = CasePairs::OfTable(folder / "pairs.csv");
  ASSERT_EQ(pairs.Pairs.size(), 2u);
  EXPECT_EQ(pairs.Pairs[0].Case, "p1");
  EXPECT_EQ(pairs.Pairs[0].Label, "Prostate");
  EXPECT_EQ(pairs.Pairs[0].Other, folder.Path() / "r2/y.nii.gz");
  EXPECT_EQ(pairs.Pairs[1].Case, "z");
}

TEST(CasePairs, TableWithoutColumnsOrWithOneCaseTwiceIsRefused)
{
  const TemporaryFolder folder;
  WriteAll(folder / "head.csv", "mask,model\na,b\n");
  WriteAll(folder / "twice.csv", "case,first,reference\np,a,b\nP,c,d\n");
  WriteAll(folder / "empty.csv", "first,reference\n");
  EXPECT_THROW(CasePairs::OfTable(folder / "head.csv"), InputError);
  EXPECT_THROW(CasePairs::OfTable(folder / "twice.csv"), InputError);
  EXPECT_THROW(CasePairs::OfTable(folder / "empty.csv"), InputError);
}
} // namespace
} // namespace palpate::case_pairs_test
