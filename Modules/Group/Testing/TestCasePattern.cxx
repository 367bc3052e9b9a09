#include "CasePattern.h"

#include "InputError.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::case_pattern_test
{
namespace
{
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

/// Files without content: a pattern looks at names only.
class CasePattern : public testing::Test
{
protected:
  void Add(const std::string& path) const
  {
    const std::filesystem::path file = this->Folder / path;
    std::filesystem::create_directories(file.parent_path());
    WriteAll(file, "");
  }
  std::vector<std::string> IdsOf(const std::string& pattern) const
  {
    std::vector<std::string> ids;
    for (const CohortCase& one : FindPatternCases((this->Folder / pattern).string()))
    {
      ids.push_back(one.Name);
    }
    return ids;
  }
  /// The message without the folder, or "" if the pattern is taken.
  std::string RefusalOf(const std::string& pattern) const
  {
    try
    {
      this->IdsOf(pattern);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }

  TemporaryFolder Folder;
};

using Ids = std::vector<std::string>;

TEST_F(CasePattern, FindsTheFilesOfABidsFolder)
{
  for (const char* id : {"02", "01", "10"})
  {
    const std::string start = std::string("seg/sub-") + id + "/anat/sub-" + id;
    this->Add(start + "_T2w_dseg.nii.gz");
    this->Add(start + "_T2w_dseg.json");
    this->Add(start + "_T2w.nii.gz");
  }
  this->Add("seg/sub-03/anat/sub-04_T2w_dseg.nii.gz"); // another subject's
  this->Add("seg/participants.tsv");
  EXPECT_EQ(this->IdsOf("seg/sub-{id}/anat/sub-{id}_*_dseg.nii.gz"), (Ids{"01", "02", "10"}));
  EXPECT_EQ(FindPatternCases((this->Folder / "seg/sub-{id}/anat/sub-{id}_*_dseg.nii.gz").string())
                .front()
                .Mask,
            this->Folder / "seg/sub-01/anat/sub-01_T2w_dseg.nii.gz");
}

TEST_F(CasePattern, IdIsTheShortestTextThatMatches)
{
  this->Add("10005_1000005_seg.nii.gz");
  EXPECT_EQ(this->IdsOf("{id}_*.nii.gz"), Ids{"10005"});
  EXPECT_EQ(this->IdsOf("{id}_seg.nii.gz"), Ids{"10005_1000005"});
  EXPECT_EQ(this->IdsOf("*_{id}_seg.nii.gz"), Ids{"1000005"});
  EXPECT_EQ(this->IdsOf("{id}.nii.gz"), Ids{"10005_1000005_seg"});
}

TEST_F(CasePattern, StarStaysWithinOneNameAndSkipsHiddenFiles)
{
  this->Add("a/deep/x1.stl");
  this->Add("a/x2.stl");
  this->Add("a/.x3.stl");
  EXPECT_EQ(this->IdsOf("*/x{id}.stl"), Ids{"2"});
  EXPECT_EQ(this->IdsOf("a/*/x{id}.stl"), Ids{"1"});
}

TEST_F(CasePattern, NamesOfFilesAreNoPatterns)
{
  this->Add("a*b.nii.gz");
  this->Add("{id}/x.nii.gz");
  EXPECT_NE(this->RefusalOf("{id}b.nii.gz"), "");
  EXPECT_NE(this->RefusalOf("{id}/x.nii.gz"), "");
}

TEST_F(CasePattern, RefusesTwoFilesOfOneId)
{
  this->Add("sub-1_a.nii.gz");
  this->Add("sub-1_b.nii.gz");
  const std::string refusal = this->RefusalOf("sub-{id}_*.nii.gz");
  EXPECT_NE(refusal.find("id 1 has several files"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("sub-1_b.nii.gz"), std::string::npos) << refusal;
}

TEST_F(CasePattern, RefusesIdsWithOneFolderName)
{
  this->Add("sub-a b.nii.gz");
  this->Add("sub-a_b.nii.gz");
  EXPECT_NE(this->RefusalOf("sub-{id}.nii.gz").find("cannot have its own folder"),
            std::string::npos);
}

TEST_F(CasePattern, RefusesWhatIsNoPatternOrMatchesNothing)
{
  this->Add("sub-1.nii.gz");
  for (const char* pattern : {"{id}*.nii.gz", "*{id}.nii.gz", "{id}{id}.nii.gz"})
  {
    EXPECT_NE(this->RefusalOf(pattern).find("{id} must have"), std::string::npos) << pattern;
  }
  for (const char* pattern :
       {"none-{id}.nii.gz", "missing/{id}.nii.gz", "sub-1.nii.gz/{id}", "sub-{id}/"})
  {
    EXPECT_NE(this->RefusalOf(pattern).find("matches no readable"), std::string::npos) << pattern;
  }
  EXPECT_NE(this->RefusalOf(std::string(5000, 'x') + "{id}").find("4096"), std::string::npos);
}

// Time would grow exponentially with the stars if each were tried with each.
TEST_F(CasePattern, ManyStarsTakeNoTime)
{
  this->Add(std::string(120, 'a') + "-1.nii.gz");
  std::string stars;
  for (int i = 0; i < 60; ++i)
  {
    stars += "*a";
  }
  EXPECT_NE(this->RefusalOf(stars + "b-{id}.nii.gz"), "");
  EXPECT_EQ(this->IdsOf(stars + "-{id}.nii.gz"), Ids{"1"});
}
} // namespace
} // namespace palpate::case_pattern_test
