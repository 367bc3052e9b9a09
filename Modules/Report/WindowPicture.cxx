#include "WindowPicture.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace palpate
{
Picture ReadWindow(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  Picture picture(window->GetSize()[0], window->GetSize()[1]);
  ReadWindow(window, pixels, picture);
  return picture;
}

void ReadWindow(vtkRenderWindow* window, vtkUnsignedCharArray* pixels, Picture& picture)
{
  window->GetPixelData(0, 0, picture.Width - 1, picture.Height - 1, 1, pixels);
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int column = 0; column < picture.Width; ++column)
    {
      const vtkIdType tuple =
          static_cast<vtkIdType>(picture.Height - 1 - row) * picture.Width + column;
      std::uint8_t* pixel = picture.Pixel(column, row);
      std::copy_n(pixels->GetPointer(3 * tuple), 3, pixel);
      pixel[3] = 255;
    }
  }
}
} // namespace palpate
