#include "DialPanel.h"
#include "StructureTableModel.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QSlider>
#include <QTableView>

namespace palpate
{
namespace
{
class DialPanelTest : public test::WindowTest
{
protected:
  // What ticks cost is measured in real time.
  DialPanelTest() { this->Time = std::make_unique<SteadyClock>(); }

  QSlider* Slider() const { return this->Window->findChild<QSlider*>("dial"); }
  QComboBox* Mode() const { return this->Window->findChild<QComboBox*>("dial-mode"); }
  DialPanel* Panel() const { return this->Window->findChild<DialPanel*>(); }
  std::string Represented() const
  {
    const auto contact =
        this->Study->Current().Pipeline().Newest<TouchContact>(StudyStep::Touch, 1);
    return contact != nullptr ? contact->Represented : "nothing";
  }
  void Press(int key)
  {
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(this->Slider(), &press);
  }
  void Choose(int choice)
  {
    this->Mode()->setCurrentIndex(choice);
    Q_EMIT this->Mode()->activated(choice);
  }
};

TEST_F(DialPanelTest, TheSliderDecidesWhatIsFeltAndSaysWhatItCosts)
{
  this->OpenPhantom();
  EXPECT_EQ(this->Mode()->currentText(), "Each structure by hand");
  this->Press(Qt::Key_Right);
  EXPECT_EQ(this->Study->State().Dial, StudyDial::Harmonics16);
  EXPECT_EQ(this->Mode()->currentText(), "The dial for all structures");
  this->Press(Qt::Key_Home);
  EXPECT_EQ(this->Study->State().Dial, StudyDial::Harmonics4);
  WaitUntil([this] { return this->Represented() == "harmonics of degree 4, nearest point"; });
  WaitUntil([this] { return this->Panel()->NumbersWords().contains("mm expected"); });
  EXPECT_TRUE(this->Panel()->SettingsWords().contains("label 1: harmonics of degree 4"))
      << this->Panel()->SettingsWords().toStdString();
  // The table says the same, and one undo takes both turns back.
  const auto* table = this->Window->findChild<QTableView*>("structures")->model();
  EXPECT_EQ(table->index(0, StructureTableModel::DegreeColumn).data().toInt(), 4);
  EXPECT_EQ(table->index(0, StructureTableModel::RepresentationColumn).data(), "harmonics");
  EXPECT_EQ(table->index(1, StructureTableModel::RepresentationColumn).data(), "sub-voxel, linear");
  this->Action("Undo")->trigger();
  EXPECT_EQ(this->Study->State().Dial, StudyDial::ByHand);
  EXPECT_EQ(table->index(0, StructureTableModel::DegreeColumn).data().toInt(), 12);
}

TEST_F(DialPanelTest, AutomaticIsChosenByName)
{
  this->OpenPhantom();
  this->Choose(1);
  EXPECT_EQ(this->Study->State().Dial, StudyDial::Automatic);
  WaitUntil([this] { return this->Panel()->NumbersWords().contains("mm expected"); });
  this->Choose(0);
  EXPECT_EQ(this->Study->State().Dial, StudyDial::ByHand);
}

TEST_F(DialPanelTest, ADegreeByHandTurnsTheDialToByHand)
{
  this->OpenPhantom();
  this->Press(Qt::Key_Home);
  auto* table = this->Window->findChild<QTableView*>("structures")->model();
  table->setData(table->index(0, StructureTableModel::DegreeColumn), 6);
  EXPECT_EQ(this->Study->State().Dial, StudyDial::ByHand);
  EXPECT_EQ(this->Mode()->currentText(), "Each structure by hand");
}

TEST_F(DialPanelTest, WhileSomethingIsTouchedItsTicksAreMeasured)
{
  this->OpenPhantom();
  this->Study->StartTouch();
  WaitUntil([this] { return this->Panel()->NumbersWords().contains("measured"); });
  this->Study->StopTouch();
  WaitUntil([this] { return !this->Panel()->NumbersWords().contains("measured"); });
}
} // namespace
} // namespace palpate
