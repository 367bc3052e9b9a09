#include "SeriesDialog.h"
#include "WidgetTest.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>

namespace palpate::series_dialog_test
{
namespace
{
DicomSeriesChoice Series(const char* description, int columns, const char* date)
{
  DicomSeriesChoice series;
  series.Slices.Description = description;
  series.Slices.Date = date;
  StackedSlice plane;
  plane.Columns = columns;
  plane.Rows = 7;
  plane.RowWorld = Vector3::UnitX();
  plane.ColumnWorld = Vector3::UnitY();
  series.Slices.Planes = {plane, plane, plane};
  series.Slices.Files = {"1.dcm", "2.dcm", "3.dcm"};
  series.Subfolder = "study/CT";
  series.Preview = {2, 1, {0, 255}};
  return series;
}

class SeriesDialogTest : public test::WidgetTest
{
protected:
  const std::vector<DicomSeriesChoice> Two{Series("second of time", 9, "2026-02-01"),
                                           Series("<b>first</b>", 11, "2026-01-01")};
};

TEST_F(SeriesDialogTest, ShowsWhatASeriesIs)
{
  SeriesDialog dialog(this->Two, nullptr);
  const auto* table = dialog.findChild<QTableWidget*>("series");
  ASSERT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->item(0, 1)->text(), "second of time");
  EXPECT_EQ(table->item(0, 2)->text(), QString("9 \u00d7 7 \u00d7 3"));
  EXPECT_EQ(table->item(0, 3)->text(), "axial");
  EXPECT_EQ(table->item(1, 4)->text(), "2026-01-01");
  EXPECT_EQ(table->item(1, 5)->text(), "study/CT");
  const auto picture = table->item(0, 0)->data(Qt::DecorationRole).value<QPixmap>();
  EXPECT_EQ(picture.size(), QSize(2, 1));
  EXPECT_EQ(picture.toImage().pixelColor(1, 0), QColor(Qt::white));
}

TEST_F(SeriesDialogTest, ChosenOneStaysTheSameWhenSorted)
{
  SeriesDialog dialog(this->Two, nullptr);
  dialog.show();
  EXPECT_EQ(dialog.Chosen(), 0);
  auto* table = dialog.findChild<QTableWidget*>("series");
  table->sortByColumn(4, Qt::AscendingOrder);
  EXPECT_EQ(table->item(0, 4)->text(), "2026-01-01");
  EXPECT_EQ(dialog.Chosen(), 0);
  table->setFocus();
  table->selectRow(0);
  EXPECT_EQ(dialog.Chosen(), 1);
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}
} // namespace
} // namespace palpate::series_dialog_test
