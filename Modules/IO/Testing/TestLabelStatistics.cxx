#include "ImageGrid.h"
#include "LabelStatistics.h"
#include "LabelValues.h"
#include "RandomShapes.h"
#include "SegmentCompletion.h"
#include "SegmentationFile.h"
#include "TestData.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <gtest/gtest.h>

namespace palpate::label_statistics_test
{
namespace
{
using namespace palpate::test;

using Size = std::array<int, 3>;

// A volume of labels, voxel x + nx (y + ny z).
struct Labels
{
  Size N;
  std::vector<unsigned char> Values;

  explicit Labels(const Size& size)
      : N(size), Values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0)
  {
  }
  bool Holds(int x, int y, int z) const
  {
    return x >= 0 && y >= 0 && z >= 0 && x < this->N[0] && y < this->N[1] && z < this->N[2];
  }
  unsigned char& At(int x, int y, int z)
  {
    return this->Values[static_cast<std::size_t>(x + this->N[0] * (y + this->N[1] * z))];
  }
};

Segmentation SegmentationOf(const Labels& labels, const Vector3& spacing = Vector3::Ones())
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfTuples(static_cast<vtkIdType>(labels.Values.size()));
  std::copy(labels.Values.begin(), labels.Values.end(), array->GetPointer(0));
  ImageGrid grid;
  grid.Size = labels.N;
  grid.Spacing = spacing;
  Segmentation segmentation;
  segmentation.Layers.push_back(MakeImage(grid, array));
  CompleteSegments(segmentation);
  return segmentation;
}

// Reference by flood fill, voxel by voxel. Sizes of the components of the voxels that `isMember`
// accepts, on the volume padded by one voxel; those that reach the padding are omitted.
std::vector<vtkIdType> FloodedSizes(const Size& size, bool all26,
                                    const std::function<bool(int, int, int)>& isMember)
{
  const Size n{size[0] + 2, size[1] + 2, size[2] + 2};
  std::vector<char> seen(static_cast<std::size_t>(n[0] * n[1] * n[2]), 0);
  std::vector<vtkIdType> sizes;
  for (int start = 0; start < n[0] * n[1] * n[2]; ++start)
  {
    std::vector<int> open{start};
    vtkIdType voxels = 0;
    bool reachesRim = false;
    while (!open.empty())
    {
      const int place = open.back();
      open.pop_back();
      const int x = place % n[0] - 1;
      const int y = place / n[0] % n[1] - 1;
      const int z = place / (n[0] * n[1]) - 1;
      if (seen[static_cast<std::size_t>(place)] || !isMember(x, y, z))
      {
        continue;
      }
      seen[static_cast<std::size_t>(place)] = 1;
      ++voxels;
      const bool rim = x < 0 || y < 0 || z < 0 || x == size[0] || y == size[1] || z == size[2];
      reachesRim = reachesRim || rim;
      for (int step = 0; step < 27; ++step)
      {
        const int dx = step % 3 - 1;
        const int dy = step / 3 % 3 - 1;
        const int dz = step / 9 - 1;
        const int moved = std::abs(dx) + std::abs(dy) + std::abs(dz);
        const bool inside = x + dx >= -1 && y + dy >= -1 && z + dz >= -1 && x + dx <= size[0] &&
                            y + dy <= size[1] && z + dz <= size[2];
        if (inside && (moved == 1 || (all26 && moved > 1)))
        {
          open.push_back(place + dx + n[0] * (dy + n[1] * dz));
        }
      }
    }
    if (voxels > 0 && !reachesRim)
    {
      sizes.push_back(voxels);
    }
  }
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes;
}

void ExpectMatchesFloodFill(Labels& labels, const Segment& segment,
                            const LabelStatistics& statistics)
{
  const auto isLabel = [&](int x, int y, int z)
  { return labels.Holds(x, y, z) && labels.At(x, y, z) == segment.Value; };
  const auto isNotLabel = [&](int x, int y, int z) { return !isLabel(x, y, z); };
  EXPECT_EQ(statistics.ComponentVoxels, FloodedSizes(labels.N, false, isLabel));
  EXPECT_EQ(statistics.CavityVoxels, FloodedSizes(labels.N, true, isNotLabel));
  EXPECT_EQ(statistics.Voxels,
            std::count(labels.Values.begin(), labels.Values.end(), segment.Value));
}

TEST(LabelStatistics, RandomVolumesMatchFloodFill)
{
  Random random(77);
  for (int round = 0; round < 60; ++round)
  {
    Labels labels({3 + static_cast<int>(random() % 7), 3 + static_cast<int>(random() % 6),
                   2 + static_cast<int>(random() % 6)});
    // From sparse specks to solids with holes, one or three labels.
    const auto fill = 1 + random() % 9;
    for (unsigned char& value : labels.Values)
    {
      value = static_cast<unsigned char>(random() % 10 < fill ? 1 + random() % (1 + round % 3) : 0);
    }
    labels.At(1, 1, 1) = 1;
    const Segmentation segmentation = SegmentationOf(labels);
    const std::vector<LabelStatistics> all = MeasureLabels(segmentation);
    ASSERT_EQ(all.size(), segmentation.Segments.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      ExpectMatchesFloodFill(labels, segmentation.Segments[i], all[i]);
    }
  }
}

// Labels from 1 on that alternate along the first axis, so that each spans the volume.
Segmentation InterleavedLabels(int labels)
{
  const vtkIdType voxels = 64 * 64 * 64;
  auto array = vtkSmartPointer<vtkUnsignedShortArray>::New();
  array->SetNumberOfTuples(voxels);
  for (vtkIdType i = 0; i < voxels; ++i)
  {
    array->SetValue(i, static_cast<unsigned short>(i % labels + 1));
  }
  ImageGrid grid;
  grid.Size = {64, 64, 64};
  Segmentation segmentation;
  segmentation.Layers.push_back(MakeImage(grid, array));
  CompleteSegments(segmentation);
  return segmentation;
}

// Of processor time.
double SecondsToMeasure(const Segmentation& segmentation)
{
  const std::clock_t start = std::clock();
  MeasureLabels(segmentation);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(LabelStatistics, TimeIsIndependentOfLabelCount)
{
  // The same number of runs each; searching each label's box would take a hundred times as long.
  const double few = SecondsToMeasure(InterleavedLabels(40));
  EXPECT_LT(SecondsToMeasure(InterleavedLabels(4000)), 10.0 * few + 0.05);
}

TEST(LabelStatistics, CountsManyLabelsThatSpanVolume)
{
  const std::vector<LabelStatistics> all = MeasureLabels(InterleavedLabels(4000));
  ASSERT_EQ(all.size(), 4000U);
  const vtkIdType voxels = 64 * 64 * 64;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const vtkIdType expected = voxels / 4000 + (static_cast<vtkIdType>(i) < voxels % 4000 ? 1 : 0);
    EXPECT_EQ(all[i].Voxels, expected);
    EXPECT_EQ(all[i].ComponentVoxels,
              std::vector<vtkIdType>(static_cast<std::size_t>(expected), 1));
    EXPECT_TRUE(all[i].CavityVoxels.empty());
  }
}

TEST(LabelStatistics, HollowBoxHasOneCavity)
{
  Labels labels({7, 6, 5});
  for (int z = 1; z < 4; ++z)
  {
    for (int y = 1; y < 5; ++y)
    {
      for (int x = 1; x < 6; ++x)
      {
        labels.At(x, y, z) = 4;
      }
    }
  }
  labels.At(3, 2, 2) = 0;
  labels.At(3, 3, 2) = 0;
  const Segmentation segmentation = SegmentationOf(labels, Vector3(0.5, 2, 3));
  const LabelStatistics statistics = MeasureLabels(segmentation)[0];
  EXPECT_EQ(statistics.Voxels, 5 * 4 * 3 - 2);
  EXPECT_NEAR(statistics.Milliliters, 58 * 3.0 / 1000.0, 1e-15);
  EXPECT_EQ(statistics.BoundsIndex, (std::array<int, 6>{1, 5, 1, 4, 1, 3}));
  EXPECT_FALSE(statistics.TouchesBorder());
  EXPECT_EQ(statistics.ComponentVoxels, std::vector<vtkIdType>{58});
  EXPECT_EQ(statistics.CavityVoxels, std::vector<vtkIdType>{2});
  EXPECT_NEAR(statistics.CavityMilliliters, 2 * 3.0 / 1000.0, 1e-15);
}

TEST(LabelStatistics, SharedFacesConnectVoxels)
{
  Labels labels({4, 4, 4});
  labels.At(0, 0, 0) = 1;
  labels.At(0, 0, 1) = 1;
  labels.At(1, 1, 2) = 1;
  EXPECT_EQ(MeasureLabels(SegmentationOf(labels))[0].ComponentVoxels,
            (std::vector<vtkIdType>{2, 1}));
}

TEST(LabelStatistics, NamesFaces)
{
  Labels labels({4, 5, 6});
  labels.At(0, 2, 5) = 1;
  const LabelStatistics statistics = MeasureLabels(SegmentationOf(labels))[0];
  EXPECT_EQ(statistics.FacesText(), "x- z+");
  EXPECT_TRUE(statistics.TouchesBorder());
}

TEST(LabelStatistics, GiantGlandTouchesVolumeBorder)
{
  const auto path = DataPath("prostate/picai/whole_gland_10715_1000731.nii.gz");
  PALPATE_REQUIRE_FILE(path);
  const LabelStatistics statistics = MeasureLabels(ReadSegmentation(path))[0];
  EXPECT_TRUE(statistics.TouchesBorder());
  // 263 ml in the data's description.
  EXPECT_NEAR(statistics.Milliliters, 263.0, 0.5);
}

TEST(LabelStatistics, LabelCountsOfAtlasAddUp)
{
  const std::filesystem::path path = "/usr/share/mricron/templates/aal.nii.gz";
  PALPATE_REQUIRE_FILE(path);
  const Segmentation segmentation = ReadSegmentation(path);
  const auto counts = CountLabels(segmentation.Layers[0]->GetPointData()->GetScalars());
  const std::vector<LabelStatistics> all = MeasureLabels(segmentation);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    EXPECT_EQ(all[i].Voxels, counts.at(segmentation.Segments[i].Value));
    vtkIdType inComponents = 0;
    for (const vtkIdType voxels : all[i].ComponentVoxels)
    {
      inComponents += voxels;
    }
    EXPECT_EQ(inComponents, all[i].Voxels);
  }
}
} // namespace
} // namespace palpate::label_statistics_test
