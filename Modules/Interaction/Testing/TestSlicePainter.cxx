#include "SlicePainter.h"

#include "PlaneSampler.h"
#include "SlicePatch.h"
#include "SliceViewTest.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::slice_painter_test
{
namespace
{
PixelGrid Plane(int width, int height)
{
  const Vector3 right(1.0, 0.0, 0.0);
  const Vector3 up(0.0, 1.0, 0.0);
  return {-0.5 * (width - 1) * right - 0.5 * (height - 1) * up, right, up, width, height};
}

std::vector<unsigned char> Bytes(vtkImageData* raster)
{
  const auto* bytes = static_cast<unsigned char*>(raster->GetScalarPointer());
  return {bytes, bytes + 4 * raster->GetNumberOfPoints()};
}

vtkSmartPointer<vtkImageData> Uniform(double value)
{
  auto image = palpate::test::RampImage(palpate::Matrix3::Identity());
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
              static_cast<float>(value));
  return image;
}

TEST(SlicePainter, ResultDoesNotDependOnThreads)
{
  SliceContent content;
  content.Image = palpate::test::RampImage(palpate::test::SkewTurn());
  content.Window = {20.0, 160.0};
  content.Layers = {{Uniform(3.0), {{3, {{1.0F, 0.0F, 0.0F, 0.5F}}}}}};
  vtkNew<vtkImageData> one;
  vtkNew<vtkImageData> many;
  PaintSlice(content, Plane(160, 170), many);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{1, "Sequential", false},
                          [&] { PaintSlice(content, Plane(160, 170), one); });
  EXPECT_EQ(Bytes(one), Bytes(many));
}

TEST(SlicePainter, OutsidePixelsAreTransparent)
{
  SliceContent content;
  content.Image = Uniform(1.0);
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(300, 2), raster);
  const auto bytes = Bytes(raster);
  EXPECT_EQ(bytes[3], 0);
  EXPECT_EQ(bytes[4 * 150 + 3], 255);
  EXPECT_EQ(bytes[4 * 150], 255);
}

TEST(SlicePainter, BlendsFurtherImagesInTheirOrder)
{
  SliceContent content;
  content.Image = Uniform(0.0);
  content.Over = {{Uniform(1.0), {0.0, 1.0}, VolumeColors::Red, 1.0F},
                  {Uniform(1.0), {0.0, 1.0}, VolumeColors::Green, 0.25F}};
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(1, 1), raster);
  const auto bytes = Bytes(raster);
  EXPECT_NEAR(bytes[0], 0.75 * 255.0, 1.0);
  EXPECT_NEAR(bytes[1], 0.25 * 255.0, 1.0);
  EXPECT_EQ(bytes[2], 0);
}

TEST(SlicePainter, FurtherImageIsShownByItsOwnWindowAndAtItsPlace)
{
  SliceContent content;
  content.Image = Uniform(0.0);
  content.Window = {0.0, 1.0};
  content.Over = {{palpate::test::RampImage(palpate::test::SkewTurn()),
                   {40.0, 140.0},
                   VolumeColors::Grey,
                   1.0F}};
  SliceContent alone;
  alone.Image = content.Over[0].Image;
  alone.Window = content.Over[0].Window;
  vtkNew<vtkImageData> together;
  vtkNew<vtkImageData> only;
  PaintSlice(content, Plane(300, 40), together);
  PaintSlice(alone, Plane(300, 40), only);
  const auto bytes = Bytes(together);
  const auto expected = Bytes(only);
  std::size_t shown = 0;
  for (std::size_t pixel = 0; pixel < bytes.size(); pixel += 4)
  {
    const bool isInside = expected[pixel + 3] != 0;
    EXPECT_EQ(bytes[pixel], isInside ? expected[pixel] : 0) << pixel;
    shown += isInside ? 1 : 0;
  }
  EXPECT_GT(shown, 1000U);
}

TEST(SlicePainter, DarkBackgroundOfAFurtherImageMayBeTransparent)
{
  for (const double value : {0.2, 0.5, 0.6})
  {
    SliceContent content;
    content.Image = Uniform(1.0);
    content.Window = {0.0, 1.0};
    content.Over = {{Uniform(value), {0.5, 1.5}, VolumeColors::Grey, 1.0F, true}};
    vtkNew<vtkImageData> raster;
    PaintSlice(content, Plane(1, 1), raster);
    EXPECT_EQ(Bytes(raster)[0] == 255, value <= 0.5) << value;
  }
}

TEST(SlicePainter, CheckerboardShowsOneImageInEverySquare)
{
  SliceContent content;
  content.Image = Uniform(0.0);
  content.Over = {{Uniform(1.0), {0.0, 1.0}, VolumeColors::Grey, 0.3F}};
  content.Mixing = ImageMixing::Checkerboard;
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(16, 16), raster);
  const auto bytes = Bytes(raster);
  for (std::size_t row = 0; row < 16; ++row)
  {
    for (std::size_t column = 0; column < 16; ++column)
    {
      const bool isOver = (row / 2 + column / 2) % 2 != 0; // eight squares along a side
      EXPECT_EQ(bytes[4 * (16 * row + column)], isOver ? 255 : 0) << row << " " << column;
    }
  }
}

TEST(SlicePainter, CurtainShowsTheFurtherImageOnItsLeft)
{
  for (const double place : {0.0, 0.25, 1.0})
  {
    SliceContent content;
    content.Image = Uniform(0.0);
    content.Over = {{Uniform(1.0), {0.0, 1.0}, VolumeColors::Grey, 0.3F}};
    content.Mixing = ImageMixing::Curtain;
    content.Curtain = place;
    vtkNew<vtkImageData> raster;
    PaintSlice(content, Plane(20, 1), raster);
    const auto bytes = Bytes(raster);
    for (int column = 0; column < 20; ++column)
    {
      EXPECT_EQ(bytes[static_cast<std::size_t>(4 * column)], column < 20.0 * place ? 255 : 0)
          << place << " " << column;
    }
  }
}

TEST(SlicePainter, BlendsLayersInOrderAndMultipliesOpacities)
{
  SliceContent content;
  content.Image = Uniform(0.0);
  content.LabelOpacity = 0.5F;
  content.Layers = {{Uniform(1.0), {{1, {{1.0F, 0.0F, 0.0F, 1.0F}}}}},
                    {Uniform(2.0), {{2, {{0.0F, 1.0F, 0.0F, 0.5F}}}}}};
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(1, 1), raster);
  const auto bytes = Bytes(raster);
  EXPECT_NEAR(bytes[0], 0.75 * 127.5, 1.0); // half red, a quarter of which is covered
  EXPECT_NEAR(bytes[1], 0.25 * 255.0, 1.0);
  EXPECT_EQ(bytes[2], 0);
}

// The pixels of a row of 61 mm through a ramp that a band colours: red is then more than blue.
std::vector<bool> Colored(const SliceContent& content)
{
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(61, 1), raster);
  const auto bytes = Bytes(raster);
  std::vector<bool> colored;
  for (std::size_t pixel = 0; pixel < bytes.size(); pixel += 4)
  {
    colored.push_back(bytes[pixel] > bytes[pixel + 2]);
  }
  return colored;
}

// The grey values of the same row, with one sample for each pixel.
std::vector<float> ValuesOf(vtkImageData* image, bool isSmooth)
{
  std::vector<float> values(61);
  const palpate::PlaneSampler sampler(image, Plane(61, 1));
  if (isSmooth)
  {
    sampler.SampleLinear(0, values.data());
  }
  else
  {
    sampler.SampleNearest(0, -1e9F, values.data());
  }
  return values;
}

TEST(SlicePainter, BandWithoutUpperLimitEndsAtTheIsoSurface)
{
  SliceContent content;
  content.Image = palpate::test::RampImage(palpate::test::SkewTurn());
  content.Window = {0.0, 1000.0};
  content.Band.emplace();
  const auto values = ValuesOf(content.Image, true);
  content.Band->Low = 0.5 * (values[20] + values[21]) + 1e-3;
  const auto colored = Colored(content);
  for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
  {
    EXPECT_EQ(colored[pixel], values[pixel] >= content.Band->Low) << pixel;
  }
  EXPECT_NE(colored[20], colored[21]);
}

TEST(SlicePainter, BandWithUpperLimitIsOfWholeVoxels)
{
  SliceContent content;
  content.Image = palpate::test::RampImage(palpate::Matrix3::Identity());
  content.Window = {0.0, 1000.0};
  const auto values = ValuesOf(content.Image, false);
  content.Band.emplace();
  content.Band->Low = std::min(values[20], values[30]);
  content.Band->High = std::max(values[20], values[30]);
  const auto colored = Colored(content);
  for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
  {
    const bool isIn = values[pixel] >= content.Band->Low && values[pixel] <= content.Band->High;
    EXPECT_EQ(colored[pixel], isIn) << pixel;
  }
}

TEST(SlicePainter, BandStaysInsideItsMask)
{
  SliceContent content;
  content.Image = Uniform(5.0);
  content.Window = {0.0, 1000.0};
  content.Band.emplace();
  content.Band->Mask = Uniform(3.0);
  content.Band->MaskValue = 4;
  auto colored = Colored(content);
  EXPECT_EQ(std::count(colored.begin(), colored.end(), true), 0);
  content.Band->MaskValue = 3;
  colored = Colored(content);
  EXPECT_GT(std::count(colored.begin(), colored.end(), true), 10);
}

TEST(SlicePainter, PaintsColoredLabelsWithoutImage)
{
  SliceContent content;
  content.Layers = {{Uniform(-4.0), {{-4, {{0.0F, 0.0F, 1.0F, 1.0F}}}}}};
  vtkNew<vtkImageData> raster;
  PaintSlice(content, Plane(1, 1), raster);
  EXPECT_EQ(Bytes(raster), (std::vector<unsigned char>{0, 0, 255, 255}));
  content.Layers = {{Uniform(5.0), {{-4, {{0.0F, 0.0F, 1.0F, 1.0F}}}}}};
  PaintSlice(content, Plane(1, 1), raster);
  EXPECT_EQ(Bytes(raster), (std::vector<unsigned char>{0, 0, 0, 0}));
}

TEST(SlicePatch, CornersMatchPixelGrid)
{
  const auto corners = palpate::SlicePatch::CornersOf(Plane(4, 2));
  ASSERT_EQ(corners.size(), 4U);
  EXPECT_EQ(corners[0], Vector3(-2.0, -1.0, 0.0));
  EXPECT_EQ(corners[2], Vector3(2.0, 1.0, 0.0));
}
} // namespace
} // namespace palpate::slice_painter_test
