#include "LandmarksPanel.h"

#include "GuideSettings.h"
#include "StudyMarkups.h"
#include "ToolIcon.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>
#include <set>

namespace palpate
{
namespace
{
constexpr int MarkNameColumn = 0;

QTableWidgetItem* FixedItem(const QString& text)
{
  auto* item = new QTableWidgetItem(text);
  item->setFlags(item->flags() & ~Qt::ItemIsEditable);
  return item;
}

void FillRow(QTableWidget* table, int row, const std::string& name, const Vector3& place,
             const QString& length)
{
  table->setItem(row, MarkNameColumn, new QTableWidgetItem(QString::fromStdString(name)));
  for (int axis = 0; axis < 3; ++axis)
  {
    table->setItem(row, 1 + axis, FixedItem(QString::number(place[axis], 'f', 2)));
  }
  table->setItem(row, 4, FixedItem(length));
}

bool IsOfPoints(const GuideSettings& guide)
{
  return !guide.HasStructure();
}
} // namespace

LandmarksPanel::LandmarksPanel(StudyController& study, const FileQuestions& questions,
                               QWidget* parent)
    : QWidget(parent), Study(study), Questions(questions), Table(new QTableWidget(0, 5, this)),
      AddMode(new QAction("Add landmarks by click", this))
{
  this->Table->setObjectName("landmarks");
  this->Table->setHorizontalHeaderLabels({"Name", "L, mm", "P, mm", "S, mm", "Length, mm"});
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(this->Table, 1);
  this->MakeButtons();
  connect(this->Table, &QTableWidget::itemChanged, this, &LandmarksPanel::TakeEdit);
  connect(this->Table, &QTableWidget::cellDoubleClicked, this,
          [this](int chosen)
          {
            const auto& marks = this->Study.State().Landmarks;
            const auto place = static_cast<std::size_t>(chosen);
            if (place < marks.size())
            {
              Q_EMIT Chosen(marks[place].PositionWorld);
            }
          });
  connect(&study, &StudyController::StateChanged, this, &LandmarksPanel::ShowState);
  this->ShowState();
}

void LandmarksPanel::MakeButtons()
{
  this->AddMode->setCheckable(true);
  this->AddMode->setShortcut(QString("A"));
  this->AddMode->setIcon(ToolIcon(ToolSign::Landmark));
  auto* mode = new QPushButton("Add by click (A)", this);
  mode->setObjectName("add-landmarks");
  mode->setCheckable(true);
  connect(mode, &QPushButton::toggled, this->AddMode, &QAction::setChecked);
  connect(this->AddMode, &QAction::toggled, mode, &QPushButton::setChecked);
  auto* column = new QVBoxLayout;
  column->addWidget(mode);
  const auto add = [this, column](const QString& text, const char* name, auto act)
  {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    column->addWidget(button);
    connect(button, &QPushButton::clicked, this, act);
  };
  add("Add where touched", "add-touched", &LandmarksPanel::AddAtProxy);
  add("Distance of two", "add-distance", &LandmarksPanel::AddDistance);
  add("Remove", "remove-landmarks", &LandmarksPanel::Remove);
  add("Export...", "export-landmarks", &LandmarksPanel::Export);
  this->MakeGuide(column);
  column->addStretch(1);
  this->layout()->addItem(column);
}

// After the first one, in the order of GuideShape.
void LandmarksPanel::MakeGuide(QVBoxLayout* column)
{
  this->Guide = new QComboBox(this);
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
  column->addWidget(this->Guide);
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

void LandmarksPanel::ShowState()
{
  const QSignalBlocker quiet(this->Table);
  const StudyState& state = this->Study.State();
  const auto guide = std::find_if(state.Guides.begin(), state.Guides.end(), IsOfPoints);
  this->Guide->setCurrentIndex(guide == state.Guides.end() ? 0
                                                           : 1 + static_cast<int>(guide->Shape));
  const int marks = static_cast<int>(state.Landmarks.size());
  this->Table->setRowCount(marks + static_cast<int>(state.Distances.size()));
  for (int m = 0; m < marks; ++m)
  {
    const StudyLandmark& mark = state.Landmarks[static_cast<std::size_t>(m)];
    FillRow(this->Table, m, mark.Name, mark.PositionWorld, {});
  }
  for (int d = marks; d < this->Table->rowCount(); ++d)
  {
    const StudyDistance& distance = state.Distances[static_cast<std::size_t>(d - marks)];
    FillRow(this->Table, d, distance.Name, 0.5 * (distance.FromWorld + distance.ToWorld),
            QString::number(distance.Length(), 'f', 2));
  }
}

void LandmarksPanel::Add(const Vector3& pointWorld)
{
  StudyState next = this->Study.State();
  const std::string name = "F-" + std::to_string(next.Landmarks.size() + 1);
  next.Landmarks.push_back({name, pointWorld});
  this->Study.Change("Add the landmark " + QString::fromStdString(name), next);
}

void LandmarksPanel::AddAtProxy()
{
  if (this->Study.IsTouching())
  {
    const PlainVector3& proxy = this->Study.Reading().Newest.ProxyWorld;
    this->Add({proxy.X, proxy.Y, proxy.Z});
  }
  else
  {
    this->Study.Report("Touch is off: start touching to place landmarks at the tool's contact.");
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
  next.Distances.push_back({from.Name + " to " + to.Name, from.PositionWorld, to.PositionWorld});
  this->Study.Change("Measure " + QString::fromStdString(next.Distances.back().Name), next);
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
      next.Distances.erase(next.Distances.begin() + static_cast<std::ptrdiff_t>(row - marks));
    }
    else
    {
      next.Landmarks.erase(next.Landmarks.begin() + static_cast<std::ptrdiff_t>(row));
    }
  }
  this->Study.Change("Remove landmarks", next);
}

void LandmarksPanel::TakeEdit(QTableWidgetItem* item)
{
  StudyState next = this->Study.State();
  const auto row = static_cast<std::size_t>(item->row());
  const std::size_t marks = next.Landmarks.size();
  std::string& name = row < marks ? next.Landmarks[row].Name : next.Distances.at(row - marks).Name;
  name = item->text().toStdString();
  this->Study.Change("Rename a landmark to " + item->text(), next);
}

void LandmarksPanel::Export()
{
  const QString file = this->Questions.ToSave(this, "Export landmarks", "landmarks.mrk.json",
                                              "3D Slicer markups (*.mrk.json);;Table (*.csv)");
  if (!file.isEmpty())
  {
    const StudyState& state = this->Study.State();
    const std::filesystem::path path = file.toStdString();
    this->Study.Write(path, [path, marks = state.Landmarks, distances = state.Distances](
                                const ProgressFunction&) { WriteMarkups(path, marks, distances); });
  }
}
} // namespace palpate
