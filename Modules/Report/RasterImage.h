#pragma once

#include "PalpateReportModule.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// An RGBA image: red, green, blue, opacity (not premultiplied), rows from top to bottom.
struct RasterImage
{
  RasterImage() = default;
  RasterImage(int width, int height)
      : Width(width), Height(height),
        Rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  {
  }

  std::uint8_t* Pixel(int column, int row) { return this->Rgba.data() + this->Offset(column, row); }
  const std::uint8_t* Pixel(int column, int row) const
  {
    return this->Rgba.data() + this->Offset(column, row);
  }

  int Width = 0;
  int Height = 0;
  std::vector<std::uint8_t> Rgba;

private:
  std::size_t Offset(int column, int row) const
  {
    return 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Width) +
                static_cast<std::size_t>(column));
  }
};

/// The bytes of a PNG file, with as few components as the image needs. Empty for an empty image.
PALPATEREPORT_EXPORT std::string EncodePng(const RasterImage& raster);

/// The image as a "data:image/png;base64," URI, for self-contained pages.
PALPATEREPORT_EXPORT std::string PngDataUri(const RasterImage& raster);
} // namespace palpate
