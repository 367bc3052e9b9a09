#pragma once

#include "Picture.h"

#include <QImage>
#include <QWidget>

#include <algorithm>

namespace palpate::test
{
/// A widget's image.
inline Picture PictureOf(QWidget& widget)
{
  const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGBA8888);
  Picture picture(image.width(), image.height());
  for (int row = 0; row < image.height(); ++row)
  {
    std::copy_n(image.constScanLine(row), 4 * static_cast<std::size_t>(image.width()),
                picture.Pixel(0, row));
  }
  return picture;
}
} // namespace palpate::test
