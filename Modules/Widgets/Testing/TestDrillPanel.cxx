#include "DrillPanel.h"
#include "DrillWindowTest.h"

#include <QDoubleSpinBox>
#include <QLineEdit>

#include <cmath>

namespace palpate::drill_panel_test
{
namespace
{
class DrillPanelTest : public test::DrillWindowTest
{
protected:
  DrillPanel* Panel() const { return this->Window->findChild<DrillPanel*>(); }
  // Until the servo has received the key.
  void HoldPedal()
  {
    this->Key(QEvent::KeyPress, Qt::Key_D);
    this->FeelUntil([this] { return this->Study->Reading().Newest.IsDrilling; });
  }
};

TEST_F(DrillPanelTest, RolesAreUndoStepsAndRestoredBySession)
{
  this->OpenPhantom();
  this->Choose(0, 1);
  EXPECT_TRUE(this->Study->State().Structures[0].IsDrilled());
  this->Choose(1, 3);
  EXPECT_TRUE(this->Study->State().Structures[1].IsForbidden);
  const auto alarm = [this](int row)
  { return this->Table()->index(row, StructureTableModel::AlarmColumn); };
  ASSERT_TRUE(this->Table()->flags(alarm(1)) & Qt::ItemIsEditable);
  EXPECT_FALSE(this->Table()->flags(alarm(0)) & Qt::ItemIsEditable) << "it is not forbidden";
  this->Table()->setData(alarm(1), 4.5);
  EXPECT_EQ(this->Study->State().Structures[1].AlarmDistance, 4.5);
  this->Window->findChild<QDoubleSpinBox*>("burr-radius")->setValue(2.5);
  EXPECT_EQ(this->Study->State().Tool.Radius, 2.5);
  this->Window->findChild<QDoubleSpinBox*>("burr-turns")->setValue(800.0);
  EXPECT_EQ(this->Study->State().Drill.Turns, 800.0);
  const StudyState before = this->Study->State();
  const std::filesystem::path file = this->Phantom.Folder / "drilled.palpate.json";
  ASSERT_TRUE(this->Study->Save(file)) << this->Messages();
  this->Study->New();
  this->Study->OpenSession(file);
  EXPECT_EQ(this->Study->State(), before);
  this->Action("Undo");
}

TEST_F(DrillPanelTest, DeactivatedWindowReleasesPedal)
{
  this->StartDrilling();
  QApplication::setActiveWindow(this->Window.get());
  this->HoldPedal();
  QWidget other;
  other.show();
  QApplication::setActiveWindow(&other);
  WaitUntil([this] { return !this->Study->Reading().Newest.IsDrilling; });
}

TEST_F(DrillPanelTest, KeyReleaseReleasesPedalDespiteOtherKeys)
{
  this->StartDrilling();
  QLineEdit text;
  const std::pair<QObject*, Qt::KeyboardModifier> paths[] = {
      {this->Window->Views(), Qt::ShiftModifier}, {&text, Qt::NoModifier}};
  for (const auto& [receiver, modifier] : paths)
  {
    this->HoldPedal();
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_D, modifier);
    QApplication::sendEvent(receiver, &release);
    WaitUntil([this] { return !this->Study->Reading().Newest.IsDrilling; });
  }
}

TEST_F(DrillPanelTest, ShowsDrilledHoleAtOnceAndUndoesIt)
{
  this->StartDrilling();
  EXPECT_EQ(this->Removed(), 0.0);
  const auto undrilled = this->Shown();
  ASSERT_NE(undrilled, nullptr);
  this->Drill(20.0);
  EXPECT_NE(this->Shown(), undrilled);
  EXPECT_EQ(this->Shown(), this->Study->Reading().Drill.Drilled[0].Field);
  EXPECT_NE(this->StatusOf(0).find("removed"), std::string::npos);
  WaitUntil([this] { return this->Window->Contents().Cuts().size() == 1; });
  DrawAll(*this->Window->Views());
  EXPECT_GT(this->Window->Contents().Cuts().at(1)->GetSurface()->GetNumberOfCells(), 50);
  ASSERT_TRUE(this->Button("drill-undo")->isEnabled());
  this->Button("drill-undo")->click();
  WaitUntil([this] { return this->Removed() == 0.0; });
  WaitUntil([this] { return this->Button("drill-redo")->isEnabled(); });
  this->Button("drill-redo")->click();
  WaitUntil([this] { return this->Removed() > 20.0; });
}

TEST_F(DrillPanelTest, RemovedVolumeStaysReadableAfterATouch)
{
  this->StartDrilling();
  this->Drill(20.0);
  this->Study->StopTouch();
  WaitUntil([this] { return !this->Study->IsTouching(); });
  EXPECT_NE(this->StatusOf(0).find("removed"), std::string::npos) << this->StatusOf(0);
  EXPECT_FALSE(this->Button("drill-pedal")->isEnabled());
  EXPECT_FALSE(this->Button("drill-undo")->isEnabled());
}

TEST_F(DrillPanelTest, HolesOutliveTouchesAndAreSavedOpenedAndExported)
{
  this->StartDrilling();
  this->Drill(10.0);
  this->Study->StopTouch();
  const double before = this->Study->Current().Touch().Drill().Last().Drilled[0].RemovedVolume;
  ASSERT_GT(before, 10.0);
  const std::filesystem::path state = this->Phantom.Folder / "drill.state";
  this->SavedTo = QString::fromStdString(state.string());
  this->Button("drill-save")->click();
  this->FinishWriting();
  EXPECT_TRUE(std::filesystem::exists(state)) << this->Messages();
  const std::filesystem::path surface = this->Phantom.Folder / "left.stl";
  this->SavedTo = QString::fromStdString(surface.string());
  this->Button("drill-export")->click();
  this->FinishWriting();
  EXPECT_TRUE(std::filesystem::exists(surface)) << this->Messages();
  this->StartTouch();
  WaitUntil([&] { return this->Removed() == before; });
  this->Button("drill-reset")->click();
  WaitUntil([this] { return this->Removed() == 0.0; });
  this->Opened = QStringList(QString::fromStdString(state.string()));
  this->Button("drill-open")->click();
  WaitUntil([&] { return this->Removed() == before || !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), "");
}

TEST_F(DrillPanelTest, ForbiddenStructureRaisesAlarm)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures.resize(2);
  next.Structures[0].Drill.Wear = 2.0;
  next.Structures[1].IsForbidden = true;
  next.Structures[1].AlarmDistance = 1000.0; // wherever the drill is
  next.Tool.Radius = 3.0;
  this->Study->Change("Forbid the horseshoe", next);
  this->Settle();
  this->StartTouch();
  WaitUntil([this] { return !this->Panel()->AlarmWords().isEmpty(); });
  const auto& approaches = this->Study->Reading().Drill.Approaches;
  ASSERT_EQ(approaches.size(), 1U);
  const double distance = approaches[0].Distance;
  const Vector3 drill = this->Study->Reading().Newest.ProxyWorld;
  // The phantom's ring has a radius of 9 mm about x = 14 and a thickness of 3 mm, up to a voxel.
  const double ring = std::hypot(std::hypot(drill[0] - 14.0, drill[1]) - 9.0, drill[2]) - 3.0;
  EXPECT_NEAR(distance, ring - 3.0, 1.0);
  const std::string words = this->Panel()->AlarmWords().toStdString();
  EXPECT_NE(words.find(TitleOf(next.Structures[1])), std::string::npos) << words;
  const std::string number = QString::number(std::abs(distance), 'f', 1).toStdString();
  EXPECT_NE(words.find(number + (distance < 0.0 ? " mm inside" : " mm from")), std::string::npos)
      << words;
  next.Structures[1].AlarmDistance = std::max(0.0, 0.5 * distance);
  next.Structures[1].IsForbidden = distance > 0.0; // a drill that touches it is always too near
  this->Study->Change("Forbid less", next);
  WaitUntil([this] { return this->Panel()->AlarmWords().isEmpty(); });
}
} // namespace
} // namespace palpate::drill_panel_test
