#include "WindowPicture.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace palpate
{
Picture ReadWindow(vtkRenderWindow* window)
{
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 1, pixels);
  Picture picture(width, height);
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const vtkIdType tuple = static_cast<vtkIdType>(height - 1 - row) * width + column;
      std::uint8_t* pixel = picture.Pixel(column, row);
      std::copy_n(pixels->GetPointer(3 * tuple), 3, pixel);
      pixel[3] = 255;
    }
  }
  return picture;
}
} // namespace palpate
