#include "FieldNodes.h"
#include "StartPage.h"
#include "StatusLine.h"
#include "StructureTable.h"
#include "ThresholdDialog.h"
#include "TouchNotice.h"
#include "TrialWindow.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QSlider>

namespace palpate::trial_test
{
namespace
{
// The work of Documentation/HowTo/Viewer.md, in its order, by mouse and keyboard.
class TrialTest : public test::TrialWindow
{
protected:
  void OpenCt()
  {
    EXPECT_TRUE(this->Window->findChild<StartPage*>()->isVisible());
    this->Drop(this->Ct);
    WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
    EXPECT_FALSE(this->Window->findChild<StartPage*>()->isVisible());
  }
  void Look()
  {
    QWidget* slice = this->Window->Views()->Slice(SliceOrientation::Axial)->Canvas();
    Move(slice, {120.0, 90.0});
    EXPECT_NE(this->Window->findChild<StatusLine*>()->PointText(), "");
    Click(slice, {120.0, 90.0});
    EXPECT_TRUE(this->Study->State().View.CrosshairWorld.has_value());
    Wheel(slice, {120.0, 90.0}, 1);
  }
  void AddMr()
  {
    this->Choose(this->Mr);
    this->Type(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    WaitUntil([this] { return this->Window->Contents().Images()->GetNumberOfOverlays() == 1; });
    auto* volumes = this->Window->findChild<QListWidget*>("volumes");
    QTest::keyClick(volumes, Qt::Key_Down);
    ASSERT_EQ(volumes->currentRow(), 1);
    auto* opacity = this->Window->findChild<QSlider*>("volume-opacity");
    QTest::keyClick(opacity, Qt::Key_Right);
    EXPECT_GT(this->Study->State().Volumes.at(0).Opacity, 0.5);
  }
  void AddBone()
  {
    this->Type(Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
    auto* dialog = this->Window->findChild<ThresholdDialog*>();
    ASSERT_NE(dialog, nullptr) << this->Messages();
    ClickOn(dialog->findChild<QPushButton*>("threshold-bone"));
    auto* name = dialog->findChild<QLineEdit*>("threshold-name");
    name->selectAll();
    QTest::keyClicks(name, "Mastoid");
    ClickOn(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
    ASSERT_EQ(this->Study->State().Structures.size(), 1U) << this->Messages();
    EXPECT_EQ(this->Study->State().Structures[0].Name, "Mastoid");
  }
  void AddNerve()
  {
    this->Choose(this->Nerve);
    this->Type(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
    WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
    this->Settle();
  }
  // The MR volume as the texture of the bone.
  void FeelMr()
  {
    this->Window->findChild<StructureTable*>("structures")->selectRow(0);
    QTimer::singleShot(
        0, this->Window.get(),
        [this]
        {
          QWidget* dialog = QApplication::activeModalWidget();
          QLineEdit* image = dialog->findChild<QComboBox*>("texture_image")->lineEdit();
          image->selectAll();
          QTest::keyClicks(image, QString::fromStdString(this->Mr.string()));
          dialog->findChild<QDoubleSpinBox*>("texture_n")->setValue(0.2);
          ClickOn(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
        });
    ClickOn(this->Button("structure-details"));
    EXPECT_EQ(this->Study->State().Structures[0].Image("texture_image"), this->Mr);
    WaitUntil(
        [this]
        {
          const auto contacts = this->Study->Current().Contacts();
          return !contacts.empty() && contacts[0].Effects != nullptr;
        });
  }
  void Touch()
  {
    this->BeginTouch();
    this->Press(Vector3::Zero(), 0.3, this->Study->State().Structures[0].Id);
  }
  void MeasureDistance()
  {
    Activate(*this->Window);
    QTest::keyClick(this->Window.get(), Qt::Key_A);
    QWidget* slice = this->Window->Views()->Slice(SliceOrientation::Coronal)->Canvas();
    Click(slice, {90.0, 70.0});
    Click(slice, {140.0, 90.0});
    QTest::keyClick(this->Window.get(), Qt::Key_A);
    ASSERT_EQ(this->Study->State().Landmarks.size(), 2U);
    this->Window->findChild<QTableWidget*>("landmarks")->selectAll();
    ClickOn(this->Button("add-distance"));
    ASSERT_EQ(this->Study->State().Measurements.size(), 1U) << this->Messages();
    EXPECT_GT(ValueOf(this->Study->State().Measurements[0]).value_or(0.0), 1.0);
  }
  // Bone as soft tissue, so that little servo time is needed; the nerve forbidden.
  void ChooseRoles()
  {
    // The cell opens by a click, its list by itself.
    const auto choose = [this](int row, int role)
    {
      auto* table = this->Window->findChild<StructureTable*>("structures");
      const QModelIndex cell = table->model()->index(row, StructureTableModel::DrillColumn);
      QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier,
                        table->visualRect(cell).center());
      // Former ones may still be there.
      const auto lists = table->viewport()->findChildren<QComboBox*>();
      ASSERT_FALSE(lists.isEmpty());
      QComboBox* list = lists.last();
      list->setCurrentIndex(role);
      Q_EMIT list->activated(role);
      list->hidePopup();
      QApplication::processEvents();
    };
    this->Action("Drilling")->trigger();
    choose(0, 2);
    choose(1, 3);
    EXPECT_TRUE(this->Study->State().Structures[0].IsDrilled());
    EXPECT_TRUE(this->Study->State().Structures[1].IsForbidden);
    auto* burr = this->Window->findChild<QDoubleSpinBox*>("burr-radius");
    burr->selectAll();
    QTest::keyClicks(burr, "2");
    QTest::keyClick(burr, Qt::Key_Return);
    EXPECT_EQ(this->Study->State().Tool.Radius, 2.0);
    this->Settle();
    WaitUntil([this] { return this->Study->Reading().Drill.Hold.empty(); });
  }
  // With the wheel towards the nerve, the D key held, for some time after the alarm.
  void DrillToTheNerve()
  {
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    const QPointF place = this->PlaceOf(Vector3::Zero());
    Move(canvas, place);
    QTest::keyPress(this->Window->Views(), Qt::Key_D);
    constexpr double Deepest = 1.5; // mm
    constexpr std::uint64_t Longer = 500;
    std::uint64_t last = 0;
    std::uint64_t alarmed = 0;
    this->FeelUntil(
        [&]
        {
          const StudyTouchReading& now = this->Study->Reading();
          const std::uint64_t tick = now.Newest.Tick.Number;
          if (tick >= last + 20 && now.Newest.Depth < Deepest)
          {
            last = tick;
            Wheel(canvas, place, 1);
          }
          const auto& near = now.Drill.Approaches;
          const bool isAlarm = !near.empty() && near[0].IsAlarmed;
          alarmed = isAlarm && alarmed == 0 ? tick : alarmed;
          return isAlarm && tick > alarmed + Longer;
        });
    EXPECT_EQ(this->Window->findChild<StatusLine*>()->TouchText(),
              TouchNotice::AlarmText(this->Study->Reading().Drill));
    QTest::keyRelease(this->Window->Views(), Qt::Key_D);
    WaitUntil([this] { return !this->Study->Reading().Newest.IsDrilling; });
    ClickOn(this->Button("start-touch"));
    EXPECT_FALSE(this->Study->IsTouching());
    WaitUntil([this] { return this->Removed() > 10.0; });
  }
  double NearestCutToTheNerve() const
  {
    double nearest = BoneRadius;
    vtkPolyData* cut = this->Study->Reading().Drill.Drilled.at(0).Cut;
    for (vtkIdType n = 0; n < cut->GetNumberOfPoints(); ++n)
    {
      const Vector3 point(cut->GetPoint(n));
      nearest = std::min(nearest, std::hypot(point.x(), point.y()));
    }
    return nearest;
  }
  void Save()
  {
    this->SavedTo = QString::fromStdString(this->File.string());
    this->Type(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(std::filesystem::exists(this->File)) << this->Messages();
  }
  // With the MR volume in another place.
  void ReopenWithAMissingFile()
  {
    std::filesystem::rename(this->Mr, this->MovedMr);
    this->Found = QString::fromStdString(this->MovedMr.string());
    this->Type(Qt::Key_N, Qt::ControlModifier);
    EXPECT_TRUE(this->Window->findChild<StartPage*>()->isVisible());
    this->Choose(this->File);
    this->Type(Qt::Key_O, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(this->TimesAskedToSave, 0);
    WaitUntil([this] { return !this->AskedFor.empty(); });
    this->Settle();
    WaitUntil([this] { return this->Window->Contents().Cuts().size() == 1; });
    WaitUntil([this] { return this->Window->Contents().Images()->GetNumberOfOverlays() == 1; });
    DrawAll(*this->Window->Views());
  }

  std::filesystem::path File = this->Phantom.Folder / "trial.palpate.json";
};

TEST_F(TrialTest, FromAnEmptyWindowToTheSameStateReopened)
{
  this->OpenCt();
  this->Look();
  this->AddMr();
  this->AddBone();
  this->AddNerve();
  this->FeelMr();
  this->Touch();
  this->MeasureDistance();
  this->ChooseRoles();
  this->DrillToTheNerve();
  // Accurate to a voxel of the CT.
  EXPECT_GT(this->NearestCutToTheNerve(), NerveRadius - Voxel);
  EXPECT_LT(this->NearestCutToTheNerve(), NerveRadius + 2.0) << "nearer than the alarm";
  this->Save();
  const StudyState saved = this->Study->State();
  const double removed = this->Removed();
  ASSERT_NE(this->Shown(saved.Structures[0].Id), nullptr);
  const std::vector<float> voxels = NodesOf(*this->Shown(saved.Structures[0].Id), 0);
  this->ReopenWithAMissingFile();
  ASSERT_EQ(this->AskedFor.size(), 1U);
  EXPECT_EQ(this->AskedFor[0].Path, this->Mr);
  EXPECT_EQ(this->Study->State(), Relocate(saved, this->Mr, this->MovedMr));
  EXPECT_EQ(this->Removed(), removed);
  ASSERT_NE(this->Shown(saved.Structures[0].Id), nullptr);
  EXPECT_EQ(NodesOf(*this->Shown(saved.Structures[0].Id), 0), voxels);
  EXPECT_EQ(this->Messages(), "");
}
} // namespace
} // namespace palpate::trial_test
