#pragma once

#include "RasterImage.h"

#include <QImage>
#include <QWidget>

#include <algorithm>

namespace palpate::test
{
/// Whether pictures of whole windows can be compared with the baselines, which are of Qt 5: its
/// rows are higher than those of Qt 6.
constexpr bool HasBaselineRows = QT_VERSION < QT_VERSION_CHECK(6, 0, 0);

/// A widget's image.
inline RasterImage ImageOf(QWidget& widget)
{
  const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGBA8888);
  RasterImage raster(image.width(), image.height());
  for (int row = 0; row < image.height(); ++row)
  {
    std::copy_n(image.constScanLine(row), 4 * static_cast<std::size_t>(image.width()),
                raster.Pixel(0, row));
  }
  return raster;
}
} // namespace palpate::test
