#include "DisplayTest.h"
#include "StudyFile.h"
#include "StudyPhantoms.h"

#include <QCoreApplication>
#include <QImage>
#include <QProcess>
#include <QProcessEnvironment>

#include <gtest/gtest.h>

namespace palpate::viewer_images_test
{
namespace
{
constexpr int Width = 900; // of the window, before it is scaled
constexpr int Height = 650;

bool IsWhite(const QImage& raster, int column, int row)
{
  const QColor color = raster.pixelColor(column, row);
  return color.red() > 250 && color.green() > 250 && color.blue() > 250;
}

// A horizontal white line: columns from Left to Right, rows from Top to Bottom, inclusive.
struct Bar
{
  int Left = 0, Right = -1, Top = 0, Bottom = -1;

  int Length() const { return this->Right - this->Left + 1; }
  int Thickness() const { return this->Bottom - this->Top + 1; }
};

bool IsBlack(const QImage& raster, int column, int row)
{
  return raster.valid(column, row) && qGray(raster.pixel(column, row)) < 30;
}

// The white pixels from a corner to the right, and below its centre; of length 0 unless black above
// and below.
Bar BarFrom(const QImage& raster, int left, int top)
{
  Bar bar{left, left, top, top};
  while (bar.Right + 1 < raster.width() && IsWhite(raster, bar.Right + 1, top))
  {
    ++bar.Right;
  }
  const int middle = (bar.Left + bar.Right) / 2;
  while (bar.Bottom + 1 < raster.height() && IsWhite(raster, middle, bar.Bottom + 1))
  {
    ++bar.Bottom;
  }
  const bool isOnBlack =
      IsBlack(raster, middle, top - 1) && IsBlack(raster, middle, bar.Bottom + 1);
  return isOnBlack ? bar : Bar();
}

// The longest scale bar of all views: nothing else in them is white on black and long.
Bar FindScaleBar(const QImage& raster)
{
  Bar longest;
  for (int row = 0; row < raster.height(); ++row)
  {
    for (int column = 1; column < raster.width(); ++column)
    {
      if (IsWhite(raster, column, row) && IsBlack(raster, column - 1, row))
      {
        const Bar bar = BarFrom(raster, column, row);
        longest = bar.Length() > longest.Length() ? bar : longest;
        column = std::max(column, bar.Right);
      }
    }
  }
  return longest;
}

// Number of squares of 2 x 2 pixels with different pixels: none in an image that was enlarged after
// drawing.
int MixedSquares(const QImage& raster, const QRect& part)
{
  int mixed = 0;
  for (int row = part.top() / 2 * 2; row + 1 <= part.bottom(); row += 2)
  {
    for (int column = part.left() / 2 * 2; column + 1 <= part.right(); column += 2)
    {
      const QRgb first = raster.pixel(column, row);
      mixed += raster.pixel(column + 1, row) != first || raster.pixel(column, row + 1) != first ||
                       raster.pixel(column + 1, row + 1) != first
                   ? 1
                   : 0;
    }
  }
  return mixed;
}

class ViewerImagesTest : public test::DisplayTest
{
protected:
  // The program's image of the phantom if a desktop pixel is `factor` screen pixels.
  QImage Take(int factor)
  {
    const auto file = this->Phantom.Folder / ("at" + std::to_string(factor) + ".png");
    const auto session = this->Phantom.Folder / "case.palpate.json";
    WriteStudy(session, this->Phantom.State());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_SCALE_FACTOR", QString::number(factor));
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString(this->Phantom.Folder.Path()));
    environment.insert("PALPATE_CACHE_DIR", ""); // not the user's
    QProcess viewer;
    viewer.setProcessEnvironment(environment);
    viewer.setProcessChannelMode(QProcess::ForwardedChannels);
    viewer.start(PALPATE_VIEWER,
                 {QString::fromStdString(session), "--screenshot", QString::fromStdString(file),
                  "--size", QString("%1x%2").arg(Width).arg(Height)});
    EXPECT_TRUE(viewer.waitForFinished(-1));
    EXPECT_EQ(viewer.exitCode(), 0);
    return QImage(QString::fromStdString(file)).convertToFormat(QImage::Format_RGB32);
  }

  test::StudyPhantom Phantom;
};

TEST_F(ViewerImagesTest, KeepApparentSizeOnHighResolutionScreens)
{
  char name[] = "ViewerTests";
  char* all[] = {name, nullptr};
  int count = 1;
  const QCoreApplication application(count, all);
  const QImage plain = this->Take(1);
  const QImage fine = this->Take(2);
  ASSERT_EQ(plain.size(), QSize(Width, Height));
  ASSERT_EQ(fine.size(), QSize(2 * Width, 2 * Height));
  const Bar bar = FindScaleBar(plain);
  const Bar fineBar = FindScaleBar(fine);
  ASSERT_GT(bar.Length(), 20);
  // Each end is drawn at the nearest pixel.
  EXPECT_NEAR(fineBar.Length(), 2 * bar.Length(), 4);
  EXPECT_EQ(fineBar.Thickness(), 2 * bar.Thickness());
  EXPECT_NEAR(fineBar.Left, 2 * bar.Left, 4);
  EXPECT_NEAR(fineBar.Top, 2 * bar.Top, 4);
  // Its text is above it.
  const QRect words(fineBar.Left, fineBar.Top - 60, fineBar.Length(), 50);
  EXPECT_GT(MixedSquares(fine, words), 50);
  EXPECT_EQ(MixedSquares(plain.scaled(fine.size()), words), 0) << "what the figure above excludes";
}

TEST_F(ViewerImagesTest, WhatIsNotOpenedOrSavedIsPrinted)
{
  char name[] = "ViewerTests";
  char* all[] = {name, nullptr};
  int count = 1;
  const QCoreApplication application(count, all);
  QProcess viewer;
  viewer.start(PALPATE_VIEWER, {"--no-cache", "--screenshot",
                                QString::fromStdString(this->Phantom.Folder / "none/a.png")});
  ASSERT_TRUE(viewer.waitForFinished(-1));
  EXPECT_EQ(viewer.exitCode(), 1);
  EXPECT_TRUE(viewer.readAllStandardError().contains("none/a.png"));
  viewer.start(PALPATE_VIEWER, {"--no-cache", "none.json", "--screenshot",
                                QString::fromStdString(this->Phantom.Folder / "a.png")});
  ASSERT_TRUE(viewer.waitForFinished(-1));
  EXPECT_EQ(viewer.exitCode(), 1);
  EXPECT_TRUE(viewer.readAllStandardError().contains("none.json does not exist"));
}
} // namespace
} // namespace palpate::viewer_images_test
