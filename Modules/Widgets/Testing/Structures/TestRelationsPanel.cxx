#include "RelationsPanel.h"
#include "WindowTest.h"

#include <QTableWidget>

namespace palpate::relations_panel_test
{
namespace
{
class RelationsPanelTest : public test::WindowTest
{
protected:
  QTableWidget* Table(const char* name) const
  {
    return this->Window->findChild<QTableWidget*>(name);
  }
  QString Line() const { return this->Window->findChild<QLabel*>("relations-line")->text(); }
  // Of the phantom's structures, those that are large enough to be displayed.
  void Measure()
  {
    this->OpenPhantom();
    this->Window->findChild<QDockWidget*>("Relations")->show();
    this->Button("relations-measure")->click();
    WaitUntil([this] { return this->Button("relations-measure")->text() == "Measure"; });
  }
};

TEST_F(RelationsPanelTest, DisplayedStructuresAndTheirPairsAreListed)
{
  this->Measure();
  const int structures = this->Table("relation-shapes")->rowCount();
  EXPECT_GE(structures, 2) << this->Line().toStdString();
  EXPECT_GE(this->Table("relation-pairs")->rowCount(), 1);
  // The first one's radius is 9 mm.
  const auto* name = this->Table("relation-shapes")->item(0, 0);
  EXPECT_EQ(name->text().toStdString(), TitleOf(this->Study->State().Structures[0]));
  const double volume =
      this->Table("relation-shapes")->item(0, 1)->data(Qt::DisplayRole).toDouble();
  EXPECT_NEAR(volume, 4e-3 / 3.0 * M_PI * 729.0, 0.1);
}

TEST_F(RelationsPanelTest, HiddenStructuresAreLeftOut)
{
  this->Measure();
  const int before = this->Table("relation-shapes")->rowCount();
  StudyState next = this->Study->State();
  next.Structures[0].IsVisible = false;
  this->Study->Change("Hide it", next);
  this->Settle();
  this->Button("relations-measure")->click();
  WaitUntil([this] { return this->Button("relations-measure")->text() == "Measure"; });
  EXPECT_EQ(this->Table("relation-shapes")->rowCount(), before - 1);
}

TEST_F(RelationsPanelTest, ADoubleClickShowsWhereAPairIsNearest)
{
  this->Measure();
  QTableWidget* pairs = this->Table("relation-pairs");
  ASSERT_GE(pairs->rowCount(), 1);
  Vector3 chosen = Vector3::Constant(1e6);
  QObject::connect(this->Window->findChild<RelationsPanel*>(), &RelationsPanel::Chosen,
                   [&](const Vector3& place) { chosen = place; });
  Q_EMIT pairs->cellDoubleClicked(0, 0);
  const Vector3 cross(this->Window->Contents().Crosshair()->GetPositionWorld());
  EXPECT_LT((cross - chosen).norm(), 1e-9);
}

TEST_F(RelationsPanelTest, PageIsWrittenIntoTheChosenFolder)
{
  this->Measure();
  const std::filesystem::path folder = this->Phantom.Folder / "related";
  this->Chosen = QString::fromStdString(folder.string());
  this->Button("relations-save")->click();
  WaitUntil([this] { return this->Button("relations-save")->isEnabled(); });
  EXPECT_TRUE(std::filesystem::exists(folder / "report.html")) << this->Line().toStdString();
  EXPECT_TRUE(std::filesystem::exists(folder / "pairs.csv"));
}

TEST_F(RelationsPanelTest, CancelKeepsTheWindowAsItWas)
{
  this->OpenPhantom();
  this->Button("relations-measure")->click();
  this->Button("relations-measure")->click();
  EXPECT_EQ(this->Line(), "Cancelled.");
  WaitUntil([this] { return this->Study->Current().Jobs().IsIdle(); });
  EXPECT_EQ(this->Table("relation-shapes")->rowCount(), 0);
  EXPECT_FALSE(this->Button("relations-save")->isEnabled());
}

TEST_F(RelationsPanelTest, WithoutASurfaceItSaysWhatIsMissing)
{
  this->Button("relations-measure")->click();
  EXPECT_TRUE(this->Line().startsWith("Nothing is displayed")) << this->Line().toStdString();
}
} // namespace
} // namespace palpate::relations_panel_test
