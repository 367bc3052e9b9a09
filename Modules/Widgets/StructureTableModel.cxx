#include "StructureTableModel.h"

#include "SceneRepresentation.h"
#include "ScreenString.h"

#include <QColor>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double SlipShare = 0.8; // of the static coefficient, as in the command line

// Writes a cell into a structure, and returns the change's description; empty if the cell cannot be
// written.
QString Write(SceneStructure& structure, int column, const QVariant& value)
{
  switch (column)
  {
  case StructureTableModel::NameColumn:
    structure.Name = value.toString().toStdString();
    return "name " + value.toString();
  case StructureTableModel::ColorColumn:
  {
    const auto color = value.value<QColor>();
    structure.Color = {{color.redF(), color.greenF(), color.blueF()}};
    return "colour";
  }
  case StructureTableModel::AppearanceColumn:
    structure.Appearance = static_cast<SceneAppearance>(value.toInt());
    return QString("shown as ") + NameOf(structure.Appearance);
  case StructureTableModel::RepresentationColumn:
    structure.Representation =
        SceneRepresentations().at(static_cast<std::size_t>(value.toInt())).Name;
    return "representation " + StructureTableModel::RepresentationNames().value(value.toInt());
  case StructureTableModel::DegreeColumn:
    structure.Degree = std::clamp(value.toInt(), 0, 64);
    return "degree " + QString::number(structure.Degree);
  case StructureTableModel::StiffnessColumn:
    structure.Stiffness = std::clamp(value.toDouble(), 0.0, 1e4);
    return QString("stiffness %1 N/mm").arg(structure.Stiffness);
  case StructureTableModel::FrictionColumn:
    structure.Friction.Static = std::clamp(value.toDouble(), 0.0, 10.0);
    structure.Friction.Dynamic = SlipShare * structure.Friction.Static;
    return QString("friction %1").arg(structure.Friction.Static);
  default:
    return {};
  }
}

QString Check(SceneStructure& structure, int column, bool isOn)
{
  if (column == StructureTableModel::VisibleColumn)
  {
    structure.IsVisible = isOn;
    return isOn ? "Show" : "Hide";
  }
  structure.IsTouchable = isOn;
  return isOn ? "Make touchable" : "Make untouchable";
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

StructureTableModel::StructureTableModel(StudyController& study, QObject* parent)
    : QAbstractTableModel(parent), Study(study)
{
  connect(&study, &StudyController::StateChanged, this, &StructureTableModel::TakeState);
  connect(&study, &StudyController::ProductsChanged, this, &StructureTableModel::TakeState);
  this->TakeState();
}

void StructureTableModel::TakeState()
{
  const int rows = static_cast<int>(this->Study.State().Structures.size());
  if (rows != this->Rows)
  {
    this->beginResetModel();
    this->Rows = rows;
    this->endResetModel();
  }
  else if (rows > 0)
  {
    Q_EMIT dataChanged(this->index(0, 0), this->index(rows - 1, ColumnCount - 1));
  }
}

int StructureTableModel::rowCount(const QModelIndex& parent) const
{
  // A change of the study is announced within the same turn of the event loop; until then, the
  // smaller number of rows is valid.
  return parent.isValid()
             ? 0
             : std::min(this->Rows, static_cast<int>(this->Study.State().Structures.size()));
}

int StructureTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant StructureTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  static const QStringList Titles{"Structure",  "Colour",      "Visible",      "Touchable",
                                  "Display as", "Touch model", "Degree",       "N/mm",
                                  "Friction",   "Error, mm",   "Tick, \u00B5s"};
  static const QStringList Tips{
      "Name",
      "Colour",
      "Whether the structure is displayed",
      "Whether the structure can be touched",
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
  return role == Qt::DisplayRole   ? Titles.value(section)
         : role == Qt::ToolTipRole ? QVariant(Tips.value(section))
                                   : QVariant();
}

const SceneStructure& StructureTableModel::StructureAt(const QModelIndex& index) const
{
  return this->Study.State().Structures.at(static_cast<std::size_t>(index.row()));
}

QVariant StructureTableModel::QualityOf(const SceneStructure& structure) const
{
  const auto model =
      this->Study.Current().Pipeline().Newest<FitResult>(SceneStep::Model, structure.Id);
  return model != nullptr && model->State == FitResult::Outcome::Fitted
             ? QString::number(model->ModelToInput().Mean, 'f', 3)
             : QString("\u2013");
}

QVariant StructureTableModel::CostOf(const SceneStructure& structure) const
{
  const auto cost =
      this->Study.Current().Pipeline().Newest<TouchCost>(SceneStep::Cost, structure.Id);
  return cost != nullptr && cost->Ticks > 0
             ? QString::number(1e-3 * cost->MedianNanoseconds, 'f', 2)
             : QString("\u2013");
}

// Includes the replacement if harmonics were refused.
QString StructureTableModel::RepresentationOf(const SceneStructure& structure) const
{
  const QString name = QString::fromStdString(palpate::RepresentationOf(structure).Label);
  const auto contact =
      this->Study.Current().Pipeline().Newest<TouchContact>(SceneStep::Touch, structure.Id);
  const bool isReplaced = structure.Representation == TouchRepresentation::ModelOrField &&
                          contact != nullptr && contact->Field != nullptr;
  return isReplaced ? name + ": sub-voxel" : name;
}

// The stiffness of a structure that yields does not count.
bool StructureTableModel::Yields(const SceneStructure& structure) const
{
  const auto contact =
      this->Study.Current().Pipeline().Newest<TouchContact>(SceneStep::Touch, structure.Id);
  return contact != nullptr && contact->Yields;
}

QVariant StructureTableModel::ValueOf(const SceneStructure& structure, int column) const
{
  switch (column)
  {
  case NameColumn:
    return ScreenString(TitleOf(structure));
  case DegreeColumn:
    return structure.Degree;
  case StiffnessColumn:
    return structure.Stiffness;
  case FrictionColumn:
    return structure.Friction.Static;
  case QualityColumn:
    return this->QualityOf(structure);
  case CostColumn:
    return this->CostOf(structure);
  default:
    return {};
  }
}

QVariant StructureTableModel::data(const QModelIndex& index, int role) const
{
  const SceneStructure& structure = this->StructureAt(index);
  const int column = index.column();
  const bool isChecked = column == VisibleColumn ? structure.IsVisible : structure.IsTouchable;
  switch (role)
  {
  case Qt::DisplayRole:
    return column == AppearanceColumn       ? QString(NameOf(structure.Appearance))
           : column == RepresentationColumn ? this->RepresentationOf(structure)
           : column == StiffnessColumn && this->Yields(structure)
               ? QString("yields")
               : this->ValueOf(structure, column);
  case Qt::EditRole:
    return column == AppearanceColumn ? QVariant(static_cast<int>(structure.Appearance))
           : column == RepresentationColumn
               ? QVariant(RepresentationNames().indexOf(
                     QString::fromStdString(palpate::RepresentationOf(structure).Label)))
               : this->ValueOf(structure, column);
  case Qt::DecorationRole:
  case Qt::UserRole:
    return column == ColorColumn ? QVariant(QColor::fromRgbF(structure.Color[0], structure.Color[1],
                                                             structure.Color[2]))
                                 : QVariant();
  case Qt::CheckStateRole:
    return column == VisibleColumn || column == TouchableColumn
               ? QVariant(isChecked ? Qt::Checked : Qt::Unchecked)
               : QVariant();
  default:
    return {};
  }
}

bool StructureTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  StudyState next = this->Study.State();
  SceneStructure& structure = next.Structures.at(static_cast<std::size_t>(index.row()));
  const QString name = QString::fromStdString(TitleOf(structure));
  QString message;
  if (role == Qt::CheckStateRole)
  {
    message = Check(structure, index.column(), value.toInt() == Qt::Checked) + " " + name;
  }
  else
  {
    const QString change = Write(structure, index.column(), value);
    message = change.isEmpty() ? QString() : QString("Change %1: %2").arg(name, change);
  }
  if (!message.isEmpty())
  {
    this->Study.Change(message, next);
  }
  return !message.isEmpty();
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
  case QualityColumn:
  case CostColumn:
    return flags;
  default:
    return flags | Qt::ItemIsEditable;
  }
}
} // namespace palpate
