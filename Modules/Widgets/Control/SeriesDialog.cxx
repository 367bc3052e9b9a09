#include "SeriesDialog.h"

#include "ScreenString.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
enum Column
{
  Picture,
  Description,
  Size,
  Orientation,
  Date,
  Folder,
  ColumnCount
};
constexpr int NumberRole = Qt::UserRole;

QTableWidgetItem* TextItem(const QString& text)
{
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(PlainToolTip(text));
  return item;
}

QPixmap PixmapOf(const DicomPreview& preview)
{
  if (preview.Grey.empty())
  {
    return {};
  }
  const QImage shared(preview.Grey.data(), preview.Width, preview.Height, preview.Width,
                      QImage::Format_Grayscale8);
  return QPixmap::fromImage(shared.copy());
}
} // namespace

SeriesDialog::SeriesDialog(const std::vector<DicomSeriesChoice>& series, QWidget* parent)
    : QDialog(parent), Table(new QTableWidget(this))
{
  this->setWindowTitle("Several series");
  this->Table->setObjectName("series");
  this->Table->setAccessibleName("Series of the folder");
  this->Table->setColumnCount(ColumnCount);
  this->Table->setHorizontalHeaderLabels(
      {"Slice", "Description", "Size, voxels", "Orientation", "Date", "Folder"});
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setTabKeyNavigation(false);
  this->Table->setIconSize(QSize(PreviewSide, PreviewSide));
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(PreviewSide + 4);
  for (std::size_t i = 0; i < series.size(); ++i)
  {
    this->AddRow(series[i], static_cast<int>(i));
  }
  this->Table->setSortingEnabled(true);
  this->Table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
  this->Table->resizeColumnsToContents();
  this->Table->horizontalHeader()->setSectionResizeMode(Description, QHeaderView::Stretch);
  this->Table->selectRow(0);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  auto* column = new QVBoxLayout(this);
  column->addWidget(new QLabel("The folder holds several series. Open:", this));
  column->addWidget(this->Table, 1);
  column->addWidget(buttons);
  this->resize(760, 420);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this->Table, &QTableWidget::cellDoubleClicked, this, &QDialog::accept);
}

void SeriesDialog::AddRow(const DicomSeriesChoice& series, int number)
{
  const int row = this->Table->rowCount();
  this->Table->insertRow(row);
  auto* picture = new QTableWidgetItem;
  picture->setData(NumberRole, number);
  picture->setData(Qt::DecorationRole, PixmapOf(series.Preview));
  this->Table->setItem(row, Picture, picture);
  const StackedSlice& plane = series.Slices.Planes.front();
  const QString size = QString("%1 \u00d7 %2 \u00d7 %3")
                           .arg(plane.Columns)
                           .arg(plane.Rows)
                           .arg(series.Slices.Files.size());
  this->Table->setItem(row, Description, TextItem(ScreenString(series.Slices.Description)));
  this->Table->setItem(row, Size, TextItem(size));
  this->Table->setItem(row, Orientation,
                       TextItem(QString::fromStdString(series.Slices.OrientationName())));
  this->Table->setItem(row, Date, TextItem(QString::fromStdString(series.Slices.Date)));
  this->Table->setItem(row, Folder, TextItem(ScreenString(series.Subfolder)));
}

int SeriesDialog::Chosen() const
{
  const int row = this->Table->currentRow();
  return row < 0 ? -1 : this->Table->item(row, Picture)->data(NumberRole).toInt();
}
} // namespace palpate
