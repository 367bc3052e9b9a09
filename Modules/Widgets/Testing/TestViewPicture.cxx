#include "ViewPicture.h"

#include "InputError.h"
#include "PictureDialog.h"
#include "WindowTest.h"

#include "vtkCamera.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QMenu>
#include <QSpinBox>

#include <cstdlib>

namespace palpate::view_picture_test
{
namespace
{
class ViewPictureTest : public test::WindowTest
{
protected:
  ViewGrid& Views() const { return *this->Window->Views(); }
  SlicePane& Axial() const { return *this->Views().Slice(SliceOrientation::Axial); }
  // The mean difference of two images of a size, in grey levels.
  static double DifferenceOf(const QImage& a, const QImage& b)
  {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
    {
      for (int x = 0; x < a.width(); ++x)
      {
        sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
      }
    }
    return sum / (a.width() * a.height());
  }
  // Bright pixels, of the volume's structures and the letters.
  static QRect BrightOf(const QImage& image)
  {
    QRect bright;
    for (int y = 0; y < image.height(); ++y)
    {
      for (int x = 0; x < image.width(); ++x)
      {
        if (qGray(image.pixel(x, y)) > 100)
        {
          bright |= QRect(x, y, 1, 1);
        }
      }
    }
    return bright;
  }
  PictureDialog* OpenDialog()
  {
    this->Action("Save picture")->trigger();
    QApplication::processEvents();
    return this->Window->findChild<PictureDialog*>();
  }
  static void Press(PictureDialog* dialog, QDialogButtonBox::StandardButton button)
  {
    QPushButton* pressed = dialog->findChild<QDialogButtonBox*>()->button(button);
    Click(pressed, pressed->rect().center());
  }
};

TEST_F(ViewPictureTest, HasItsOwnSizeAndLeavesTheViewAsItWas)
{
  this->OpenPhantom();
  for (ViewPane* pane : this->Views().Panes())
  {
    const QImage before = pane->Canvas()->grab().toImage();
    const QImage picture = PictureOf(*pane, QSize(1234, 777), PictureGround::AsShown);
    EXPECT_EQ(picture.size(), QSize(1234, 777));
    EXPECT_FALSE(picture.hasAlphaChannel());
    EXPECT_EQ(pane->Canvas()->grab().toImage(), before) << pane->objectName().toStdString();
  }
}

TEST_F(ViewPictureTest, ShowsWhatTheViewShows)
{
  this->OpenPhantom();
  for (ViewPane* pane : this->Views().Panes())
  {
    const QImage shown = pane->Canvas()->grab().toImage();
    const QImage picture = PictureOf(*pane, 3 * shown.size(), PictureGround::AsShown);
    const QImage small =
        picture.scaled(shown.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    // Edges and letters differ by their smoothing; without the same text size it is above 10.
    EXPECT_LT(DifferenceOf(small, shown), 3.0) << pane->objectName().toStdString();
  }
}

TEST_F(ViewPictureTest, NarrowPictureShowsTheWholeWidth)
{
  this->OpenPhantom();
  this->Axial().View()->AnnotationVisibilityOff();
  this->Views().Space()->View()->AnnotationVisibilityOff();
  for (ViewPane* pane :
       {static_cast<ViewPane*>(&this->Axial()), static_cast<ViewPane*>(this->Views().Space())})
  {
    const QSize shown = pane->Canvas()->size();
    const QImage alike = PictureOf(*pane, shown, PictureGround::AsShown);
    const QImage narrow =
        PictureOf(*pane, QSize(shown.width() / 2, 2 * shown.height()), PictureGround::AsShown);
    const QRect bright = BrightOf(alike);
    ASSERT_GT(bright.width(), shown.width() / 8);
    EXPECT_NEAR(BrightOf(narrow).width(), 0.5 * bright.width(), 3.0)
        << pane->objectName().toStdString();
  }
}

TEST_F(ViewPictureTest, BackgroundIsTransparentIfAsked)
{
  this->OpenPhantom();
  SpacePane* space = this->Views().Space();
  const QImage clear = PictureOf(*space, QSize(400, 300), PictureGround::Transparent);
  const QImage opaque = PictureOf(*space, QSize(400, 300), PictureGround::AsShown);
  EXPECT_EQ(qAlpha(clear.pixel(2, 2)), 0);
  int covered = 0;
  for (int x = 0; x < clear.width(); ++x)
  {
    covered += qAlpha(clear.pixel(x, 150)) == 255 ? 1 : 0;
  }
  EXPECT_GT(covered, 30) << "the structures are opaque";
  EXPECT_EQ(qAlpha(opaque.pixel(2, 2)), 255);
}

TEST_F(ViewPictureTest, BackgroundIsWhiteIfAsked)
{
  this->OpenPhantom();
  for (ViewPane* pane : this->Views().Panes())
  {
    const QImage image = PictureOf(*pane, QSize(600, 200), PictureGround::White);
    EXPECT_EQ(image.pixelColor(image.width() - 20, 60), QColor(Qt::white))
        << pane->Name().toStdString();
    EXPECT_FALSE(image.hasAlphaChannel());
  }
}

TEST_F(ViewPictureTest, HeaderAndMenuCopyAViewAndSaveItForPrint)
{
  this->OpenPhantom();
  SpacePane* space = this->Views().Space();
  const auto entries = space->findChild<ViewHeader*>()->actions();
  ASSERT_EQ(entries.size(), 2);
  EXPECT_EQ(space->findChild<ViewHeader*>()->contextMenuPolicy(), Qt::ActionsContextMenu);
  QApplication::clipboard()->clear();
  entries[0]->trigger();
  EXPECT_EQ(QApplication::clipboard()->image().size(), space->Canvas()->size());
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "figure").string());
  entries[1]->trigger();
  this->FinishWriting();
  const QImage saved(this->SavedTo + ".png");
  EXPECT_EQ(saved.size(), 2 * space->Canvas()->size());
  EXPECT_EQ(saved.pixelColor(2, 2), QColor(Qt::white));
  int menus = 0;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    const QString text = QString(action->text()).remove('&');
    if (action->menu() != nullptr &&
        (text.startsWith("Copy image") || text.startsWith("Save image")))
    {
      ++menus;
      EXPECT_EQ(action->menu()->actions().size(), 4) << "one for each view";
    }
  }
  EXPECT_EQ(menus, 2);
}

TEST_F(ViewPictureTest, FourViewsAreThoseOfEachView)
{
  this->OpenPhantom();
  const QImage all = PictureOf(this->Views(), QSize(802, 602), PictureGround::AsShown);
  ASSERT_EQ(all.size(), QSize(802, 602));
  const QImage axial = PictureOf(this->Axial(), QSize(400, 300), PictureGround::AsShown);
  const QImage space = PictureOf(*this->Views().Space(), QSize(400, 300), PictureGround::AsShown);
  EXPECT_LT(DifferenceOf(all.copy(0, 0, 400, 300), axial), 0.01);
  EXPECT_LT(DifferenceOf(all.copy(402, 0, 400, 300), space), 0.01);
}

TEST_F(ViewPictureTest, ViewThatIsNotShownIsDrawnToo)
{
  // Before anything is shown.
  this->Action("One view")->trigger();
  this->Study->OpenVolume(this->VolumeFile());
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  DrawAll(this->Views());
  ASSERT_FALSE(this->Axial().isVisible());
  const QImage picture = PictureOf(this->Axial(), QSize(300, 300), PictureGround::AsShown);
  EXPECT_GT(BrightOf(picture).width(), 100);
  EXPECT_FALSE(this->Axial().isVisible());
}

TEST_F(ViewPictureTest, DialogSavesTheChosenViewAtTheChosenSize)
{
  this->OpenPhantom();
  PictureDialog* dialog = this->OpenDialog();
  ASSERT_NE(dialog, nullptr);
  auto* content = dialog->findChild<QComboBox*>("picture-content");
  auto* width = dialog->findChild<QSpinBox*>("picture-width");
  auto* height = dialog->findChild<QSpinBox*>("picture-height");
  content->setCurrentText("3-D view");
  const QSize shown = this->Views().Space()->Canvas()->size();
  EXPECT_EQ(QSize(width->value(), height->value()), 2 * this->Window->devicePixelRatioF() * shown);
  width->setValue(640);
  height->setValue(500);
  dialog->findChild<QCheckBox*>("picture-transparent")->setChecked(true);
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "figure").string());
  Press(dialog, QDialogButtonBox::Save);
  this->FinishWriting();
  const QImage saved(this->SavedTo + ".png");
  EXPECT_EQ(saved.size(), QSize(640, 500));
  EXPECT_EQ(qAlpha(saved.pixel(2, 2)), 0);
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

TEST_F(ViewPictureTest, WindowHasNoOtherSize)
{
  PictureDialog* dialog = this->OpenDialog();
  dialog->findChild<QComboBox*>("picture-content")->setCurrentText("The whole window");
  EXPECT_FALSE(dialog->findChild<QSpinBox*>("picture-width")->isEnabled());
  const QSize size = this->Window->devicePixelRatioF() * this->Window->size();
  EXPECT_EQ(dialog->findChild<QSpinBox*>("picture-width")->value(), size.width());
  EXPECT_EQ(dialog->Picture().size(), size);
}

TEST_F(ViewPictureTest, CancelledPictureIsNotWritten)
{
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "figure.png").string());
  Press(this->OpenDialog(), QDialogButtonBox::Cancel);
  EXPECT_FALSE(std::filesystem::exists(this->Phantom.Folder / "figure.png"));
}

TEST_F(ViewPictureTest, PictureThatCannotBeWrittenIsToldAndLeavesNoFile)
{
  this->SavedTo = "/nowhere/figure.png";
  Press(this->OpenDialog(), QDialogButtonBox::Save);
  this->FinishWriting();
  EXPECT_NE(this->Messages().find("/nowhere/figure.png"), std::string::npos) << this->Messages();
  const auto file = this->Phantom.Folder / "none.png";
  EXPECT_THROW(WritePicture(QImage(), file), InputError);
  EXPECT_FALSE(std::filesystem::exists(file));
}
} // namespace
} // namespace palpate::view_picture_test
