// A structure guides the tool: from the menu of the table of structures to a force.
#include "GuideDialog.h"
#include "StructureMenu.h"
#include "WindowTest.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QTimer>

namespace palpate::guide_dialog_test
{
namespace
{
class GuideDialogTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    this->OpenPhantom();
  }
  static void Press(QWidget* widget, int key, const QString& text = {})
  {
    QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier, text);
    QCoreApplication::sendEvent(widget, &down);
  }
  // Types over what a box holds.
  static void Type(QDialog& dialog, const char* name, const QString& text)
  {
    auto* box = dialog.findChild<QDoubleSpinBox*>(name);
    box->setFocus();
    box->selectAll();
    for (const QChar letter : text)
    {
      Press(box, 0, letter);
    }
  }
  int First() const { return this->Study->State().Structures.front().Id; }
};

TEST_F(GuideDialogTest, KeysSetAGuideAsOneUndoStep)
{
  GuideDialog dialog(*this->Study, this->First());
  dialog.show();
  auto* kind = dialog.findChild<QComboBox*>("guide-kind");
  EXPECT_EQ(kind->currentText(), "No guide");
  EXPECT_FALSE(dialog.findChild<QDoubleSpinBox*>("guide-range")->isEnabled());
  Press(kind, Qt::Key_Down);
  Press(kind, Qt::Key_Down);
  EXPECT_EQ(kind->currentText(), "Stay outside");
  Type(dialog, "guide-distance", "2.5");
  Type(dialog, "guide-stiffness", "0.3");
  Type(dialog, "guide-range", "12");
  Type(dialog, "guide-force", "0.8");
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  ASSERT_EQ(this->Study->State().Guides.size(), 1U);
  const GuideSettings guide = this->Study->State().Guides.front();
  EXPECT_EQ(guide.Shape, GuideShape::Outside);
  EXPECT_EQ(guide.Structure, this->First());
  EXPECT_EQ(guide.Distance, 2.5);
  EXPECT_EQ(guide.Stiffness, 0.3);
  EXPECT_EQ(guide.Range, 12.0);
  EXPECT_EQ(guide.LargestForce, 0.8);
  WaitUntil(
      [this]
      {
        const StudyPipeline& pipeline = this->Study->Current().Pipeline();
        return pipeline.StateOf(SceneStep::Guide, this->First()).Is ==
               StudyStepState::Kind::UpToDate;
      });
  this->Study->Undo();
  EXPECT_TRUE(this->Study->State().Guides.empty());
}

TEST_F(GuideDialogTest, ShowsTheGuideOfTheChosenStructureAndRemovesIt)
{
  StudyState next = this->Study->State();
  GuideSettings guide;
  guide.Shape = GuideShape::Surface;
  guide.Structure = this->First();
  guide.Distance = -1.25;
  GuideSettings point;
  point.PointsWorld = {Vector3::Zero()};
  next.Guides = {point, guide};
  this->Study->Change("guide", next);
  GuideDialog dialog(*this->Study, next.Structures.back().Id);
  auto* kind = dialog.findChild<QComboBox*>("guide-kind");
  EXPECT_EQ(kind->currentText(), "No guide");
  dialog.findChild<QComboBox*>("guide-structure")->setCurrentIndex(0);
  EXPECT_EQ(kind->currentText(), "Stay on the surface");
  EXPECT_EQ(dialog.findChild<QDoubleSpinBox*>("guide-distance")->value(), -1.25);
  kind->setCurrentIndex(0);
  dialog.accept();
  EXPECT_EQ(this->Study->State().Guides, std::vector<GuideSettings>{point}) << "others stay";
}

TEST_F(GuideDialogTest, MenuOfTheTableOpensIt)
{
  bool wasOpen = false;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout,
                   [&wasOpen]
                   {
                     if (auto* open = qobject_cast<GuideDialog*>(QApplication::activeModalWidget()))
                     {
                       wasOpen = true;
                       open->reject();
                     }
                   });
  timer.start(20);
  this->Window->findChild<QTableView*>("structures")->selectRow(0);
  this->Window->findChild<StructureMenu*>()->ActionOf(StructureMenu::Guide)->trigger();
  EXPECT_TRUE(wasOpen);
}

TEST_F(GuideDialogTest, LandmarkChoiceLeavesGuidesByStructuresAlone)
{
  StudyState next = this->Study->State();
  GuideSettings guide;
  guide.Shape = GuideShape::Inside;
  guide.Structure = this->First();
  next.Guides = {guide};
  next.Landmarks = {{"F-1", Vector3::Zero()}};
  this->Study->Change("guide", next);
  auto* choice = this->Window->findChild<QComboBox*>("guide");
  EXPECT_EQ(choice->currentIndex(), 0);
  Press(choice, Qt::Key_Down);
  ASSERT_EQ(this->Study->State().Guides.size(), 2U);
  EXPECT_EQ(this->Study->State().Guides.front(), guide);
  Press(choice, Qt::Key_Up);
  EXPECT_EQ(this->Study->State().Guides, std::vector<GuideSettings>{guide});
}

TEST_F(GuideDialogTest, RemovedStructuresTakeTheirGuidesAlong)
{
  StudyState next = this->Study->State();
  GuideSettings guide;
  guide.Shape = GuideShape::Inside;
  guide.Structure = this->First();
  next.Guides = {guide};
  this->Study->Change("guide", next);
  this->Window->findChild<QTableView*>("structures")->selectRow(0);
  this->Window->findChild<StructureMenu*>()->ActionOf(StructureMenu::Remove)->trigger();
  EXPECT_TRUE(this->Study->State().Guides.empty());
  this->Study->Undo();
  EXPECT_EQ(this->Study->State().Guides, std::vector<GuideSettings>{guide});
}
} // namespace
} // namespace palpate::guide_dialog_test
