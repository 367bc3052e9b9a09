#include "CohortWindow.h"
#include "StructureDialog.h"
#include "StructureTable.h"
#include "ThresholdDialog.h"
#include "TrialWindow.h"

#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QMenu>
#include <QToolButton>

#include <cstdlib>
#include <fstream>

namespace palpate::tasks_test
{
namespace
{
using Column = StructureTableModel::Column;

// Usual tasks, by real events, with their actions counted: a click, a key, a drag, a dialog that is
// answered, each from what is open before. Movements of the pointer are free.
class TasksTest : public test::TrialWindow
{
protected:
  void SetUp() override
  {
    test::TrialWindow::SetUp();
    this->Begin();
  }
  void Begin()
  {
    this->Actions = 0;
    this->Timer.start();
  }
  // With PALPATE_TASKS, a row of the table in Documentation/Window.md.
  void End(const std::string& task, int most)
  {
    EXPECT_LE(this->Actions, most) << task;
    if (const char* file = std::getenv("PALPATE_TASKS"))
    {
      std::ofstream(file, std::ios::app)
          << "| " << task << " | " << this->Actions << " | "
          << 1e-3 * static_cast<double>(this->Timer.elapsed()) << " |\n";
    }
  }

  void Press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    ++this->Actions;
    this->Type(key, modifiers);
  }
  void Answer(const std::filesystem::path& file)
  {
    ++this->Actions;
    this->Choose(file);
    this->SavedTo = QString::fromStdString(file.string());
  }
  void ClickButton(QWidget* button)
  {
    ++this->Actions;
    ClickOn(button);
  }
  StructureTable* Rows() const { return this->Window->findChild<StructureTable*>("structures"); }
  void ClickCell(int row, int column, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    ++this->Actions;
    Activate(*this->Window); // a window in the background gives no focus
    const QModelIndex cell = this->Rows()->model()->index(row, column);
    this->Rows()->scrollTo(cell);
    QTest::mouseClick(this->Rows()->viewport(), Qt::LeftButton, modifiers,
                      this->Rows()->visualRect(cell).center());
    QApplication::processEvents();
  }
  void ChooseInCell(int row, int column, int choice)
  {
    this->ClickCell(row, column);
    ++this->Actions;
    // Former ones may still be there.
    const auto lists = this->Rows()->viewport()->findChildren<QComboBox*>();
    ASSERT_FALSE(lists.isEmpty());
    QComboBox* list = lists.last();
    list->setCurrentIndex(choice);
    Q_EMIT list->activated(choice);
    list->hidePopup();
    QApplication::processEvents();
  }
  // One movement, and one press that is held until it is felt.
  void PushAt(const Vector3& world)
  {
    WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
    ASSERT_TRUE(this->Study->IsTouching()) << this->Messages();
    QWidget* canvas = this->Window->Views()->Space()->Canvas();
    const QPointF place = this->PlaceOf(world);
    Move(canvas, place);
    ++this->Actions;
    SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    this->FeelUntil([this] { return test::Norm(this->Study->Reading().Newest.ForceWorld) > 0.3; });
    SendMouse(canvas, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  }
  void OpenMany()
  {
    test::LabelGrid grid;
    grid.Size = {{30, 30, 30}};
    grid.CenterOnOrigin();
    const auto labels =
        test::MakeLabelImage<short>(grid, [](double, double, double) { return false; });
    auto* values = static_cast<short*>(labels->GetScalarPointer());
    for (int voxel = 0; voxel < 30 * 30 * 30; ++voxel)
    {
      const int x = voxel % 30 / 6;
      const int y = voxel / 30 % 30 / 6;
      const int z = voxel / 900 / 6;
      const int label = 1 + x + 5 * y + 25 * z;
      values[voxel] = static_cast<short>(label <= 116 ? label : 0);
    }
    const std::filesystem::path file = this->Phantom.Folder / "many.nrrd";
    WriteImage(file, labels);
    this->Study->OpenSegmentation(file);
    WaitUntil([this] { return this->Study->State().Structures.size() == 116; });
    this->Settle();
  }

  int Actions = 0;
  QElapsedTimer Timer;
};

TEST_F(TasksTest, OpenAndModel)
{
  this->Answer(this->MaskFile()); // has to be there before the question
  this->Press(Qt::Key_O, Qt::ControlModifier);
  WaitUntil([this] { return !this->Window->Contents().Surfaces().empty(); });
  this->End("Open a mask and see its model", 2);
}

TEST_F(TasksTest, FirstTouchOfAGland)
{
  this->OpenPhantom();
  this->Window->Messages()->Clear(); // on structures that cannot be modelled
  this->Begin();
  this->Press(Qt::Key_T, Qt::ControlModifier);
  this->PushAt(this->SphereCenter);
  this->End("First touch of a gland", 3);
}

TEST_F(TasksTest, FirstTouchOfASkull)
{
  this->Drop(this->Ct);
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  WaitUntil([this] { return this->Button("start-touch")->isEnabled(); });
  this->Begin();
  this->Press(Qt::Key_T, Qt::ControlModifier);
  auto* values = this->Window->findChild<ThresholdDialog*>();
  ASSERT_NE(values, nullptr);
  this->ClickButton(values->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
  this->PushAt(Vector3::Zero());
  this->End("First touch of bone in a CT", 3);
}

TEST_F(TasksTest, FindOneOfMany)
{
  this->OpenMany();
  this->Begin();
  this->ClickCell(0, Column::NameColumn);
  for (const char* key : {"8", "7"})
  {
    ++this->Actions;
    QTest::keyClicks(QApplication::focusWidget(), key);
  }
  EXPECT_EQ(this->Rows()->model()->rowCount(), 1);
  ++this->Actions;
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
  EXPECT_EQ(this->Rows()->SelectedIds(), std::vector<int>{87});
  this->End("Find one of 116 structures", 4);
}

TEST_F(TasksTest, HideAllButThree)
{
  this->OpenMany();
  this->Begin();
  this->ClickCell(3, Column::NameColumn);
  this->ClickCell(5, Column::NameColumn, Qt::ControlModifier);
  this->ClickCell(7, Column::NameColumn, Qt::ControlModifier);
  this->Actions += 2; // the menu, and its entry
  this->Window->findChild<QAction*>("structures-show-only")->trigger();
  const auto& all = this->Study->State().Structures;
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const SceneStructure& one) { return one.IsVisible; }),
            3);
  this->End("Hide all of 116 but three", 5);
}

TEST_F(TasksTest, DrillBesideForbidden)
{
  this->Drop(this->Ct);
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  this->Type(Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
  this->Window->findChild<ThresholdDialog*>()->accept();
  this->Choose(this->Nerve);
  this->Type(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  this->Settle();
  this->Begin();
  this->ChooseInCell(0, Column::DrillColumn, 2);
  this->ChooseInCell(1, Column::DrillColumn, 3);
  this->Settle();
  this->Press(Qt::Key_T, Qt::ControlModifier);
  WaitUntil([this]
            { return this->Study->IsTouching() && this->Button("drill-pedal")->isEnabled(); });
  ++this->Actions;
  QTest::keyPress(this->Window->Views(), Qt::Key_D);
  QWidget* canvas = this->Window->Views()->Space()->Canvas();
  const QPointF place = this->PlaceOf(Vector3::Zero());
  Move(canvas, place);
  ++this->Actions;
  SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
  this->FeelUntil([this] { return this->Removed() > 2.0; });
  SendMouse(canvas, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  QTest::keyRelease(this->Window->Views(), Qt::Key_D);
  this->End("Drill beside a forbidden structure", 7);
}

TEST_F(TasksTest, ElasticLesion)
{
  this->OpenPhantom();
  this->Begin();
  this->ClickCell(0, Column::NameColumn);
  QTimer::singleShot(
      0, this->Window.get(),
      [this]
      {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        dialog->findChild<QDoubleSpinBox*>("elements_across")->setValue(4.0); // for a quick test
        this->Actions += 2; // a list is opened, and its entry chosen
        dialog->findChild<QComboBox*>("representation")->setCurrentText("elastic");
        this->Actions += 2;
        dialog->findChild<QComboBox*>("lesion")->setCurrentIndex(2);
        this->ClickButton(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
      });
  this->ClickButton(this->Button("structure-details"));
  this->Settle();
  this->Window->Messages()->Clear(); // on the lesion of one voxel
  this->Press(Qt::Key_T, Qt::ControlModifier);
  this->PushAt(this->SphereCenter);
  EXPECT_EQ(this->Table()->index(0, Column::StiffnessColumn).data().toString(), "yields");
  this->End("Make an organ with a lesion elastic, and touch it", 9);
}

TEST_F(TasksTest, MeasureALine)
{
  this->OpenPhantom();
  this->Begin();
  this->Press(Qt::Key_A);
  ++this->Actions;
  this->Window->findChild<QComboBox*>("next-mark")->setCurrentIndex(1);
  QWidget* slice = this->Window->Views()->Slice(SliceOrientation::Coronal)->Canvas();
  this->Actions += 2;
  Click(slice, {90.0, 70.0});
  Click(slice, {140.0, 90.0});
  ASSERT_EQ(this->Study->State().Measurements.size(), 1U) << this->Messages();
  this->End("Measure a distance", 4);
}

TEST_F(TasksTest, RecordAndReplay)
{
  this->OpenPhantom();
  this->Window->Messages()->Clear(); // on structures that cannot be modelled
  this->Type(Qt::Key_T, Qt::ControlModifier);
  WaitUntil([this] { return this->Study->IsTouching(); });
  this->Begin();
  this->Answer(this->Phantom.Folder / "session.touch");
  this->Press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  WaitUntil([this] { return this->Study->Reading().RecordedTicks > 500; });
  EXPECT_TRUE(this->Action("Stop recording")->iconText().startsWith("REC 0:0"));
  this->Press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  this->Answer(this->Phantom.Folder / "session.touch");
  this->Press(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  WaitUntil([this] { return this->Study->IsReplaying() || !this->Messages().empty(); });
  EXPECT_TRUE(this->Study->IsReplaying()) << this->Messages();
  this->Press(Qt::Key_P);
  this->End("Record a touch and replay it", 6);
}

TEST_F(TasksTest, CohortFromMasks)
{
  const std::filesystem::path folder = this->Phantom.Folder / "masks";
  std::filesystem::create_directories(folder);
  for (const char* name : {"a", "b", "c"})
  {
    std::filesystem::copy(this->MaskFile(), folder / (std::string(name) + ".nii.gz"));
  }
  this->Begin();
  ++this->Actions;
  this->Chosen = QString::fromStdString(folder.string());
  this->ClickButton(this->Window->findChild<QAbstractButton*>("card-cohort"));
  auto* cohort = this->Window->findChild<CohortWindow*>();
  ASSERT_NE(cohort, nullptr);
  WaitUntil([&] { return cohort->findChild<QTableWidget*>()->rowCount() == 3; });
  this->End("Make a cohort of a folder of masks", 2);
}

TEST_F(TasksTest, SaveAnImage)
{
  this->OpenPhantom();
  this->Begin();
  this->Answer(this->Phantom.Folder / "view.png");
  this->Actions += 2; // the menu of a view's header, and its entry
  for (const QMenu* menu : this->Window->findChildren<QMenu*>())
  {
    if (menu->title().startsWith("Sa&ve image"))
    {
      menu->actions().last()->trigger(); // as the header's entry does
    }
  }
  WaitUntil([this] { return std::filesystem::exists(this->Phantom.Folder / "view.png"); });
  this->End("Save an image of a view for print", 3);
}

// Open, select, touch, measure, save.
TEST_F(TasksTest, AllOfItByKeyboard)
{
  const auto tabTo = [this](QWidget* wanted)
  {
    for (int tabs = 0; tabs < 200 && QApplication::focusWidget() != wanted; ++tabs)
    {
      QWidget* focus = QApplication::focusWidget();
      QTest::keyClick(focus != nullptr ? focus : this->Window.get(), Qt::Key_Tab);
    }
    ASSERT_EQ(QApplication::focusWidget(), wanted);
  };
  this->Choose(this->MaskFile());
  this->Type(Qt::Key_O, Qt::ControlModifier);
  WaitUntil([this] { return this->Study->State().Structures.size() == 3; });
  this->Settle();
  DrawAll(*this->Window->Views());
  Activate(*this->Window);
  tabTo(this->Rows());
  QTest::keyClick(this->Rows(), Qt::Key_Down);
  QTest::keyClick(this->Rows(), Qt::Key_Up);
  EXPECT_EQ(this->Rows()->SelectedIds(), std::vector<int>{1});
  this->Window->Messages()->Clear();
  this->Type(Qt::Key_T, Qt::ControlModifier);
  WaitUntil([this] { return this->Study->IsTouching(); });
  QWidget* space = this->Window->Views()->Space()->Canvas();
  space->setFocus(); // Tab belongs to what is in the views
  for (int step = 0; step < 200 && space->cursor().shape() != Qt::PointingHandCursor; ++step)
  {
    QTest::keyClick(space, Qt::Key_Left); // from the view's middle to the sphere
  }
  ASSERT_EQ(space->cursor().shape(), Qt::PointingHandCursor);
  QTest::keyPress(space, Qt::Key_Space);
  this->FeelUntil([this] { return test::Norm(this->Study->Reading().Newest.ForceWorld) > 0.3; });
  QTest::keyClick(space, Qt::Key_A, Qt::ShiftModifier);
  QTest::keyRelease(space, Qt::Key_Space);
  ASSERT_EQ(this->Study->State().Landmarks.size(), 1U) << this->Messages();
  const Vector3& mark = this->Study->State().Landmarks[0].PositionWorld;
  EXPECT_NEAR((mark - this->SphereCenter).norm(), 9.0, 1.0) << "on the sphere, within a voxel";
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "keys.palpate.json").string());
  this->Type(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(std::filesystem::exists(this->SavedTo.toStdString())) << this->Messages();
}
} // namespace
} // namespace palpate::tasks_test
