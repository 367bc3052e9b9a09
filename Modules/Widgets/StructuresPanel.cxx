#include "StructuresPanel.h"

#include "ChoiceDelegate.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr double SliderSteps = 100.0;
}

StructuresPanel::StructuresPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Model(new StructureTableModel(study, this)), Table(new QTableView(this))
{
  this->Table->setModel(this->Model);
  this->Table->setObjectName("structures");
  this->Table->setItemDelegateForColumn(
      StructureTableModel::RepresentationColumn,
      new ChoiceDelegate(StructureTableModel::RepresentationNames(), this));
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  connect(this->Table, &QTableView::doubleClicked, this, &StructuresPanel::ChooseColor);
  auto* opacity = new QSlider(Qt::Horizontal, this);
  opacity->setObjectName("opacity");
  opacity->setRange(0, static_cast<int>(SliderSteps));
  opacity->setValue(static_cast<int>(SliderSteps * study.State().View.OverlayOpacity));
  connect(opacity, &QSlider::valueChanged, this,
          [this](int value) { Q_EMIT OpacityChosen(value / SliderSteps); });
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel("Labels over slices", this));
  row->addWidget(opacity, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->addWidget(this->Table, 1);
  column->addLayout(row);
}

void StructuresPanel::ChooseColor(const QModelIndex& index)
{
  if (index.column() != StructureTableModel::ColorColumn)
  {
    return;
  }
  const QColor color =
      QColorDialog::getColor(index.data(Qt::UserRole).value<QColor>(), this, "Colour");
  if (color.isValid())
  {
    this->Model->setData(index, color, Qt::EditRole);
  }
}
} // namespace palpate
