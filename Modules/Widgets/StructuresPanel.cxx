#include "StructuresPanel.h"

#include "ChoiceDelegate.h"
#include "DialPanel.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace palpate
{
namespace
{
constexpr double SliderSteps = 100.0;
}

StructuresPanel::StructuresPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Model(new StructureTableModel(study, this)), Table(new QTableView(this)),
      Opacity(new QSlider(Qt::Horizontal, this))
{
  this->Table->setModel(this->Model);
  this->Table->setObjectName("structures");
  this->Table->setItemDelegateForColumn(
      StructureTableModel::AppearanceColumn,
      new ChoiceDelegate(StructureTableModel::AppearanceNames(), this));
  this->Table->setItemDelegateForColumn(
      StructureTableModel::RepresentationColumn,
      new ChoiceDelegate(StructureTableModel::RepresentationNames(), this));
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  connect(this->Table, &QTableView::doubleClicked, this, &StructuresPanel::ChooseColor);
  this->Opacity->setObjectName("opacity");
  this->Opacity->setRange(0, static_cast<int>(SliderSteps));
  this->ShowOpacity(study.State().View.OverlayOpacity);
  connect(&study, &StudyController::StateChanged, this,
          [this, &study] { this->ShowOpacity(study.State().View.OverlayOpacity); });
  connect(this->Opacity, &QSlider::valueChanged, this,
          [this](int value) { Q_EMIT OpacityChosen(value / SliderSteps); });
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel("Labels over slices", this));
  row->addWidget(this->Opacity, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->addWidget(new DialPanel(study, this));
  column->addWidget(this->Table, 1);
  column->addLayout(row);
}

void StructuresPanel::ShowOpacity(double opacity)
{
  const QSignalBlocker quiet(this->Opacity);
  this->Opacity->setValue(static_cast<int>(std::lround(SliderSteps * opacity)));
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
