#include "ForceButton.h"
#include "GuideDialog.h"
#include "LandmarksPanel.h"
#include "PictureDialog.h"
#include "PreferencesDialog.h"
#include "SafetyReport.h"
#include "StructureDialog.h"
#include "ThresholdDialog.h"
#include "ViewBanner.h"
#include "WindowTest.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QScrollBar>
#include <QToolButton>

#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace palpate::window_layout_test
{
namespace
{
class WindowLayoutTest : public test::WindowTest
{
protected:
  WorkColumn* Column() const { return this->Window->findChild<WorkColumn*>(); }
  void OpenAllSections()
  {
    for (Section* section : this->Column()->Sections())
    {
      section->Open(true);
    }
    QApplication::processEvents();
  }
  std::vector<QWidget*> Controls() const { return ControlsOf(*this->Column()); }
  static std::vector<QWidget*> ControlsOf(const QWidget& parent)
  {
    std::vector<QWidget*> controls;
    for (auto* widget : parent.findChildren<QWidget*>())
    {
      const bool isControl = qobject_cast<QAbstractButton*>(widget) != nullptr ||
                             qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
                             qobject_cast<QComboBox*>(widget) != nullptr;
      if (isControl && widget->isVisible() &&
          qobject_cast<QAbstractScrollArea*>(widget->parentWidget()->parentWidget()) == nullptr)
      {
        controls.push_back(widget);
      }
    }
    return controls;
  }
  bool IsBannerShown() const
  {
    const auto* banner = this->Window->Views()->Space()->findChild<ViewBanner*>();
    return banner->isVisible() && !banner->text().isEmpty();
  }
};

// Controls that say less than their text needs.
void ExpectNothingClipped(const std::vector<QWidget*>& controls, int width)
{
  for (QWidget* control : controls)
  {
    const std::string name = control->objectName().toStdString() + " of " +
                             control->metaObject()->className() + " at " + std::to_string(width);
    const QSize least = control->minimumSizeHint();
    EXPECT_GE(control->width(), least.width()) << name;
    EXPECT_GE(control->height(), least.height()) << name;
  }
}

// Written where PALPATE_PICTURES says, for people to look at.
void ShowPicture(QWidget& widget, const std::string& name)
{
  if (const char* folder = std::getenv("PALPATE_PICTURES"))
  {
    EXPECT_TRUE(widget.grab().save(QString(folder) + "/" + QString::fromStdString(name) + ".png"));
  }
}

// The last is 1600 x 1000 at scale 2.
const std::array<QSize, 4> Sizes{QSize(1024, 700), QSize(1280, 800), QSize(1600, 1000),
                                 QSize(800, 500)};

TEST_F(WindowLayoutTest, NothingIsClippedAtUsualSizes)
{
  this->OpenPhantom();
  this->OpenAllSections();
  for (const QSize size : Sizes)
  {
    this->Window->resize(size);
    QApplication::processEvents();
    EXPECT_EQ(this->Window->size(), size) << "the window can be as small as that";
    const std::vector<QWidget*> controls = this->Controls();
    EXPECT_GT(controls.size(), 30U);
    ExpectNothingClipped(controls, size.width());
    for (QWidget* control : controls)
    {
      const int right = control->mapTo(this->Column()->viewport(), control->rect().topRight()).x();
      EXPECT_LT(right, this->Column()->viewport()->width()) << control->objectName().toStdString();
    }
    DrawAll(*this->Window->Views());
    ShowPicture(*this->Window, "window-" + std::to_string(size.width()));
  }
}

TEST_F(WindowLayoutTest, PanelOfMeasurementsIsNotClippedAtUsualSizes)
{
  this->OpenPhantom();
  this->Action("Add landmarks by click")->setChecked(true);
  auto* panel = this->Window->findChild<LandmarksPanel*>();
  for (const QSize size : Sizes)
  {
    this->Window->resize(size);
    QApplication::processEvents();
    EXPECT_EQ(this->Window->size(), size) << "the window can be as small as that";
    ASSERT_TRUE(panel->isVisible());
    ExpectNothingClipped(ControlsOf(*panel), size.width());
    DrawAll(*this->Window->Views());
    ShowPicture(*this->Window, "measurements-" + std::to_string(size.width()));
  }
}

// 800 x 500 is left of 1600 x 1000 at scale 2.
TEST_F(WindowLayoutTest, DialogsFitTheSmallestScreenUnclipped)
{
  this->OpenPhantom();
  KeyBindings keys(this->Window.get());
  const int id = this->Study->State().Structures.front().Id;
  PreferencesDialog preferences(keys, this->Window.get());
  GuideDialog guide(*this->Study, id, this->Window.get());
  StructureDialog structure(*this->Study, id, this->Window.get());
  ThresholdDialog threshold(*this->Study, this->Window->Contents().Images(), this->Window.get());
  PictureDialog picture(*this->Window->Views(), this->Window.get());
  this->Action("Link with other programs...")->trigger();
  auto* link = this->Window->findChild<QDialog*>("link");
  ASSERT_NE(link, nullptr);
  this->Action("Open cohort...")->trigger();
  auto* cohort = this->Window->findChild<QDialog*>("cohort-window");
  ASSERT_NE(cohort, nullptr);
  const std::map<std::string, QDialog*> dialogs{
      {"link", link},       {"cohort", cohort},        {"preferences", &preferences},
      {"guide", &guide},    {"structure", &structure}, {"threshold", &threshold},
      {"picture", &picture}};
  for (const auto& [name, dialog] : dialogs)
  {
    dialog->show();
    // The X server may tell the size at creation first.
    WaitUntil([dialog = dialog] { return dialog->height() >= dialog->minimumSizeHint().height(); });
    EXPECT_LE(dialog->minimumSizeHint().width(), 800) << name;
    EXPECT_LE(dialog->minimumSizeHint().height(), 500) << name;
    EXPECT_LE(dialog->frameGeometry().height(), 700) << name << " opens on a small screen";
    ExpectNothingClipped(ControlsOf(*dialog), dialog->width());
    ShowPicture(*dialog, "dialog-" + name);
    dialog->hide();
  }
}

TEST_F(WindowLayoutTest, ColumnScrollsAsOne)
{
  this->OpenAllSections();
  this->Window->resize(1024, 700);
  QApplication::processEvents();
  EXPECT_GT(this->Column()->verticalScrollBar()->maximum(), 0);
  EXPECT_EQ(this->Column()->horizontalScrollBar()->maximum(), 0);
}

TEST_F(WindowLayoutTest, SectionsStayAsTheyWereLeft)
{
  Section* drilling = this->Column()->Sections().back();
  ASSERT_EQ(drilling->Title(), "Drilling");
  EXPECT_FALSE(drilling->IsOpen());
  drilling->findChild<QToolButton*>("fold-drilling")->click();
  EXPECT_TRUE(drilling->IsOpen());
  const MainWindow next(*this->Study);
  EXPECT_TRUE(next.findChild<WorkColumn*>()->Sections().back()->IsOpen());
}

TEST_F(WindowLayoutTest, MenuUnfoldsASectionAndShowsIt)
{
  this->OpenAllSections();
  Section* drilling = this->Column()->Sections().back();
  drilling->Open(false);
  this->Action("Drilling")->trigger();
  EXPECT_TRUE(drilling->IsOpen());
  WaitUntil(
      [&]
      {
        const QPoint place = drilling->mapTo(this->Column()->viewport(), QPoint(0, 0));
        return this->Column()->viewport()->rect().contains(place);
      });
}

TEST_F(WindowLayoutTest, EmptyWindowOffersFilesInsteadOfViews)
{
  auto* start = this->Window->findChild<StartPage*>();
  EXPECT_TRUE(start->isVisible());
  EXPECT_FALSE(this->Window->Views()->isVisible());
  this->Opened = QStringList{QString::fromStdString(this->MaskFile().string())};
  this->Button("start-open")->click();
  WaitUntil([this] { return this->Window->Views()->isVisible(); });
  EXPECT_FALSE(start->isVisible());
  this->Settle();
  this->Action("New study")->trigger();
  WaitUntil([&] { return start->isVisible(); });
  auto* recent =
      qobject_cast<StartTile*>(start->findChild<TileGrid*>("start-recent")->Tiles().front());
  EXPECT_EQ(recent->text(), "mask.nii.gz");
  recent->click();
  WaitUntil([this] { return this->Window->Views()->isVisible(); });
  EXPECT_EQ(this->Study->State().SegmentationFile, this->MaskFile());
}

TEST_F(WindowLayoutTest, ForceButtonNeverMoves)
{
  this->OpenPhantom();
  QPushButton* force = this->Button("stop-force");
  const auto place = [&]
  { return QRect(force->mapTo(this->Window.get(), QPoint()), force->size()); };
  const QRect first = place();
  EXPECT_FALSE(force->isEnabled());
  this->BeginTouch();
  WaitUntil([&] { return force->isEnabled(); });
  EXPECT_EQ(place(), first);
  this->Study->Current().Touch().SwitchForcesOff();
  WaitUntil([&] { return force->text() == "Allow force again"; });
  EXPECT_EQ(place(), first);
  this->Study->Report("A message that takes some lines of the window, since it is long: " +
                      std::string(400, 'x'));
  QApplication::processEvents();
  EXPECT_EQ(place(), first);
}

TEST_F(WindowLayoutTest, PressingStopTwiceDoesNotAllowForce)
{
  this->OpenPhantom();
  this->BeginTouch();
  QPushButton* force = this->Button("stop-force");
  WaitUntil([&] { return force->isEnabled(); });
  const auto fault = [this] { return this->Study->Reading().Newest.Safety.Fault; };
  WaitUntil([&] { return fault() == SafetyFault::None; });
  force->click();
  force->click();
  WaitUntil([&] { return fault() == SafetyFault::SwitchedOff; });
  force->click();
  const std::uint64_t tick = this->Study->Reading().Newest.Tick.Number;
  WaitUntil([&] { return this->Study->Reading().Newest.Tick.Number > tick + 50; });
  EXPECT_EQ(fault(), SafetyFault::SwitchedOff);
  WaitUntil([&] { return force->isEnabled(); });
  force->click();
  WaitUntil([&] { return fault() == SafetyFault::None; });
}

TEST_F(WindowLayoutTest, PressingStopRightAfterForceEndedDoesNotAllowIt)
{
  this->OpenPhantom();
  this->BeginTouch();
  QPushButton* force = this->Button("stop-force");
  const auto fault = [this] { return this->Study->Reading().Newest.Safety.Fault; };
  WaitUntil([&] { return force->isEnabled() && fault() == SafetyFault::None; });
  this->Study->Current().Touch().SwitchForcesOff();
  WaitUntil([&] { return force->text() == "Allow force again"; });
  EXPECT_FALSE(force->isEnabled());
  force->click();
  const std::uint64_t tick = this->Study->Reading().Newest.Tick.Number;
  WaitUntil([&] { return this->Study->Reading().Newest.Tick.Number > tick + 50; });
  EXPECT_EQ(fault(), SafetyFault::SwitchedOff);
}

TEST(ForceButton, StopsWhileAFaultEndsByItself)
{
  SafetyReport safety;
  EXPECT_FALSE(ForceButton::IsOff(safety));
  safety.Fault = SafetyFault::StalledTick;
  EXPECT_TRUE(ForceButton::IsOff(safety));
  safety.WillResume = true;
  EXPECT_FALSE(ForceButton::IsOff(safety));
}

TEST_F(WindowLayoutTest, EveryViewSaysThatThereIsNoForce)
{
  this->OpenPhantom();
  this->BeginTouch();
  EXPECT_FALSE(this->IsBannerShown());
  this->Study->Current().Touch().SwitchForcesOff();
  WaitUntil([this] { return this->IsBannerShown(); });
  EXPECT_EQ(this->Window->findChild<QLabel*>("touch-state")->text(), "No force");
  this->Study->Current().Touch().SwitchForcesOn();
  WaitUntil([this] { return !this->Window->findChild<ViewBanner*>()->isVisible(); });
}

TEST(TouchNotice, NearestAlarmComesBeforeTheMissingForce)
{
  StudyTouchReading reading;
  EXPECT_EQ(TouchNotice::Of(reading).Is, TouchNotice::Kind::None);
  reading.Newest.Safety.Fault = SafetyFault::SwitchedOff;
  reading.Safety = "Forces are off.";
  EXPECT_EQ(TouchNotice::Of(reading).Is, TouchNotice::Kind::NoForce);
  EXPECT_EQ(TouchNotice::Of(reading).Text, "No force. Forces are off.");
  reading.Drill.Approaches.resize(3);
  reading.Drill.Approaches[0].Name = "Putamen_L";
  reading.Drill.Approaches[0].Distance = 1.24;
  reading.Drill.Approaches[0].IsAlarmed = true;
  EXPECT_EQ(TouchNotice::Of(reading).Text, "Drill is 1.2 mm from Putamen_L");
  reading.Drill.Approaches[1].Name = "Pallidum_L";
  reading.Drill.Approaches[1].Distance = -0.31;
  reading.Drill.Approaches[1].IsAlarmed = true;
  reading.Drill.Approaches[2].Distance = -5.0;
  EXPECT_EQ(TouchNotice::Of(reading).Is, TouchNotice::Kind::Alarm);
  EXPECT_EQ(TouchNotice::Of(reading).Text, "Drill touches Pallidum_L (0.3 mm inside)");
}
} // namespace
} // namespace palpate::window_layout_test
