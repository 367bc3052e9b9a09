#include "QualityPanel.h"
#include "StructureTableModel.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QTableView>

namespace palpate::quality_panel_test
{
namespace
{
class QualityPanelTest : public test::WindowTest
{
protected:
  // Tick times are measured in real time.
  QualityPanelTest() { this->Time = std::make_unique<SteadyClock>(); }

  QComboBox* Presets() const { return this->Window->findChild<QComboBox*>("quality"); }
  QualityPanel* Panel() const { return this->Window->findChild<QualityPanel*>(); }
  void Choose(int choice)
  {
    this->Presets()->setCurrentIndex(choice);
    Q_EMIT this->Presets()->activated(choice);
  }
};

TEST_F(QualityPanelTest, PresetIsWrittenIntoTheStructures)
{
  this->OpenPhantom();
  this->Choose(1);
  const auto* table = this->Window->findChild<QTableView*>("structures")->model();
  EXPECT_EQ(table->index(0, StructureTableModel::DegreeColumn).data().toInt(), 4);
  EXPECT_EQ(this->Presets()->currentText(), "Harmonics of degree 4");
  this->Action("Undo")->trigger();
  EXPECT_EQ(table->index(0, StructureTableModel::DegreeColumn).data().toInt(), 12);
}

TEST_F(QualityPanelTest, EditedStructureIsSetByHand)
{
  this->OpenPhantom();
  this->Choose(1);
  auto* table = this->Window->findChild<QTableView*>("structures")->model();
  table->setData(table->index(0, StructureTableModel::DegreeColumn), 6);
  EXPECT_EQ(this->Presets()->currentText(), "Set by hand");
}

TEST_F(QualityPanelTest, MeasuresAndAppliesRecommendation)
{
  this->OpenPhantom();
  EXPECT_FALSE(this->Button("quality-recommended")->isEnabled());
  this->Button("quality-measure")->click();
  WaitUntil([this] { return this->Button("quality-recommended")->isEnabled(); });
  WaitUntil([this] { return !this->Study->Current().IsMeasuringQuality(); });
  EXPECT_TRUE(this->Panel()->DetailsText().contains("label 1"));
  this->Button("quality-recommended")->click();
  EXPECT_EQ(this->Study->Current().History().UndoText(), "Use the recommended quality");
}

TEST_F(QualityPanelTest, TicksAreMeasuredWhileTouched)
{
  this->OpenPhantom();
  this->Study->StartTouch();
  WaitUntil([this] { return this->Panel()->NumbersText().contains("measured"); });
  this->Study->StopTouch();
  WaitUntil([this] { return !this->Panel()->NumbersText().contains("measured"); });
}
} // namespace
} // namespace palpate::quality_panel_test
