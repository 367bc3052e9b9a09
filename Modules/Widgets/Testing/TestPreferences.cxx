#include "Preferences.h"

#include "PreferencesDialog.h"
#include "WindowTest.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QSpinBox>
#include <QTableWidget>

namespace palpate::preferences_test
{
namespace
{
class PreferencesTest : public test::WindowTest
{
protected:
  void TearDown() override
  {
    WindowTest::TearDown();
    QApplication::setPalette(PaletteOf(WindowLook::System));
  }
  PreferencesDialog* OpenDialog()
  {
    this->Action("Preferences")->trigger();
    QApplication::processEvents();
    return this->Window->findChild<PreferencesDialog*>();
  }
  // By keyboard.
  static void Choose(const PreferencesDialog* dialog, const char* name, int choice)
  {
    auto* box = dialog->findChild<QComboBox*>(name);
    while (box->currentIndex() != choice)
    {
      QKeyEvent key(QEvent::KeyPress, box->currentIndex() < choice ? Qt::Key_Down : Qt::Key_Up,
                    Qt::NoModifier);
      QApplication::sendEvent(box, &key);
    }
  }
  static void Restore(const PreferencesDialog* dialog)
  {
    QPushButton* button =
        dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults);
    Click(button, button->rect().center());
  }
  QColor Ground() const { return GroundOf(*this->Window); }
  static QColor GroundOf(const MainWindow& window)
  {
    QApplication::processEvents(); // Qt 6 tells widgets of the palette by an event
    return window.palette().color(QPalette::Window);
  }
  SlicePane* Slice(SliceOrientation orientation) const
  {
    return this->Window->Views()->Slice(orientation);
  }
};

TEST_F(PreferencesTest, ThemeAppliesAtOnceAndAtTheNextStart)
{
  const QColor system = this->Ground();
  const PreferencesDialog* dialog = this->OpenDialog();
  Choose(dialog, "preferred-look", 2);
  const QColor dark = this->Ground();
  EXPECT_LT(dark.lightness(), 128);
  EXPECT_FALSE(this->Study->Current().History().IsChanged());
  QApplication::setPalette(QPalette());
  const MainWindow next(*this->Study);
  EXPECT_EQ(GroundOf(next), dark);
  Restore(dialog);
  EXPECT_EQ(this->Ground(), system);
}

TEST_F(PreferencesTest, LengthsAreInThePreferredUnitEverywhere)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Landmarks = {{"F-1", Vector3(12.5, 0.0, -3.0)}};
  StudyMeasurement line;
  line.Name = "Line 1";
  line.PointsWorld = {Vector3::Zero(), Vector3(0.0, 12.3, 0.0)};
  next.Measurements = {line};
  this->Study->Change("Measure", next);
  const auto* table = this->Window->findChild<QTableWidget*>("landmarks");
  EXPECT_EQ(table->horizontalHeaderItem(4)->text(), "R, L (mm)");
  EXPECT_EQ(table->item(0, 4)->text(), "L 12.50");
  Choose(this->OpenDialog(), "preferred-unit", 1);
  EXPECT_EQ(table->horizontalHeaderItem(4)->text(), "R, L (cm)");
  EXPECT_EQ(table->item(0, 4)->text(), "L 1.250");
  EXPECT_EQ(table->item(1, 2)->text(), "1.230");
  EXPECT_EQ(table->item(1, 3)->text(), "cm");
  auto* status = this->Window->findChild<StatusLine*>();
  status->ShowPoint(Vector3(-10.3, 0.0, 4.0), "");
  EXPECT_EQ(status->PointText(), "R 1.03  P 0.00  S 0.40 cm");
  EXPECT_TRUE(this->Slice(SliceOrientation::Axial)->View()->GetCentimeters());
  EXPECT_TRUE(this->Window->Views()->Space()->View()->GetCentimeters());
  const MainWindow reopened(*this->Study);
  EXPECT_EQ(reopened.findChild<QTableWidget*>("landmarks")->item(1, 2)->text(), "1.230");
  EXPECT_EQ(*ValueOf(this->Study->State().Measurements[0]), 12.3);
}

TEST_F(PreferencesTest, LeftDragIsAsPreferred)
{
  this->OpenPhantom();
  Choose(this->OpenDialog(), "preferred-left-drag", 1);
  EXPECT_TRUE(this->Action("Adjust window")->isChecked());
  QWidget* canvas = this->Slice(SliceOrientation::Axial)->Canvas();
  const double before = this->Window->Contents().Images()->GetWindow();
  SendMouse(canvas, QEvent::MouseButtonPress, {60.0, 60.0}, Qt::LeftButton, Qt::LeftButton);
  SendMouse(canvas, QEvent::MouseMove, {90.0, 60.0}, Qt::NoButton, Qt::LeftButton);
  SendMouse(canvas, QEvent::MouseButtonRelease, {90.0, 60.0}, Qt::LeftButton, Qt::NoButton);
  EXPECT_GT(this->Window->Contents().Images()->GetWindow(), before);
  const MainWindow next(*this->Study);
  const QList<QAction*> actions = next.findChild<ViewMenu*>()->actions();
  EXPECT_TRUE(std::any_of(actions.begin(), actions.end(),
                          [](const QAction* action)
                          { return action->text().contains("left drag") && action->isChecked(); }));
}

TEST_F(PreferencesTest, OtherPreferencesLeaveTheLeftDragAsItIs)
{
  this->Action("Adjust window")->trigger();
  Choose(this->OpenDialog(), "preferred-convention", 1);
  EXPECT_TRUE(this->Action("Adjust window")->isChecked());
}

TEST_F(PreferencesTest, NeurologicalConventionIsThatOfAllSlices)
{
  this->OpenPhantom();
  SlicePane* axial = this->Slice(SliceOrientation::Axial);
  const auto placeUnder = [&](double x)
  {
    Move(axial->Canvas(), {x, 60.0});
    return this->Window->PointText();
  };
  EXPECT_TRUE(placeUnder(10.0).startsWith("R")) << "radiological";
  Choose(this->OpenDialog(), "preferred-convention", 1);
  DrawAll(*this->Window->Views());
  EXPECT_TRUE(placeUnder(10.0).startsWith("L"));
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    EXPECT_TRUE(this->Slice(orientation)->View()->GetNeurological());
  }
  const MainWindow next(*this->Study);
  EXPECT_TRUE(next.Views()->Slice(SliceOrientation::Coronal)->View()->GetNeurological());
}

TEST_F(PreferencesTest, NewStudiesBeginAsPreferredAndOpenOnesStay)
{
  const PreferencesDialog* dialog = this->OpenDialog();
  dialog->findChild<QSpinBox*>("preferred-degree")->setValue(8);
  Choose(dialog, "preferred-error-scale", 3);
  EXPECT_EQ(this->Study->State().Fit.Degree, 8) << "nothing was done in it";
  EXPECT_EQ(this->Study->State().View.ErrorScale, 2.0);
  EXPECT_FALSE(this->Window->isWindowModified());
  this->OpenPhantom();
  EXPECT_EQ(this->Study->State().Structures.front().Degree, 8);
  dialog->findChild<QSpinBox*>("preferred-degree")->setValue(5);
  EXPECT_EQ(this->Study->State().Fit.Degree, 8);
  this->Study->New();
  EXPECT_EQ(this->Study->State().Fit.Degree, 5);
  EXPECT_EQ(this->Study->State().View.ErrorScale, 2.0);
  StudyController later(*this->Time);
  const MainWindow next(later);
  EXPECT_EQ(later.State().Fit.Degree, 5);
  later.Close();
}

TEST_F(PreferencesTest, DefaultsAreRestored)
{
  const PreferencesDialog* dialog = this->OpenDialog();
  for (const char* name :
       {"preferred-look", "preferred-left-drag", "preferred-convention", "preferred-error-scale"})
  {
    Choose(dialog, name, 1);
  }
  dialog->findChild<QSpinBox*>("preferred-degree")->setValue(3);
  EXPECT_EQ(Preferences::Kept().Degree, 3);
  EXPECT_TRUE(Preferences::Kept().IsNeurological);
  Restore(dialog);
  const Preferences kept = Preferences::Kept();
  EXPECT_EQ(kept.Look, WindowLook::System);
  EXPECT_FALSE(kept.LeftDragAdjustsWindow);
  EXPECT_FALSE(kept.IsNeurological);
  EXPECT_EQ(kept.Degree, 12);
  EXPECT_FALSE(kept.ErrorScale);
  EXPECT_EQ(this->Study->State(), StudyState());
  EXPECT_FALSE(this->Action("Adjust window")->isChecked());
}

TEST_F(PreferencesTest, NonsenseThatWasKeptIsIgnored)
{
  QSettings().setValue("degree", 900);
  QSettings().setValue("error-scale", "nan");
  QSettings().setValue("look", "purple");
  const Preferences kept = Preferences::Kept();
  EXPECT_EQ(kept.Degree, 12);
  EXPECT_FALSE(kept.ErrorScale);
  EXPECT_EQ(kept.Look, WindowLook::System);
}

TEST_F(PreferencesTest, DialogFitsASmallScreenUnclipped)
{
  const PreferencesDialog* dialog = this->OpenDialog();
  EXPECT_LE(dialog->width(), 900);
  EXPECT_LE(dialog->height(), 600);
  for (auto* box : dialog->findChildren<QComboBox*>())
  {
    EXPECT_GE(box->width(), box->minimumSizeHint().width()) << box->objectName().toStdString();
  }
}
} // namespace
} // namespace palpate::preferences_test
