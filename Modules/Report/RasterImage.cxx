#include "RasterImage.h"

#include "DataUri.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

namespace palpate
{
namespace
{
// The fewest lossless PNG components: grey, RGB or RGBA.
int ComponentsNeeded(const RasterImage& raster)
{
  bool isGrey = true;
  for (std::size_t p = 0; p < raster.Rgba.size(); p += 4)
  {
    const std::uint8_t* pixel = raster.Rgba.data() + p;
    if (pixel[3] != 255)
    {
      return 4;
    }
    isGrey = isGrey && pixel[0] == pixel[1] && pixel[1] == pixel[2];
  }
  return isGrey ? 1 : 3;
}
} // namespace

std::string EncodePng(const RasterImage& raster)
{
  if (raster.Width < 1 || raster.Height < 1)
  {
    return {};
  }
  const int components = ComponentsNeeded(raster);
  vtkNew<vtkImageData> image;
  image->SetDimensions(raster.Width, raster.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (int row = raster.Height - 1; row >= 0; --row) // VTK's rows rise
  {
    for (int column = 0; column < raster.Width; ++column)
    {
      const std::uint8_t* pixel = raster.Pixel(column, row);
      for (int c = 0; c < components; ++c)
      {
        *target++ = pixel[c];
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  // A fifth larger than at the default level 5, but three times as fast.
  writer->SetCompressionLevel(2);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

std::string PngDataUri(const RasterImage& raster)
{
  return DataUri("image/png", EncodePng(raster));
}
} // namespace palpate
