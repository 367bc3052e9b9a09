#include "ImageGrid.h"

#include "MessageOf.h"
#include "RandomShapes.h"
#include "SegmentationFile.h"
#include "StoredImages.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace palpate::image_grid_test
{
namespace
{
using namespace palpate::test;

ImageGrid GridOfSize(int size, const Eigen::Matrix3d& direction = Eigen::Matrix3d::Identity())
{
  ImageGrid grid;
  grid.Size = {size, size, size};
  grid.Spacing = {0.5, 1.25, 3.0};
  grid.OriginWorld = {10, -20, 30};
  grid.Direction = direction;
  return grid;
}

// The third axis leans by a share of the second.
Eigen::Matrix3d Leaning(double share)
{
  Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
  direction(1, 2) = share;
  direction.col(2).normalize();
  return direction;
}

Vector3 WorldOf(const ImageGrid& grid, const Vector3& index)
{
  return grid.OriginWorld + grid.Direction * index.cwiseProduct(grid.Spacing);
}

// The largest distance between the places of corners, in voxels along any axis.
double LargestShift(const ImageGrid& before, const ImageGrid& after)
{
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 index =
        Vector3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) * (before.Size[0] - 1);
    const Vector3 moved = WorldOf(after, index) - WorldOf(before, index);
    const Vector3 voxels = (after.Direction.transpose() * moved).cwiseQuotient(after.Spacing);
    largest = std::max(largest, voxels.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::vector<std::string> Check(ImageGrid& grid, ShearedAxes sheared = ShearedAxes::Refuse)
{
  std::vector<std::string> notes;
  CheckGrid("x", grid, notes, sheared);
  return notes;
}

std::string Refusal(ImageGrid grid)
{
  return MessageOf([&] { Check(grid); });
}

// Matrices as headers with three decimals have them.
TEST(ImageGrid, RoundedAxesBecomeRotationThatMovesNoVoxelByTenth)
{
  Random random(3);
  int noted = 0;
  for (int round = 0; round < 100; ++round)
  {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(round, RandomDirection(random)).toRotationMatrix();
    const ImageGrid given = GridOfSize(50, (turn * 1e3).array().round().matrix() / 1e3);
    ImageGrid grid = given;
    noted += static_cast<int>(Check(grid).size());
    EXPECT_TRUE((grid.Direction.transpose() * grid.Direction).isIdentity(1e-12));
    EXPECT_LT(LargestShift(given, grid), 0.1);
    // Half a step of rounding in nine entries.
    EXPECT_LT((grid.Direction - turn).norm(), 9 * 0.5e-3);
    const Vector3 middle = Vector3::Constant(24.5);
    EXPECT_LT((WorldOf(grid, middle) - WorldOf(given, middle)).norm(), 0.01);
  }
  EXPECT_GT(noted, 90);
}

TEST(ImageGrid, AxesOfSinglePrecisionKeepFirstVoxelInSilence)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.3, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  ImageGrid grid = GridOfSize(200, turn.cast<float>().cast<double>());
  EXPECT_TRUE(Check(grid).empty());
  EXPECT_EQ(grid.OriginWorld, Vector3(10, -20, 30));
}

// The same axes: what matters is how far they move voxels of the volume at hand.
TEST(ImageGrid, ShearIsJudgedByVoxelsItMoves)
{
  ImageGrid small = GridOfSize(20, Leaning(3e-3));
  EXPECT_EQ(Check(small).size(), 1u);
  const std::string refusal = Refusal(GridOfSize(200, Leaning(3e-3)));
  EXPECT_TRUE(Contains(refusal, "has sheared axes")) << refusal;
  EXPECT_TRUE(Contains(refusal, "palpate convert --resample")) << refusal;
}

TEST(ImageGrid, KeepsShearedAxesForResampling)
{
  ImageGrid grid = GridOfSize(50, Leaning(0.2));
  EXPECT_TRUE(Check(grid, ShearedAxes::Resample).empty());
  EXPECT_LT((grid.Direction - Leaning(0.2)).norm(), 1e-15);
  EXPECT_TRUE(IsSheared(grid));
}

// Two axes in one direction span no volume.
TEST(ImageGrid, RejectsFlatAxesEvenForResampling)
{
  ImageGrid grid = GridOfSize(50);
  grid.Direction.col(2) = grid.Direction.col(1);
  EXPECT_TRUE(Contains(MessageOf([&] { Check(grid, ShearedAxes::Resample); }), "sheared"));
}

TEST(ImageGrid, RejectsSpacingsThatNoImageHas)
{
  for (const double spacing : {1e-9, 1e-300, 1e9})
  {
    ImageGrid grid = GridOfSize(50);
    grid.Spacing[1] = spacing;
    EXPECT_TRUE(Contains(Refusal(grid), "along axis 2")) << spacing;
  }
}

TEST(ImageGrid, NotesSizesThatNoPatientHas)
{
  for (const double factor : {1e-3, 1e3})
  {
    ImageGrid grid = GridOfSize(50);
    grid.Spacing *= factor;
    const std::vector<std::string> notes = Check(grid);
    ASSERT_EQ(notes.size(), 1u) << factor;
    EXPECT_TRUE(Contains(notes[0], "check the unit")) << notes[0];
  }
  ImageGrid wholeBody = GridOfSize(660);
  EXPECT_TRUE(Check(wholeBody).empty());
}

// Files of 4 x 5 x 6 voxels of 2 mm whose third axis leans by a share of the second (in LPS).
struct LeaningFile
{
  std::string Name;
  std::string Bytes;
};

std::vector<LeaningFile> LeaningFiles(double share)
{
  const std::string voxels(120, '\1');
  const double step = 2.0 * share;
  NiftiSpec nifti;
  nifti.PixelDimensions[3] = static_cast<float>(std::hypot(2.0, step));
  nifti.SForm[6] = static_cast<float>(step);
  std::vector<std::string> nrrd = PlainNrrdLines("unsigned char");
  nrrd[4] = "space directions: (2,0,0) (0,2,0) (0," + std::to_string(step) + ",2)";
  MghSpec mgh;
  mgh.Axes = {-1, 0, 0, 0, -1, 0, 0, static_cast<float>(share), 1};
  return {{"a.nii", NiftiBytes(nifti, voxels)},
          {"a2.nii", Nifti2Bytes(nifti, voxels)},
          {"a.nrrd", NrrdBytes(nrrd, voxels)},
          {"a.mha", MetaImageBytes("MET_UCHAR", voxels,
                                   "TransformMatrix = 1 0 0 0 1 0 0 " + std::to_string(share) +
                                       " 1\nElementSpacing = 2 2 2\n")},
          {"a.mgh", MghBytes(mgh, voxels)}};
}

TEST(ImageGrid, EveryFormatHasTheSameRuleForShear)
{
  const TemporaryFolder folder;
  for (const LeaningFile& file : LeaningFiles(3e-3)) // at most 0.015 mm in this volume
  {
    WriteAll(folder / file.Name, file.Bytes);
    const Segmentation read = ReadSegmentation(folder / file.Name);
    EXPECT_EQ(std::count_if(read.Notes.begin(), read.Notes.end(),
                            [](const std::string& note)
                            { return Contains(note, "not exactly perpendicular"); }),
              1)
        << file.Name;
  }
  for (const LeaningFile& file : LeaningFiles(0.3))
  {
    WriteAll(folder / file.Name, file.Bytes);
    EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / file.Name); }), "has sheared axes"))
        << file.Name;
    VolumeChoice choice;
    choice.Sheared = ShearedAxes::Resample;
    EXPECT_FALSE(IsSheared(GridOf(ReadVolume(folder / file.Name, choice).Image))) << file.Name;
  }
}

TEST(ImageGrid, ReadsPublicFilesWithRoundedAxes)
{
  for (const char* name : {"odd/nii_nonorth_3e-4.nii.gz", "odd/nii_nonorth_anima.nii.gz"})
  {
    const auto path = DataPath(name);
    PALPATE_REQUIRE_FILE(path);
    const Segmentation read = ReadSegmentation(path);
    const ImageGrid grid = GridOf(read.Layers[0]);
    // Its header puts the centre of the volume there (LPS); no voxel moves by more than 0.012 mm.
    const Vector3 middle(27.5, -21.5, 16.5);
    const Vector3 center(-5.5 + 27.5, -50.50593948 + 21.5 + 0.00036 * 16.5, 26.2 + 1.2 * 16.5);
    EXPECT_LT((WorldOf(grid, middle.cwiseAbs()) - center).norm(), 1e-4) << name;
  }
}
} // namespace
} // namespace palpate::image_grid_test
