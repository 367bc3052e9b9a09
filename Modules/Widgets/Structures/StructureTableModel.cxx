#include "StructureTableModel.h"

#include "ContactLimits.h"
#include "DrillLimits.h"
#include "DrillRole.h"
#include "SceneRepresentation.h"
#include "ScreenString.h"
#include "ToolIcon.h"

#include <QColor>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace palpate
{
namespace
{
constexpr double SlipShare = 0.8; // of the static coefficient, as in the command line

QColor ColorOf(const SceneStructure& structure)
{
  return QColor::fromRgbF(structure.Color[0], structure.Color[1], structure.Color[2]);
}

int PercentOf(const SceneStructure& structure)
{
  return static_cast<int>(std::lround(100.0 * structure.Opacity));
}

// A number, or a dash.
QString NumberText(const std::optional<double>& number, int decimals)
{
  return number ? QString::number(*number, 'f', decimals) : QString("\u2013");
}

// A number within its range; `told` says so if the value is outside of it.
double Within(const QVariant& value, double most, const QString& name, QString& told)
{
  const double within = std::clamp(value.toDouble(), 0.0, most);
  if (within != value.toDouble())
  {
    told = QString("%1 %2 is out of range, which is from 0 to %3: %4 is used.")
               .arg(name)
               .arg(value.toDouble())
               .arg(most)
               .arg(within);
  }
  return within;
}

// Writes a cell into a structure, and returns the change's description; empty if the cell cannot be
// written.
QString Write(SceneStructure& structure, int column, const QVariant& value, QString& told)
{
  switch (column)
  {
  case StructureTableModel::DrillColumn:
    DrillRole::Set(structure, value.toInt());
    return "drill role " + DrillRole::Names().value(value.toInt());
  case StructureTableModel::AlarmColumn:
    structure.AlarmDistance = Within(value, DrillLimits::Alarm, "Alarm distance", told);
    return QString("alarm at %1 mm").arg(structure.AlarmDistance);
  case StructureTableModel::AppearanceColumn:
    structure.Appearance = static_cast<SceneAppearance>(value.toInt());
    return QString("shown as ") + NameOf(structure.Appearance);
  case StructureTableModel::RepresentationColumn:
    structure.Representation =
        SceneRepresentations().at(static_cast<std::size_t>(value.toInt())).Name;
    return "representation " + StructureTableModel::RepresentationNames().value(value.toInt());
  case StructureTableModel::DegreeColumn:
    structure.Degree = static_cast<int>(Within(value, 64.0, "Degree", told));
    return "degree " + QString::number(structure.Degree);
  case StructureTableModel::StiffnessColumn:
    structure.Stiffness = Within(value, ContactLimits::Stiffness, "Stiffness", told);
    return QString("stiffness %1 N/mm").arg(structure.Stiffness);
  case StructureTableModel::FrictionColumn:
    structure.Friction.Static = Within(value, ContactLimits::Friction, "Friction", told);
    structure.Friction.Dynamic = SlipShare * structure.Friction.Static;
    return QString("friction %1").arg(structure.Friction.Static);
  case StructureTableModel::NameColumn:
  {
    // An editor that is left as it was must not name a structure after its label.
    const QString name = value.toString().trimmed();
    if (name.isEmpty() || name == ScreenString(TitleOf(structure)))
    {
      return {};
    }
    structure.Name = name.toStdString();
    return "name " + name;
  }
  default:
    return {};
  }
}
} // namespace

QStringList StructureTableModel::AppearanceNames()
{
  QStringList names;
  for (const SceneAppearance appearance : AllSceneAppearances)
  {
    names += NameOf(appearance);
  }
  return names;
}

QStringList StructureTableModel::RepresentationNames()
{
  QStringList names;
  for (const SceneRepresentation& representation : SceneRepresentations())
  {
    names += QString::fromStdString(representation.Label);
  }
  return names;
}

StructureTableModel::StructureTableModel(StudyController& study, const StructureVerdicts& verdicts,
                                         QObject* parent)
    : QAbstractTableModel(parent), Study(study), Verdicts(verdicts), Edits(study)
{
  connect(&study, &StudyController::StateChanged, this, &StructureTableModel::TakeState);
  connect(&study, &StudyController::ProductsChanged, this, &StructureTableModel::TakeState);
  connect(&study, &StudyController::StateChanged, this, &StructureTableModel::TakeDrill);
  connect(&study, &StudyController::StepsChanged, this, &StructureTableModel::TakeDrill);
  connect(&study, &StudyController::Touched, this, &StructureTableModel::TakeDrill);
  connect(&study, &StudyController::TouchChanged, this, &StructureTableModel::TakeDrill);
  connect(&study, &StudyController::DrilledChanged, this, &StructureTableModel::TakeDrill);
  connect(&verdicts, &StructureVerdicts::Changed, this, &StructureTableModel::TakeVerdicts);
  this->TakeState();
}

void StructureTableModel::TakeState()
{
  std::vector<Row> next;
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    next.push_back({structure, this->MadeOf(structure)});
  }
  const bool areSame =
      std::equal(next.begin(), next.end(), this->Rows.begin(), this->Rows.end(),
                 [](const Row& a, const Row& b) { return a.Structure.Id == b.Structure.Id; });
  if (!areSame)
  {
    this->beginResetModel();
    this->Rows = std::move(next);
    this->endResetModel();
    return;
  }
  this->Rows.swap(next);
  this->TellRows(next, 0, ColumnCount - 1,
                 [](const Row& a, const Row& b) { return a.Structure == b.Structure; });
  // Separately, since telling a cell replaces what the user is typing into it.
  this->TellRows(next, RepresentationColumn, RepresentationColumn,
                 [](const Row& a, const Row& b)
                 {
                   return a.Products.Representation == b.Products.Representation &&
                          a.Products.Represented == b.Products.Represented;
                 });
  this->TellRows(next, StiffnessColumn, StiffnessColumn,
                 [](const Row& a, const Row& b) { return a.Products.Yields == b.Products.Yields; });
  this->TellRows(next, StatusColumn, StatusColumn,
                 [](const Row& a, const Row& b) { return a.Products.Cut == b.Products.Cut; });
  this->TellRows(next, QualityColumn, CostColumn,
                 [](const Row& a, const Row& b) {
                   return a.Products.Error == b.Products.Error &&
                          a.Products.Tick == b.Products.Tick;
                 });
}

// What drilling says of each structure.
void StructureTableModel::TakeDrill()
{
  std::map<int, QString> next = DrillTexts(this->Study);
  if (next == this->Drilled) // as nearly always while touching
  {
    return;
  }
  next.swap(this->Drilled);
  for (std::size_t r = 0; r < this->Rows.size(); ++r)
  {
    const int id = this->Rows[r].Structure.Id;
    const auto text = [id](const std::map<int, QString>& all)
    {
      const auto found = all.find(id);
      return found != all.end() ? found->second : QString();
    };
    if (text(next) != text(this->Drilled))
    {
      const QModelIndex cell = this->index(static_cast<int>(r), StatusColumn);
      Q_EMIT dataChanged(cell, cell);
    }
  }
}

void StructureTableModel::TakeVerdicts()
{
  if (!this->Rows.empty())
  {
    Q_EMIT dataChanged(this->index(0, StatusColumn),
                       this->index(static_cast<int>(this->Rows.size()) - 1, StatusColumn));
  }
}

// Tells views of all rows that differ by one signal.
void StructureTableModel::TellRows(
    const std::vector<Row>& before, int firstColumn, int lastColumn,
    const std::function<bool(const Row& before, const Row& now)>& isSame)
{
  int first = -1;
  int last = -1;
  for (std::size_t r = 0; r < before.size(); ++r)
  {
    if (!isSame(before[r], this->Rows[r]))
    {
      first = first < 0 ? static_cast<int>(r) : first;
      last = static_cast<int>(r);
    }
  }
  if (first >= 0)
  {
    Q_EMIT dataChanged(this->index(first, firstColumn), this->index(last, lastColumn));
  }
}

StructureTableModel::Made StructureTableModel::MadeOf(const SceneStructure& structure) const
{
  const StudyPipeline& pipeline = this->Study.Current().Pipeline();
  const auto contact = pipeline.Newest<TouchContact>(SceneStep::Touch, structure.Id);
  const auto model = pipeline.Newest<FitResult>(SceneStep::Model, structure.Id);
  const auto cost = pipeline.Newest<TouchCost>(SceneStep::Cost, structure.Id);
  const auto surface = pipeline.Newest<FitSurface>(SceneStep::Surface, structure.Id);
  Made made;
  made.Representation = QString::fromStdString(palpate::RepresentationOf(structure).Label);
  if (contact != nullptr)
  {
    const bool isReplaced =
        structure.Representation == TouchRepresentation::ModelOrField && contact->Field != nullptr;
    made.Representation += isReplaced ? ": sub-voxel" : "";
    made.Represented = PlainToolTip(ScreenString(contact->Represented));
    made.Yields = contact->Yields;
  }
  if (model != nullptr && model->State == FitResult::Outcome::Fitted)
  {
    made.Error = model->ModelToInput().Mean;
  }
  if (cost != nullptr && cost->Ticks > 0)
  {
    made.Tick = 1e-3 * cost->MedianNanoseconds;
  }
  if (surface != nullptr && surface->Found.TouchesBorder)
  {
    made.Cut = surface->Found.CutArea;
  }
  return made;
}

StructureStatus StructureTableModel::StatusOf(const Row& row) const
{
  const auto drilled = this->Drilled.find(row.Structure.Id);
  return {this->Verdicts.Of(row.Structure), row.Products.Cut,
          drilled != this->Drilled.end() ? drilled->second : QString()};
}

int StructureTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(this->Rows.size());
}

int StructureTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant StructureTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  static const QStringList Titles{"Visible",    "Touchable",   "Colour",       "Opacity",
                                  "Structure",  "Drill role",  "Status",       "Alarm, mm",
                                  "Display as", "Touch model", "Degree",       "N/mm",
                                  "Friction",   "Error, mm",   "Tick, \u00B5s"};
  static const QStringList Tips{
      "Visible: whether the structure is displayed; of a selected row, all selected ones",
      "Touchable: whether the structure can be touched; of a selected row, all selected ones",
      "Colour; double click to change it",
      "In 3-D and over the slices; drag over the cell to change it, double click to type it",
      "Name; F2 to change it",
      "Drill role: what a drill does to it; of a selected row, all selected ones",
      "Whether the mask is believable, once it is checked (a click shows where it is not); whether "
      "the border of the image cuts the structure; what was removed, or how near the drill is to a "
      "forbidden structure",
      "Distance of the drill to a forbidden structure that raises the alarm",
      "Automatic: as the touch model",
      "Automatic: harmonics for models, facets for surfaces, the sub-voxel field for voxels; model "
      "or field: harmonics if they fit, otherwise the field",
      "Degree of the harmonics",
      "Stiffness",
      "Coefficient of static friction",
      "Mean distance of the model from the mask's boundary",
      "Time that touching it adds to a servo tick: measured, median"};
  if (orientation != Qt::Horizontal)
  {
    return {};
  }
  switch (role)
  {
  case Qt::DisplayRole:
    // Narrow columns leave the space to the name.
    return section < OpacityColumn    ? QString()
           : section == OpacityColumn ? QString("%")
                                      : Titles.value(section);
  case Qt::DecorationRole:
    return section == VisibleColumn     ? QVariant(ToolIcon(ToolSign::Eye))
           : section == TouchableColumn ? QVariant(ToolIcon(ToolSign::Touch))
                                        : QVariant();
  case Qt::AccessibleTextRole:
    return Titles.value(section);
  case Qt::TextAlignmentRole: // a wide column, of which the beginning is seen
    return section == StatusColumn ? QVariant(static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter))
                                   : QVariant();
  case Qt::ToolTipRole:
    return Tips.value(section);
  default:
    return {};
  }
}

QVariant StructureTableModel::TextOf(const Row& row, int column) const
{
  switch (column)
  {
  case DrillColumn:
    return DrillRole::Of(row.Structure) != 0
               ? QVariant(DrillRole::Names().value(DrillRole::Of(row.Structure)))
               : QVariant("\u2013");
  case StatusColumn:
    return this->StatusOf(row).Text();
  case AlarmColumn:
    return row.Structure.IsForbidden ? QVariant(row.Structure.AlarmDistance) : QVariant("\u2013");
  case OpacityColumn:
    return QString("%1 %").arg(PercentOf(row.Structure));
  case AppearanceColumn:
    return QString(NameOf(row.Structure.Appearance));
  case RepresentationColumn:
    return row.Products.Representation;
  case StiffnessColumn:
    return row.Products.Yields ? QVariant("yields") : ValueOf(row, column);
  case QualityColumn:
    return NumberText(row.Products.Error, 3);
  case CostColumn:
    return NumberText(row.Products.Tick, 2);
  default:
    return ValueOf(row, column);
  }
}

QVariant StructureTableModel::ValueOf(const Row& row, int column)
{
  const SceneStructure& structure = row.Structure;
  switch (column)
  {
  case OpacityColumn:
    return PercentOf(structure);
  case NameColumn:
    return ScreenString(TitleOf(structure));
  case DrillColumn:
    return DrillRole::Of(structure);
  case AlarmColumn:
    return structure.AlarmDistance;
  case AppearanceColumn:
    return static_cast<int>(structure.Appearance);
  case RepresentationColumn:
    return RepresentationNames().indexOf(
        QString::fromStdString(palpate::RepresentationOf(structure).Label));
  case DegreeColumn:
    return structure.Degree;
  case StiffnessColumn:
    return structure.Stiffness;
  case FrictionColumn:
    return structure.Friction.Static;
  default:
    return {};
  }
}

// What is on comes first, and what is not measured last.
QVariant StructureTableModel::SortValueOf(const Row& row, int column) const
{
  constexpr double Last = std::numeric_limits<double>::infinity();
  switch (column)
  {
  case VisibleColumn:
    return row.Structure.IsVisible ? 0.0 : 1.0;
  case TouchableColumn:
    return row.Structure.IsTouchable ? 0.0 : 1.0;
  case ColorColumn:
    return ColorOf(row.Structure).hueF();
  case DrillColumn:
    return -DrillRole::Of(row.Structure);
  case AlarmColumn:
    return row.Structure.IsForbidden ? row.Structure.AlarmDistance : Last;
  case StatusColumn:
    return this->StatusOf(row).SortText();
  case AppearanceColumn:
  case RepresentationColumn:
    return this->TextOf(row, column);
  case QualityColumn:
    return row.Products.Error.value_or(Last);
  case CostColumn:
    return row.Products.Tick.value_or(Last);
  default:
    return ValueOf(row, column);
  }
}

QVariant StructureTableModel::CheckOf(const Row& row, int column)
{
  if (column != VisibleColumn && column != TouchableColumn)
  {
    return {};
  }
  const bool isOn = column == VisibleColumn ? row.Structure.IsVisible : row.Structure.IsTouchable;
  return isOn ? Qt::Checked : Qt::Unchecked;
}

QVariant StructureTableModel::data(const QModelIndex& index, int role) const
{
  const Row& row = this->Rows.at(static_cast<std::size_t>(index.row()));
  const int column = index.column();
  switch (role)
  {
  case Qt::DisplayRole:
    return TextOf(row, column);
  case Qt::EditRole:
    return ValueOf(row, column);
  case Qt::ToolTipRole:
    return column == NameColumn     ? QVariant(PlainToolTip(this->TextOf(row, column).toString()))
           : column == StatusColumn ? QVariant(PlainToolTip(this->StatusOf(row).ToolTip()))
           : column == RepresentationColumn && !row.Products.Represented.isEmpty()
               ? QVariant(row.Products.Represented)
               : QVariant();
  case Qt::DecorationRole:
  case Qt::UserRole:
    return column == ColorColumn ? QVariant(ColorOf(row.Structure)) : QVariant();
  case Qt::CheckStateRole:
    return CheckOf(row, column);
  case Qt::ForegroundRole:
    return column == StatusColumn ? this->StatusOf(row).Color() : QVariant();
  case SortRole:
    return SortValueOf(row, column);
  case IdRole:
    return row.Structure.Id;
  default:
    return {};
  }
}

bool StructureTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  const int id = index.data(IdRole).toInt();
  const int column = index.column();
  if (role == Qt::CheckStateRole)
  {
    const bool isOn = value.toInt() == Qt::Checked;
    column == VisibleColumn ? this->Edits.SetVisible({id}, isOn)
                            : this->Edits.SetTouchable({id}, isOn);
    return true;
  }
  if (column == ColorColumn)
  {
    this->Edits.SetColor({id}, value.value<QColor>());
    return true;
  }
  if (column == OpacityColumn)
  {
    this->Edits.SetOpacity({id}, value.toInt());
    return true;
  }
  StudyState next = this->Study.State();
  const auto structure = std::find_if(next.Structures.begin(), next.Structures.end(),
                                      [id](const SceneStructure& one) { return one.Id == id; });
  if (structure == next.Structures.end())
  {
    return false;
  }
  const QString title = ScreenString(TitleOf(*structure));
  QString told;
  const QString change = Write(*structure, column, value, told);
  if (!told.isEmpty())
  {
    this->Study.Report(told.toStdString());
  }
  if (!change.isEmpty())
  {
    this->Study.Change("Change " + title + ": " + change, next);
  }
  return !change.isEmpty();
}

Qt::ItemFlags StructureTableModel::flags(const QModelIndex& index) const
{
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  switch (index.column())
  {
  case VisibleColumn:
  case TouchableColumn:
    return flags | Qt::ItemIsUserCheckable;
  case ColorColumn:
  case StatusColumn:
  case QualityColumn:
  case CostColumn:
    return flags;
  case AlarmColumn:
    return this->Rows.at(static_cast<std::size_t>(index.row())).Structure.IsForbidden
               ? flags | Qt::ItemIsEditable
               : flags;
  default:
    return flags | Qt::ItemIsEditable;
  }
}
} // namespace palpate
