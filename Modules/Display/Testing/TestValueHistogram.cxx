#include "ValueHistogram.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace palpate::value_histogram_test
{
namespace
{
// An image of these dimensions whose voxel n has the value of n.
template <typename Value>
vtkSmartPointer<vtkImageData> ImageOf(int columns, int rows, int slices, const Value& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, slices);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxels = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    voxels[v] = static_cast<float>(value(v));
  }
  return image;
}

std::size_t TotalOf(const ValueHistogram& histogram)
{
  return std::accumulate(histogram.Counts.begin(), histogram.Counts.end(), std::size_t{0});
}

TEST(ValueHistogram, CountsEveryVoxelOfASmallImage)
{
  const auto image = ImageOf(10, 10, 10, [](vtkIdType v) { return v % 4; });
  const ValueHistogram histogram = HistogramOf(image, 4);
  EXPECT_EQ(histogram.Counts, (std::vector<std::size_t>{250, 250, 250, 250}));
  EXPECT_EQ(histogram.Lowest, 0.0);
  EXPECT_EQ(histogram.Highest, 3.0);
  EXPECT_EQ(histogram.ValueAt(0), 0.0);
  EXPECT_EQ(histogram.ValueAt(4), 3.0);
}

TEST(ValueHistogram, SampleOfALargeImageIsBoundedAndOfAllColumns)
{
  // Value 1 in the first column only, of 128: a sample with a step of 16 would have an eighth.
  const auto image = ImageOf(128, 128, 256, [](vtkIdType v) { return v % 128 == 0 ? 1 : 0; });
  const ValueHistogram histogram = HistogramOf(image, 2);
  EXPECT_LE(TotalOf(histogram), std::size_t{1} << 18);
  EXPECT_GT(TotalOf(histogram), std::size_t{1} << 17);
  EXPECT_NEAR(static_cast<double>(histogram.Counts[1]) / static_cast<double>(TotalOf(histogram)),
              1.0 / 128.0, 1e-3);
}

TEST(ValueHistogram, OutliersDoNotStretchItsRange)
{
  const auto image =
      ImageOf(20, 20, 20, [](vtkIdType v) { return v == 7   ? 30000
                                                   : v == 8 ? -9000
                                                            : v % 100; });
  const ValueHistogram histogram = HistogramOf(image);
  EXPECT_EQ(histogram.Lowest, -9000.0);
  EXPECT_EQ(histogram.Highest, 30000.0);
  EXPECT_GE(histogram.First, 0.0);
  EXPECT_LE(histogram.Last, 99.0);
  EXPECT_EQ(TotalOf(histogram), 8000U) << "outliers are in the first and last count";
}

TEST(ValueHistogram, IgnoresWhatIsNoNumber)
{
  const auto image = ImageOf(10, 10, 1,
                             [](vtkIdType v)
                             {
                               return v < 50   ? std::nan("")
                                      : v < 60 ? std::numeric_limits<double>::infinity()
                                               : 5.0 + static_cast<double>(v % 2);
                             });
  const ValueHistogram histogram = HistogramOf(image);
  EXPECT_EQ(TotalOf(histogram), 40U);
  EXPECT_EQ(histogram.Highest, 6.0);
  const auto none = ImageOf(3, 3, 3, [](vtkIdType) { return std::nan(""); });
  EXPECT_EQ(TotalOf(HistogramOf(none)), 0U);
  EXPECT_GT(HistogramOf(none).Last, HistogramOf(none).First);
}

TEST(ValueHistogram, UniformImageHasARange)
{
  for (const double value : {0.0, -7.5, 1e20})
  {
    const ValueHistogram histogram =
        HistogramOf(ImageOf(4, 4, 4, [value](vtkIdType) { return value; }));
    EXPECT_GT(histogram.Last, histogram.First) << value;
    EXPECT_EQ(TotalOf(histogram), 64U) << value;
    EXPECT_TRUE(std::isfinite(OtsuThreshold(histogram))) << value;
  }
}

TEST(ValueHistogram, OtsuThresholdLiesBetweenTwoClasses)
{
  // A third of the voxels around 1000, the others around 0, both with a spread of 50.
  const auto image =
      ImageOf(40, 40, 20,
              [](vtkIdType v) { return (v % 3 == 0 ? 1000.0 : 0.0) + 50.0 * std::sin(0.7 * v); });
  EXPECT_NEAR(OtsuThreshold(HistogramOf(image)), 500.0, 20.0);
}

TEST(ValueHistogram, AirTellsACt)
{
  const auto withLowest = [](double lowest)
  {
    return LooksLikeCt(HistogramOf(
        ImageOf(8, 8, 8, [lowest](vtkIdType v) { return v % 4 == 0 ? lowest : 40.0; })));
  };
  EXPECT_TRUE(withLowest(-1000.0));
  EXPECT_FALSE(withLowest(-20.0));
  EXPECT_FALSE(withLowest(0.0));
}
} // namespace
} // namespace palpate::value_histogram_test
