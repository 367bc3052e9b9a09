#include "CheckGroupFile.h"
#include "CheckPanel.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "MaskChecks.h"
#include "StructuresPanel.h"
#include "TextContrast.h"
#include "WindowLook.h"
#include "WindowTest.h"

#include "vtkCamera.h"

#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

namespace palpate::check_panel_test
{
namespace
{
using Column = StructureTableModel::Column;

const Vector3 Hole(2.0, 0.0, 0.0);

// Three balls: one as it should be, one with a hole, one that the border of the image cuts.
int LabelAt(double x, double y, double z)
{
  const auto isIn = [&](double at, double radius) { return std::hypot(x - at, y, z) < radius; };
  return isIn(-18.0, 7.0)                                           ? 1
         : isIn(0.0, 8.0) && (Vector3(x, y, z) - Hole).norm() > 3.5 ? 2
         : isIn(23.0, 8.0)                                          ? 3
                                                                    : 0;
}

void WriteMasks(const std::filesystem::path& file)
{
  test::LabelGrid grid;
  grid.Size = {{56, 28, 28}}; // to 28 mm
  grid.CenterOnOrigin();
  const auto image = test::MakeLabelImage(grid, [](double, double, double) { return false; });
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double at[3];
    image->GetPoint(i, at);
    *(static_cast<unsigned char*>(image->GetScalarPointer()) + i) =
        static_cast<unsigned char>(LabelAt(at[0], at[1], at[2]));
  }
  WriteImage(file, image);
}

class CheckPanelTest : public test::WindowTest
{
protected:
  std::filesystem::path Masks() const { return this->Phantom.Folder / "masks.nii.gz"; }
  void Open()
  {
    WriteMasks(this->Masks());
    this->Study->OpenSegmentation(this->Masks());
    WaitUntil([this] { return this->Study->State().Structures.size() == 3; });
    this->Settle();
    DrawAll(*this->Window->Views());
  }
  void ShowPanel() const { this->Window->findChild<QDockWidget*>("Check structures")->show(); }
  void Check()
  {
    this->ShowPanel();
    QTest::mouseClick(this->Button("check-start"), Qt::LeftButton);
    this->Finish();
  }
  void Finish()
  {
    WaitUntil([this] { return this->Button("check-start")->text() == "Check structures"; });
    QApplication::processEvents();
  }
  QString Line() const { return this->Window->findChild<QLabel*>("check-line")->text(); }
  StructureTable* Table() const { return this->Window->findChild<StructureTable*>("structures"); }
  QModelIndex StatusOf(int id) const
  {
    const int row = this->Window->findChild<StructureFilterModel*>()->RowOf(id);
    return this->Table()->model()->index(row, Column::StatusColumn);
  }
  QString TextOf(int id) const { return this->StatusOf(id).data().toString(); }
  QString TipOf(int id) const { return this->StatusOf(id).data(Qt::ToolTipRole).toString(); }
  std::vector<int> Order() const { return this->Window->findChild<StructureFilterModel*>()->Ids(); }
  Vector3 Cross() const
  {
    return Vector3(this->Window->Contents().Crosshair()->GetPositionWorld());
  }
  Vector3 Focus() const
  {
    return Vector3(this->Window->Views()->Space()->Renderer()->GetActiveCamera()->GetFocalPoint());
  }
  void ClickStatus(int id)
  {
    StructureTable* table = this->Table();
    table->scrollTo(this->StatusOf(id));
    const QRect cell = table->visualRect(this->StatusOf(id)) & table->viewport()->rect();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
  }
};

TEST_F(CheckPanelTest, TableMarksEachStructure)
{
  this->Open();
  this->Check();
  EXPECT_EQ(this->TextOf(1), QString("\u2713 plausible")) << this->TipOf(1).toStdString();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible")) << this->TipOf(2).toStdString();
  EXPECT_EQ(this->TextOf(3), QString("\u25B2 look here; cut by the scan"))
      << this->TipOf(3).toStdString();
  EXPECT_TRUE(this->TipOf(2).contains("has a hole of 0.")) << this->TipOf(2).toStdString();
  EXPECT_TRUE(this->Line().contains("3 structures of 1 case: 1 plausible, 1 to look at, 1 impl"))
      << this->Line().toStdString();
  EXPECT_TRUE(this->Line().contains("by fixed limits")) << this->Line().toStdString();
}

TEST_F(CheckPanelTest, CutBodiesAreNamedUncheckedWithTheArea)
{
  this->Open();
  EXPECT_EQ(this->TextOf(1), "");
  EXPECT_EQ(this->TextOf(3), "cut by the scan");
  const QRegularExpression area("border of the image: (\\d+) mm");
  const double found = area.match(this->TipOf(3)).captured(1).toDouble();
  // 5 mm from its centre: the radius of the section is 6.2 mm; half a voxel around it.
  EXPECT_NEAR(found, M_PI * (64.0 - 25.0), M_PI * 6.2) << this->TipOf(3).toStdString();
}

TEST_F(CheckPanelTest, ClickOnAMarkShowsThePlaceInAllViews)
{
  this->Open();
  this->Check();
  const Vector3 before = this->Focus();
  this->ClickStatus(2);
  EXPECT_LT((this->Cross() - Hole).norm(), 0.5); // half a voxel
  EXPECT_EQ(this->Window->findChild<StructuresPanel*>()->SelectedIds(), std::vector<int>{2});
  EXPECT_LT((this->Focus() - Hole).norm(), 0.5);
  EXPECT_GT((this->Focus() - before).norm(), 0.01);
  // The mark of a plausible one only selects.
  const Vector3 focus = this->Focus();
  this->ClickStatus(1);
  EXPECT_EQ(this->Window->findChild<StructuresPanel*>()->SelectedIds(), std::vector<int>{1});
  EXPECT_EQ(this->Focus(), focus);
}

TEST_F(CheckPanelTest, ClickOnAMarkShowsAHiddenStructure)
{
  this->Open();
  this->Check();
  StudyState next = this->Study->State();
  next.Structures[1].IsVisible = false;
  this->Study->Change("Hide", next);
  this->ClickStatus(2);
  EXPECT_TRUE(this->Study->State().Structures[1].IsVisible);
  EXPECT_LT((this->Cross() - Hole).norm(), 0.5);
  this->Study->Undo();
  EXPECT_FALSE(this->Study->State().Structures[1].IsVisible);
}

TEST_F(CheckPanelTest, KeyOnAMarkShowsThePlace)
{
  this->Open();
  this->Check();
  Activate(*this->Window);
  this->Table()->setFocus();
  this->Table()->setCurrentIndex(this->StatusOf(1));
  QTest::keyClick(this->Table(), Qt::Key_Down);
  ASSERT_EQ(this->Table()->currentIndex(), this->StatusOf(2));
  this->Window->Contents().Crosshair()->SetPositionWorld(9.0, 9.0, 9.0);
  QTest::keyClick(this->Table(), Qt::Key_Return);
  EXPECT_LT((this->Cross() - Hole).norm(), 0.5);
}

TEST_F(CheckPanelTest, MenuOfTheTableChecks)
{
  this->Open();
  StructureTable* table = this->Table();
  const QPoint place = table->visualRect(table->model()->index(0, Column::NameColumn)).center();
  QContextMenuEvent event(QContextMenuEvent::Mouse, place, table->viewport()->mapToGlobal(place));
  QApplication::sendEvent(table->viewport(), &event);
  auto* menu = this->Window->findChild<StructureMenu*>();
  ASSERT_TRUE(menu->isVisible());
  QTest::keyClick(menu, Qt::Key_K); // its key
  EXPECT_TRUE(this->Button("check-start")->isVisible());
  this->Finish();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible"));
}

TEST_F(CheckPanelTest, MarksAreSortedTheWorstFirst)
{
  this->Open();
  this->Check();
  QHeaderView* header = this->Table()->horizontalHeader();
  const QPoint place(header->sectionViewportPosition(Column::StatusColumn) + 20,
                     header->height() / 2);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, Qt::NoModifier, place);
  EXPECT_EQ(this->Order(), (std::vector<int>{2, 3, 1}));
  QTest::mouseClick(header->viewport(), Qt::LeftButton, Qt::NoModifier, place);
  EXPECT_EQ(this->Order(), (std::vector<int>{1, 3, 2}));
}

TEST_F(CheckPanelTest, MarksGoWhenASegmentationIsAdded)
{
  this->Open();
  this->Check();
  this->Study->AddSegmentation(this->MaskFile());
  WaitUntil([this] { return this->Study->State().Structures.size() == 6; });
  EXPECT_EQ(this->TextOf(1), "");
  EXPECT_EQ(this->TextOf(2), "");
}

TEST_F(CheckPanelTest, MarksGoWhenTheMaskChanges)
{
  this->Open();
  this->Check();
  std::filesystem::copy_file(this->MaskFile(), this->Masks(),
                             std::filesystem::copy_options::overwrite_existing);
  StudyState next = this->Study->State();
  next.Structures[0].Opacity = 0.5; // looks at the files
  this->Study->Change("Look again", next);
  WaitUntil([this] { return this->TextOf(2).isEmpty(); });
  EXPECT_FALSE(this->TextOf(1).contains("plausible"));
}

TEST_F(CheckPanelTest, MarksStayWhenAnythingElseChanges)
{
  this->Open();
  this->Check();
  StudyState next = this->Study->State();
  next.Structures[1].Degree = 5;
  next.Structures[1].IsVisible = false;
  this->Study->Change("Change", next);
  this->Settle();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible"));
  // Sides and groups go by names.
  next.Structures[1].Name = "kidney_left";
  this->Study->Change("Rename", next);
  EXPECT_EQ(this->TextOf(2), "");
  EXPECT_EQ(this->TextOf(1), QString("\u2713 plausible"));
  this->Study->Undo();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible"));
}

TEST_F(CheckPanelTest, CancelLeavesNoMarks)
{
  this->Open();
  this->ShowPanel();
  QTest::mouseClick(this->Button("check-start"), Qt::LeftButton);
  EXPECT_EQ(this->Button("check-start")->text(), "Cancel");
  QTest::mouseClick(this->Button("check-start"), Qt::LeftButton);
  EXPECT_EQ(this->Line(), "Cancelled.");
  WaitUntil([this] { return this->Study->Current().Jobs().IsIdle(); });
  EXPECT_EQ(this->TextOf(2), "");
}

TEST_F(CheckPanelTest, WithoutASegmentationItSaysSo)
{
  this->Window->findChild<CheckPanel*>()->Check();
  EXPECT_TRUE(this->Line().startsWith("No segmentation is open")) << this->Line().toStdString();
}

// Balls of random radii, 20 of them, as clean cases.
void WriteGroup(const std::filesystem::path& folder, const std::filesystem::path& file)
{
  std::filesystem::create_directory(folder);
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 20; ++n)
  {
    const double a = 7.0 + 0.5 * normal(random);
    const double b = 7.5 + 0.5 * normal(random);
    test::LabelGrid grid;
    grid.Size = {{22, 22, 22}};
    grid.CenterOnOrigin();
    WriteImage(folder / (std::to_string(100 + n) + ".nii.gz"),
               test::MakeLabelImage(grid, [a, b](double x, double y, double z)
                                    { return std::hypot(x / a, y / b, z / b) < 1.0; }));
  }
  CheckSettings settings;
  settings.As = "cases";
  std::vector<CheckedCase> patients;
  for (const CaseCheck& one : MaskChecks::Measure({folder}, settings, {}).Cases)
  {
    patients.push_back(one.Patient);
  }
  WriteCheckGroup(CheckGroup::Of(patients, 1), file);
}

TEST_F(CheckPanelTest, GroupAndRateAreUsedAndRemembered)
{
  const std::filesystem::path file = this->Phantom.Folder / "group.json";
  WriteGroup(this->Phantom.Folder / "clean", file);
  this->Open();
  this->ShowPanel();
  this->Opened = QStringList(QString::fromStdString(file.string()));
  QTest::mouseClick(this->Button("check-choose-group"), Qt::LeftButton);
  EXPECT_EQ(this->Window->findChild<QLabel*>("check-group")->text(), "group.json");
  auto* rate = this->Window->findChild<QDoubleSpinBox*>("check-false-alarms");
  EXPECT_EQ(rate->text(), "5.0 %");
  this->Check();
  EXPECT_TRUE(this->Line().contains("against a group, at false alarms in 5.0 % of clean cases"))
      << this->Line().toStdString();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible")) << "by the limits: it is not in it";
  rate->setValue(2.0); // of 20 cases
  this->Check();
  EXPECT_TRUE(this->Line().contains("too few for false alarms in 2.0 %"))
      << this->Line().toStdString();
  const CheckPanel next(*this->Study, this->Window->findChild<StructuresPanel*>()->Verdicts(),
                        AskByDialogs());
  EXPECT_EQ(next.findChild<QLabel*>("check-group")->text(), "group.json");
  EXPECT_EQ(next.findChild<QDoubleSpinBox*>("check-false-alarms")->value(), 2.0);
  QTest::mouseClick(this->Button("check-no-group"), Qt::LeftButton);
  EXPECT_FALSE(rate->isEnabled()) << "it needs a group";
  this->Check();
  EXPECT_TRUE(this->Line().contains("by fixed limits")) << this->Line().toStdString();
}

TEST_F(CheckPanelTest, MalformedGroupIsNamedAndMarksNothing)
{
  const std::filesystem::path file = this->Phantom.Folder / "bad.json";
  std::ofstream(file) << R"({"format": 3})";
  this->Open();
  this->ShowPanel();
  this->Opened = QStringList(QString::fromStdString(file.string()));
  QTest::mouseClick(this->Button("check-choose-group"), Qt::LeftButton);
  this->Check();
  EXPECT_TRUE(this->Line().contains("bad.json")) << this->Line().toStdString();
  EXPECT_EQ(this->TextOf(2), "");
}

TEST_F(CheckPanelTest, RefusedMasksOfAFolderAreNamed)
{
  const std::filesystem::path folder = this->Phantom.Folder / "organs";
  std::filesystem::create_directory(folder);
  test::LabelGrid grid;
  grid.Size = {{56, 28, 28}};
  grid.CenterOnOrigin();
  for (const int label : {1, 2})
  {
    WriteImage(folder / ("organ" + std::to_string(label) + ".nii.gz"),
               test::MakeLabelImage(grid, [label](double x, double y, double z)
                                    { return LabelAt(x, y, z) == label; }));
  }
  std::ofstream(folder / "organ3.nii.gz") << "broken";
  this->Study->OpenSegmentation(folder);
  WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
  this->Settle();
  EXPECT_NE(this->Messages().find("organ3.nii.gz"), std::string::npos);
  this->Check();
  EXPECT_TRUE(this->Line().contains("not checked: ") && this->Line().contains("organ3.nii.gz"))
      << this->Line().toStdString();
  EXPECT_EQ(this->TextOf(2), QString("\u2716 implausible"));
}

// Written where PALPATE_PICTURES says, for people to look at.
TEST_F(CheckPanelTest, VerdictsAreReadAtUsualSizesInBothLooks)
{
  this->Open();
  this->Check();
  StructureTable* table = this->Table();
  for (const WindowLook look : {WindowLook::Light, WindowLook::Dark})
  {
    ChooseLook(look);
    for (const QSize size : {QSize(1280, 800), QSize(1024, 700)})
    {
      this->Window->resize(size);
      QApplication::processEvents();
      EXPECT_EQ(this->Window->size(), size);
      for (const int id : {1, 2, 3})
      {
        const QModelIndex cell = this->StatusOf(id);
        const QRect seen = table->visualRect(cell) & table->viewport()->rect();
        const QString verdict = this->TextOf(id).section(';', 0, 0);
        EXPECT_GE(seen.width(), table->fontMetrics().horizontalAdvance(verdict))
            << verdict.toStdString() << " at " << size.width() << " without scrolling";
        EXPECT_GE(ContrastRatio(cell.data(Qt::ForegroundRole).value<QBrush>().color(),
                                table->palette().color(QPalette::Base)),
                  LeastTextContrast);
      }
      auto* panel = this->Window->findChild<CheckPanel*>();
      for (auto* widget : panel->findChildren<QWidget*>())
      {
        if (widget->isVisible() && !widget->objectName().isEmpty() &&
            widget->objectName().startsWith("check-"))
        {
          EXPECT_GE(widget->width(), widget->minimumSizeHint().width())
              << widget->objectName().toStdString();
          EXPECT_GE(widget->height(), widget->minimumSizeHint().height())
              << widget->objectName().toStdString();
        }
      }
      DrawAll(*this->Window->Views());
      if (const char* folder = std::getenv("PALPATE_PICTURES"))
      {
        const QString name = QString("%1/check-%2-%3.png")
                                 .arg(folder)
                                 .arg(look == WindowLook::Dark ? "dark" : "light")
                                 .arg(size.width());
        EXPECT_TRUE(this->Window->grab().save(name));
      }
    }
  }
  ChooseLook(WindowLook::System);
}
} // namespace
} // namespace palpate::check_panel_test
