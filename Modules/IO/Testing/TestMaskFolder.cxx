#include "FileStamp.h"
#include "ImageContent.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "MaskFolder.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <map>

namespace palpate::mask_folder_test
{
namespace
{
using namespace palpate::test;
using Kind = MaskFolder::Kind;

class MaskFolderTest : public testing::Test
{
protected:
  // A cube of 6 voxels a side from here along the first axis.
  void WriteCube(const std::string& name, int from, double spacing = 1.0) const
  {
    LabelGrid grid;
    grid.Size = {{48, 10, 10}};
    grid.Spacing[0] = spacing;
    WriteImage(this->Folder / (name + ".nii.gz"),
               MakeLabelImage(grid,
                              [&](double x, double y, double z)
                              {
                                const double i = x / spacing - from;
                                return i >= 0.0 && i < 6.0 && y > 1.0 && y < 8.0 && z > 1.0 &&
                                       z < 8.0;
                              }));
  }
  MaskFolder Judge() const { return {this->Folder.Path(), {}, true}; }
  std::size_t Voxels(const Segmentation& all, const std::string& name) const
  {
    const Segment& one = all.Find(name);
    vtkDataArray* voxels =
        all.Layers[static_cast<std::size_t>(one.Layer)]->GetPointData()->GetScalars();
    std::size_t count = 0;
    for (vtkIdType n = 0; n < voxels->GetNumberOfTuples(); ++n)
    {
      count += voxels->GetComponent(n, 0) == one.Value ? 1 : 0;
    }
    return count;
  }

  TemporaryFolder Folder;
};

constexpr std::size_t CubeVoxels = 6 * 6 * 6;

TEST_F(MaskFolderTest, MasksThatHardlyOverlapAreStructuresNamedAfterTheirFiles)
{
  WriteCube("spleen", 0);
  WriteCube("liver", 6);
  WriteCube("kidney_left.1", 20);
  const MaskFolder folder = this->Judge();
  EXPECT_EQ(folder.Is(), Kind::Structures);
  EXPECT_TRUE(folder.IsOneSegmentation());
  EXPECT_EQ(folder.Why(), "3 masks on one grid that hardly overlap");
  const Segmentation all = ReadSegmentation(this->Folder.Path());
  ASSERT_EQ(all.Segments.size(), 3U);
  EXPECT_EQ(all.Segments[0].Name, "kidney_left.1");
  EXPECT_EQ(all.Segments[1].Name, "liver");
  EXPECT_EQ(all.Segments[2].Name, "spleen");
  EXPECT_EQ(all.Layers.size(), 1U);
  for (const Segment& one : all.Segments)
  {
    EXPECT_EQ(this->Voxels(all, one.Name), CubeVoxels);
  }
}

TEST_F(MaskFolderTest, TablesOfLabelMapsDoNotNameMasks)
{
  WriteCube("spleen", 0);
  WriteCube("liver", 20);
  WriteAll(this->Folder / "dataset.json", R"({"labels": {"kidney": 1}})");
  EXPECT_EQ(ReadSegmentation(this->Folder.Path()).Segments[1].Name, "spleen");
}

TEST_F(MaskFolderTest, SmallOverlapsAreKeptAsLayers)
{
  LabelGrid grid;
  grid.Size = {{48, 10, 10}};
  // 24 and 3 voxels along the first axis, of which one is shared: Dice 0.07.
  WriteImage(this->Folder / "a.nii",
             MakeLabelImage(grid, [](double x, double, double) { return x < 24.0; }));
  WriteImage(this->Folder / "b.nii",
             MakeLabelImage(grid, [](double x, double, double) { return x > 22.0 && x < 26.0; }));
  const Segmentation all = ReadSegmentation(this->Folder.Path());
  EXPECT_EQ(all.Layers.size(), 2U);
  EXPECT_EQ(this->Voxels(all, "a"), 2400U);
  EXPECT_EQ(this->Voxels(all, "b"), 300U);
}

TEST_F(MaskFolderTest, MasksThatMostlyOverlapAreCases)
{
  for (int n = 0; n < 20; ++n)
  {
    WriteCube("patient" + std::to_string(n), n % 3);
  }
  EXPECT_EQ(this->Judge().Is(), Kind::Cases);
  EXPECT_EQ(this->Judge().Why(), "masks on one grid that mostly overlap");
  EXPECT_NE(MessageOf([&] { ReadSegmentation(this->Folder.Path()); })
                .find("not the structures of one patient"),
            std::string::npos);
  std::size_t read = 0;
  const MaskFolder judged(this->Folder.Path(), {}, true,
                          [&](std::size_t, std::size_t count)
                          {
                            EXPECT_EQ(count, 20U);
                            ++read;
                          });
  EXPECT_EQ(read, 8U) << "these are enough to tell";
  EXPECT_EQ(MaskFolder(this->Folder.Path(), {}, false).Structures().Segments.size(), 20U);
}

// Each file has two labels; the same labels of two files overlap.
TEST_F(MaskFolderTest, LabelMapsOfSeveralPatientsAreCases)
{
  LabelGrid grid;
  grid.Size = {{48, 10, 10}};
  const auto two = MakeLabelImage(grid, [](double x, double, double) { return x < 10.0; });
  for (vtkIdType n = 0; n < two->GetNumberOfPoints(); ++n)
  {
    two->GetPointData()->GetScalars()->SetComponent(n, 0, n % 48 < 10 ? 1 : n % 48 < 20 ? 2 : 0);
  }
  WriteImage(this->Folder / "a.nii", two);
  WriteImage(this->Folder / "c.nii", two);
  EXPECT_EQ(this->Judge().Is(), Kind::Cases);
}

TEST_F(MaskFolderTest, MasksOnSeveralGridsAreCases)
{
  WriteCube("a", 0);
  WriteCube("b", 20, 1.5);
  WriteCube("c", 40, 2.0);
  EXPECT_EQ(this->Judge().Is(), Kind::Cases);
  EXPECT_EQ(this->Judge().Why(), "3 masks on 3 grids");
}

TEST_F(MaskFolderTest, LeftAndRightOfTwoPatientsAreUnclear)
{
  WriteCube("1_left", 0);
  WriteCube("1_right", 30);
  WriteCube("2_left", 1);
  WriteCube("2_right", 31);
  EXPECT_EQ(this->Judge().Is(), Kind::Unclear);
  EXPECT_FALSE(this->Judge().IsOneSegmentation());
  EXPECT_NE(MessageOf([&] { ReadSegmentation(this->Folder.Path()); }).find("some overlap"),
            std::string::npos);
}

TEST_F(MaskFolderTest, LeavesOutBrokenEmptyAndMisplacedMasksWithALineEach)
{
  for (int n = 0; n < 6; ++n)
  {
    WriteCube("organ" + std::to_string(n), 7 * n);
  }
  WriteCube("elsewhere", 0, 2.0);
  WriteCube("nothing", 100);
  WriteAll(this->Folder / "broken.nii.gz", "no image");
  WriteAll(this->Folder / "notes.txt", "not looked at");
  const MaskFolder folder = this->Judge();
  EXPECT_EQ(folder.Is(), Kind::Structures);
  EXPECT_EQ(folder.Structures().Segments.size(), 6U);
  ASSERT_EQ(folder.LeftOut().size(), 3U);
  const std::map<std::string, std::string> reasons{{"broken.nii.gz", ""},
                                                   {"elsewhere.nii.gz", " lies on another grid"},
                                                   {"nothing.nii.gz", " has no labelled voxels"}};
  const Segmentation read = ReadSegmentation(this->Folder.Path());
  ASSERT_EQ(read.Refused.size(), 3U);
  EXPECT_TRUE(read.Notes.empty());
  std::size_t n = 0;
  for (const auto& [name, reason] : reasons)
  {
    EXPECT_EQ(folder.LeftOut()[n].File, this->Folder / name);
    EXPECT_NE(folder.LeftOut()[n].Message.find(name + reason), std::string::npos);
    EXPECT_EQ(read.Refused[n].File, folder.LeftOut()[n].File);
    EXPECT_EQ(read.Remarks()[n], folder.LeftOut()[n].Message);
    ++n;
  }
}

TEST_F(MaskFolderTest, OneMaskIsReadAndIsNoQuestion)
{
  WriteCube("gland", 3);
  EXPECT_FALSE(this->Judge().IsOneSegmentation());
  EXPECT_EQ(ReadSegmentation(this->Folder.Path()).Segments.front().Name, "gland");
}

TEST_F(MaskFolderTest, FolderWithoutAMaskIsNone)
{
  EXPECT_FALSE(IsMaskFolder(this->Folder.Path()));
  EXPECT_FALSE(IsMaskFolder(this->Folder / "missing"));
  WriteAll(this->Folder / "broken.nii.gz", "no image");
  EXPECT_TRUE(IsMaskFolder(this->Folder.Path()));
  EXPECT_NE(MessageOf([&] { ReadSegmentation(this->Folder.Path()); })
                .find("has no mask that can be read"),
            std::string::npos);
}

TEST_F(MaskFolderTest, StampChangesWithAnyFile)
{
  WriteCube("a", 0);
  WriteCube("b", 20);
  const std::string before = StampOf(this->Folder.Path());
  EXPECT_EQ(StampOf(this->Folder.Path()), before);
  WriteAll(this->Folder / "b.nii.gz", "written again");
  EXPECT_NE(StampOf(this->Folder.Path()), before);
}
} // namespace
} // namespace palpate::mask_folder_test
