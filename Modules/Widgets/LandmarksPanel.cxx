#include "LandmarksPanel.h"

#include "GuideSettings.h"
#include "SidedLength.h"
#include "StudyMarkups.h"
#include "ToolIcon.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace palpate
{
namespace
{
constexpr int MarkNameColumn = 0;
constexpr int FirstPlaceColumn = 4;

QTableWidgetItem* FixedItem(const QString& text)
{
  auto* item = new QTableWidgetItem(text);
  item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  return item;
}

QString LengthNumber(double millimeters, LengthUnit unit)
{
  return QString::number(LengthIn(unit, millimeters), 'f', DecimalsIn(unit, 2));
}

void FillMarkRow(QTableWidget* table, int row, const std::string& name, const QStringList& facts,
                 const Vector3& place, LengthUnit unit)
{
  table->setItem(row, MarkNameColumn, new QTableWidgetItem(QString::fromStdString(name)));
  for (int i = 0; i < facts.size(); ++i)
  {
    table->setItem(row, MarkNameColumn + 1 + i, FixedItem(facts[i]));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    table->setItem(row, FirstPlaceColumn + axis, FixedItem(SidedLength(place, axis, unit, 2)));
  }
}

// Kind, value and unit.
QStringList FactsOf(const StudyMeasurement& measurement, LengthUnit unit)
{
  QString kind = NameOf(measurement.Kind);
  if (measurement.IsOpen)
  {
    const std::size_t wanted = PointCountOf(measurement.Kind);
    const QString count = QString::number(measurement.PointsWorld.size());
    kind += wanted == 0 ? QString(" (open, %1 points)").arg(count)
                        : QString(" (%1 of %2 points)").arg(count).arg(wanted);
  }
  const std::optional<double> value = ValueOf(measurement);
  if (!value)
  {
    return {kind, "", ""};
  }
  const bool isLength = measurement.Kind != MeasurementKind::Angle;
  return {kind, isLength ? LengthNumber(*value, unit) : QString::number(*value, 'f', 2),
          isLength ? SymbolOf(unit) : UnitOf(measurement.Kind)};
}

bool IsOfPoints(const GuideSettings& guide)
{
  return !guide.HasStructure();
}
} // namespace

LandmarksPanel::LandmarksPanel(StudyController& study, ViewContents& contents,
                               const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Questions(questions), Table(new QTableWidget(0, 7, this)),
      Points(new MarkPlacer(study, contents, this)),
      AddMode(new QAction("Add landmarks by click", this)),
      AddTouched(new QAction("Place where touched", this)),
      EndCurve(new QAction("End curve", this)), Next(new QComboBox(this)),
      Guide(new QComboBox(this)), Value(new QLabel(this))
{
  this->Table->setObjectName("landmarks");
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Value->setObjectName("live-value");
  this->Value->setTextFormat(Qt::PlainText);
  this->MakeActions();
  this->MakeChoice();
  this->MakeGuide();
  auto* list = new QVBoxLayout;
  list->addWidget(this->Table, 1);
  list->addWidget(this->Value);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addLayout(list, 1);
  row->addWidget(this->MakeButtons());
  connect(this->Table, &QTableWidget::itemChanged, this, &LandmarksPanel::TakeEdit);
  connect(this->Table, &QTableWidget::cellDoubleClicked, this,
          [this](int chosen) { this->ShowPlaceOf(static_cast<std::size_t>(chosen)); });
  connect(&study, &StudyController::StateChanged, this, &LandmarksPanel::ShowState);
  connect(this->Points, &MarkPlacer::Previewed, this, &LandmarksPanel::ShowPreview);
  this->ShowState();
}

void LandmarksPanel::MakeActions()
{
  this->AddMode->setCheckable(true);
  this->AddMode->setShortcut(QString("A"));
  this->AddMode->setIcon(ToolIcon(ToolSign::Landmark));
  this->AddTouched->setShortcut(QString("Shift+A"));
  connect(this->AddTouched, &QAction::triggered, this->Points, &MarkPlacer::PlaceWhereTouched);
  connect(this->EndCurve, &QAction::triggered, this->Points, &MarkPlacer::End);
}

// After the first one, in the order of MeasurementKind.
void LandmarksPanel::MakeChoice()
{
  this->Next->setObjectName("next-mark");
  this->Next->addItem("Landmark");
  for (int kind = 0; kind < MeasurementKindCount; ++kind)
  {
    this->Next->addItem(NameOf(static_cast<MeasurementKind>(kind)));
  }
  this->Next->setAccessibleName("What is placed next");
  const QString tip =
      "What a click or the tool's contact places: a landmark, or a point of a measurement. Curves "
      "along a surface, distances of structures and thicknesses need structures that are displayed "
      "as surfaces.";
  this->Next->setToolTip(tip);
  this->Next->setStatusTip(tip);
  connect(this->Next, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int chosen) {
            this->Points->Choose(chosen == 0 ? std::nullopt
                                             : std::optional(MeasurementKind(chosen - 1)));
          });
}

QPushButton* LandmarksPanel::MakeButton(const QString& text, const char* name)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  return button;
}

QWidget* LandmarksPanel::MakeButtons()
{
  QPushButton* mode = this->MakeButton("Place by click (A)", "add-landmarks");
  mode->setCheckable(true);
  connect(mode, &QPushButton::toggled, this->AddMode, &QAction::setChecked);
  connect(this->AddMode, &QAction::toggled, mode, &QPushButton::setChecked);
  QPushButton* touched = this->MakeButton("Place where touched", "add-touched");
  connect(touched, &QPushButton::clicked, this->AddTouched, &QAction::trigger);
  QPushButton* end = this->MakeButton("End curve", "end-curve");
  connect(end, &QPushButton::clicked, this->EndCurve, &QAction::trigger);
  connect(this->EndCurve, &QAction::changed, end,
          [this, end] { end->setEnabled(this->EndCurve->isEnabled()); });
  QPushButton* distance = this->MakeButton("Distance of two", "add-distance");
  connect(distance, &QPushButton::clicked, this, &LandmarksPanel::AddDistance);
  QPushButton* remove = this->MakeButton("Remove", "remove-landmarks");
  connect(remove, &QPushButton::clicked, this, &LandmarksPanel::Remove);
  QPushButton* import = this->MakeButton("Import...", "import-landmarks");
  connect(import, &QPushButton::clicked, this, &LandmarksPanel::Import);
  QPushButton* save = this->MakeButton("Export...", "export-landmarks");
  connect(save, &QPushButton::clicked, this, &LandmarksPanel::Export);
  auto* buttons = new QWidget(this);
  auto* grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  int place = 0;
  for (QWidget* one : std::initializer_list<QWidget*>{this->Next, mode, end, touched, distance,
                                                      remove, import, save, this->Guide})
  {
    grid->addWidget(one, place / 2, place % 2);
    ++place;
  }
  grid->setRowStretch(grid->rowCount(), 1);
  return buttons;
}

// After the first one, in the order of GuideShape.
void LandmarksPanel::MakeGuide()
{
  this->Guide->setObjectName("guide");
  this->Guide->addItems(
      {"No guide", "Pull to a landmark", "Pull to the path", "Pull to the plane"});
  this->Guide->setAccessibleName("Guide of the tool");
  const QString tip =
      "While touching, pulls the tool gently to the selected landmarks: to one, to the path "
      "through several in their order, or to the plane of the first three; without a selection, of "
      "all";
  this->Guide->setToolTip(tip);
  this->Guide->setStatusTip(tip);
  connect(this->Guide, QOverload<int>::of(&QComboBox::activated), this,
          &LandmarksPanel::ChangeGuide);
}

void LandmarksPanel::ChangeGuide(int shape)
{
  StudyState next = this->Study.State();
  next.Guides.erase(std::remove_if(next.Guides.begin(), next.Guides.end(), IsOfPoints),
                    next.Guides.end());
  if (shape > 0)
  {
    GuideSettings guide;
    guide.Shape = static_cast<GuideShape>(shape - 1);
    const std::vector<std::size_t> selected = this->SelectedRows();
    for (std::size_t mark = 0; mark < next.Landmarks.size(); ++mark)
    {
      if (selected.empty() || std::count(selected.begin(), selected.end(), mark) > 0)
      {
        guide.PointsWorld.push_back(next.Landmarks[mark].PositionWorld);
      }
    }
    const Status status = CheckGuide(guide);
    if (!status.IsOk())
    {
      this->Study.Report(status.Message());
      this->ShowState();
      return;
    }
    next.Guides.push_back(guide);
  }
  this->Study.Change(shape > 0 ? "Guide the tool" : "Do not guide the tool", next);
}

void LandmarksPanel::SetLengthUnit(LengthUnit unit)
{
  this->Unit = unit;
  this->Points->SetLengthUnit(unit);
  this->ShowState();
}

void LandmarksPanel::ShowState()
{
  const QSignalBlocker quiet(this->Table);
  QStringList heads{"Name", "Kind", "Value", "Unit"};
  for (const char* axis : {"R, L", "A, P", "I, S"})
  {
    heads += QString("%1 (%2)").arg(axis, SymbolOf(this->Unit));
  }
  this->Table->setHorizontalHeaderLabels(heads);
  const StudyState& state = this->Study.State();
  const auto guide = std::find_if(state.Guides.begin(), state.Guides.end(), IsOfPoints);
  this->Guide->setCurrentIndex(guide == state.Guides.end() ? 0
                                                           : 1 + static_cast<int>(guide->Shape));
  this->EndCurve->setEnabled(this->Points->HasOpenCurve());
  const int all = static_cast<int>(state.Landmarks.size() + state.Measurements.size());
  const bool isLonger = all > this->Table->rowCount();
  const bool hasNewMark = static_cast<int>(state.Landmarks.size()) > this->MarkCount;
  this->MarkCount = static_cast<int>(state.Landmarks.size());
  this->Table->setRowCount(all);
  int row = 0;
  for (const StudyLandmark& mark : state.Landmarks)
  {
    FillMarkRow(this->Table, row++, mark.Name, {"Landmark", "", ""}, mark.PositionWorld,
                this->Unit);
  }
  for (const StudyMeasurement& measurement : state.Measurements)
  {
    FillMarkRow(this->Table, row++, measurement.Name, FactsOf(measurement, this->Unit),
                LabelPlaceOf(measurement), this->Unit);
  }
  if (isLonger)
  {
    this->Table->doItemsLayout(); // otherwise it has no place to scroll to yet
    this->Table->scrollToItem(this->Table->item(hasNewMark ? this->MarkCount - 1 : all - 1, 0));
  }
}

void LandmarksPanel::ShowPreview(const QString& text)
{
  this->Value->setText(text);
}

void LandmarksPanel::ShowPlaceOf(std::size_t row)
{
  const StudyState& state = this->Study.State();
  const std::size_t marks = state.Landmarks.size();
  if (row < marks)
  {
    Q_EMIT Chosen(state.Landmarks[row].PositionWorld);
  }
  else if (row < marks + state.Measurements.size())
  {
    Q_EMIT Chosen(LabelPlaceOf(state.Measurements[row - marks]));
  }
}

std::vector<std::size_t> LandmarksPanel::SelectedRows() const
{
  std::set<std::size_t> rows;
  for (const QTableWidgetItem* item : this->Table->selectedItems())
  {
    rows.insert(static_cast<std::size_t>(item->row()));
  }
  return {rows.begin(), rows.end()};
}

void LandmarksPanel::AddDistance()
{
  StudyState next = this->Study.State();
  const std::vector<std::size_t> rows = this->SelectedRows();
  if (rows.size() != 2 || rows.back() >= next.Landmarks.size())
  {
    this->Study.Report("Select two landmarks in the table to measure their distance.");
    return;
  }
  const StudyLandmark& from = next.Landmarks[rows.front()];
  const StudyLandmark& to = next.Landmarks[rows.back()];
  StudyMeasurement line;
  line.Name = from.Name + " to " + to.Name;
  line.PointsWorld = {from.PositionWorld, to.PositionWorld};
  next.Measurements.push_back(line);
  this->Study.Change("Measure " + QString::fromStdString(line.Name), next);
}

void LandmarksPanel::Remove()
{
  StudyState next = this->Study.State();
  std::vector<std::size_t> rows = this->SelectedRows();
  std::reverse(rows.begin(), rows.end());
  const std::size_t marks = next.Landmarks.size();
  for (const std::size_t row : rows)
  {
    if (row >= marks)
    {
      next.Measurements.erase(next.Measurements.begin() + static_cast<std::ptrdiff_t>(row - marks));
    }
    else
    {
      next.Landmarks.erase(next.Landmarks.begin() + static_cast<std::ptrdiff_t>(row));
    }
  }
  this->Study.Change("Remove landmarks and measurements", next);
}

void LandmarksPanel::TakeEdit(QTableWidgetItem* item)
{
  StudyState next = this->Study.State();
  const auto row = static_cast<std::size_t>(item->row());
  const std::size_t marks = next.Landmarks.size();
  std::string& name =
      row < marks ? next.Landmarks[row].Name : next.Measurements.at(row - marks).Name;
  name = item->text().toStdString();
  this->Study.Change("Rename to " + item->text(), next);
}

void LandmarksPanel::Import()
{
  std::vector<std::filesystem::path> files;
  for (const QString& file : this->Questions.ToOpen(this, "Import landmarks and measurements",
                                                    "3D Slicer markups (*.mrk.json)"))
  {
    files.emplace_back(file.toStdString());
  }
  this->Study.OpenFiles(files);
}

void LandmarksPanel::Export()
{
  const QString file =
      this->Questions.ToSave(this, "Export landmarks and measurements", "landmarks.mrk.json",
                             "3D Slicer markups (*.mrk.json);;Table (*.csv)");
  if (!file.isEmpty())
  {
    const std::filesystem::path path = file.toStdString();
    this->Study.Write(path, [path, marks = MarkupsOf(this->Study.State())](const ProgressFunction&)
                      { WriteMarkups(path, marks); });
  }
}
} // namespace palpate
