#include "StructuresPanel.h"

#include "ChoiceDelegate.h"
#include "QualityPanel.h"
#include "StructureDialog.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
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
    : QWidget(parent), Study(study), Model(new StructureTableModel(study, this)),
      Table(new QTableView(this)), Opacity(new QSlider(Qt::Horizontal, this))
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
  auto* details = new QPushButton("Details...", this);
  details->setObjectName("structure-details");
  details->setToolTip("All touch settings of the selected structure");
  connect(details, &QPushButton::clicked, this, &StructuresPanel::ShowDetails);
  auto* remove = new QPushButton("Remove", this);
  remove->setObjectName("structure-remove");
  remove->setToolTip("Remove the selected structure from the study");
  connect(remove, &QPushButton::clicked, this, &StructuresPanel::Remove);
  row->addWidget(details);
  row->addWidget(remove);
  row->addWidget(new QLabel("Labels over slices", this));
  row->addWidget(this->Opacity, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->addWidget(new QualityPanel(study, this));
  column->addWidget(this->Table, 1);
  column->addLayout(row);
}

void StructuresPanel::ShowOpacity(double opacity)
{
  const QSignalBlocker quiet(this->Opacity);
  this->Opacity->setValue(static_cast<int>(std::lround(SliderSteps * opacity)));
}

int StructuresPanel::SelectedId() const
{
  const std::vector<SceneStructure>& structures = this->Study.State().Structures;
  const auto row = static_cast<std::size_t>(this->Table->currentIndex().row());
  return row < structures.size() ? structures[row].Id : 0;
}

void StructuresPanel::ShowDetails()
{
  if (const int id = this->SelectedId())
  {
    StructureDialog(this->Study, id, this).exec();
  }
}

void StructuresPanel::Remove()
{
  StudyState next = this->Study.State();
  const SceneStructure* structure = FindStructure(next, this->SelectedId());
  if (structure != nullptr)
  {
    const QString title = QString::fromStdString(TitleOf(*structure));
    next.Structures.erase(next.Structures.begin() + (structure - next.Structures.data()));
    this->Study.Change("Remove " + title, next);
  }
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
