#include "RasterImage.h"

#include "TemporaryFolder.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace palpate::raster_image_test
{
namespace
{
// Reads a PNG back, from a file: newer VTK takes memory in another way. Row 0 of the result is the
// top.
RasterImage Decode(const std::string& png, int& components)
{
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "image.png";
  std::ofstream(file, std::ios::binary) << png;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  components = image->GetNumberOfScalarComponents();
  RasterImage raster(size[0], size[1]);
  for (int row = 0; row < size[1]; ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      const auto* source =
          static_cast<const std::uint8_t*>(image->GetScalarPointer(column, size[1] - 1 - row, 0));
      for (int c = 0; c < 4; ++c)
      {
        const bool isColor = c < 3;
        raster.Pixel(column, row)[c] = components == 1  ? (isColor ? source[0] : 255)
                                       : c < components ? source[c]
                                                        : 255;
      }
    }
  }
  return raster;
}

RasterImage RandomRasterImage(bool isGrey, bool isOpaque)
{
  std::mt19937_64 random(99);
  RasterImage raster(37, 21);
  for (std::size_t p = 0; p < raster.Rgba.size(); p += 4)
  {
    std::uint8_t* pixel = raster.Rgba.data() + p;
    pixel[0] = static_cast<std::uint8_t>(random());
    pixel[1] = isGrey ? pixel[0] : static_cast<std::uint8_t>(random());
    pixel[2] = isGrey ? pixel[0] : static_cast<std::uint8_t>(random());
    pixel[3] = isOpaque ? 255 : static_cast<std::uint8_t>(random());
  }
  return raster;
}

TEST(RasterImage, PngKeepsPixelsInFewestComponents)
{
  int components = 0;
  for (const bool isGrey : {true, false})
  {
    const RasterImage raster = RandomRasterImage(isGrey, true);
    EXPECT_EQ(Decode(palpate::EncodePng(raster), components).Rgba, raster.Rgba);
    EXPECT_EQ(components, isGrey ? 1 : 3);
  }
  const RasterImage transparent = RandomRasterImage(false, false);
  EXPECT_EQ(Decode(palpate::EncodePng(transparent), components).Rgba, transparent.Rgba);
  EXPECT_EQ(components, 4);
}

TEST(RasterImage, DataUriIsBase64OfPng)
{
  // RFC 4648: a PNG's first nine bytes 89 50 4E 47 0D 0A 1A 0A 00 are "iVBORw0KGgoA".
  const std::string uri = palpate::PngDataUri(RandomRasterImage(true, true));
  const std::string start = "data:image/png;base64,";
  EXPECT_EQ(uri.substr(0, start.size() + 12), start + "iVBORw0KGgoA");
  const std::string png = palpate::EncodePng(RandomRasterImage(true, true));
  EXPECT_EQ(uri.size() - start.size(), (png.size() + 2) / 3 * 4);
}

TEST(RasterImage, EmptyImageHasNoBytes)
{
  EXPECT_EQ(palpate::EncodePng(RasterImage()), "");
}
} // namespace
} // namespace palpate::raster_image_test
