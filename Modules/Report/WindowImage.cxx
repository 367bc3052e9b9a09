#include "WindowImage.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace palpate
{
RasterImage ReadWindow(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  RasterImage image(window->GetSize()[0], window->GetSize()[1]);
  window->GetPixelData(0, 0, image.Width - 1, image.Height - 1, 1, pixels);
  for (int row = 0; row < image.Height; ++row)
  {
    for (int column = 0; column < image.Width; ++column)
    {
      const vtkIdType tuple = static_cast<vtkIdType>(image.Height - 1 - row) * image.Width + column;
      std::uint8_t* pixel = image.Pixel(column, row);
      std::copy_n(pixels->GetPointer(3 * tuple), 3, pixel);
      pixel[3] = 255;
    }
  }
  return image;
}
} // namespace palpate
