#pragma once

#include "RasterImage.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace palpate::test
{
inline RasterImage ReadBaseline(const std::filesystem::path& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  RasterImage raster(size[0], size[1]);
  for (int row = 0; row < size[1]; ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        raster.Pixel(column, row)[c] = static_cast<std::uint8_t>(
            image->GetScalarComponentAsDouble(column, size[1] - 1 - row, 0, c));
      }
    }
  }
  return raster;
}

struct ImageDifference
{
  double Mean = 255.0;     // over pixels and colours, of 255
  double LargeShare = 1.0; // share of pixels with a colour that differs by more than 40
};

inline ImageDifference Compare(const RasterImage& a, const RasterImage& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return {};
  }
  double sum = 0.0;
  double large = 0.0;
  for (std::size_t p = 0; p < a.Rgba.size(); p += 4)
  {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const int difference = std::abs(a.Rgba[p + c] - b.Rgba[p + c]);
      sum += difference;
      largest = std::max(largest, difference);
    }
    large += largest > 40 ? 1.0 : 0.0;
  }
  const double pixels = static_cast<double>(a.Rgba.size()) / 4.0;
  return {sum / (3.0 * pixels), large / pixels};
}

// The baseline was rendered with llvmpipe. Other drivers place samples and hint letters
// differently, which changes pixels along edges: about 1 % of them here. A prop that is missing,
// moved by two pixels or lit differently changes more.
inline void ExpectLikeBaseline(const RasterImage& raster, const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  const ImageDifference difference = Compare(raster, ReadBaseline(file));
  const bool isAlike = difference.Mean < 1.5 && difference.LargeShare < 0.015;
  EXPECT_TRUE(isAlike) << name << ": mean difference " << difference.Mean << ", large in "
                       << 100.0 * difference.LargeShare << " % of the pixels; the picture is in "
                       << std::filesystem::current_path() / name;
  if (!isAlike)
  {
    std::ofstream(name, std::ios::binary) << palpate::EncodePng(raster);
  }
}
} // namespace palpate::test
