#include "DrillPanel.h"

#include "DrillLimits.h"
#include "ImageFormat.h"
#include "ScreenString.h"
#include "SurfaceFile.h"
#include "TextContrast.h"
#include "TouchNotice.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int MostRows = 8; // of the table at once

// A structure's drill role. Wear and feel are plausible, not measured.
struct DrillRole
{
  const char* Name;
  DrillLaw Law;
  bool IsForbidden;
};
const std::array<DrillRole, 4> Roles{{{"Not drilled", {0.0, 0.0, 0.0}, false},
                                      {"Cortical bone", {0.05, 0.002, 0.25}, false},
                                      {"Soft tissue", {0.5, 0.001, 0.05}, false},
                                      {"Forbidden", {0.0, 0.0, 0.0}, true}}};

enum Column
{
  SiteColumn,
  RoleColumn,
  AlarmColumn,
  StandColumn,
  Columns
};

int RoleOf(const SceneStructure& structure)
{
  if (structure.IsForbidden)
  {
    return 3;
  }
  const double wear = structure.Drill.Wear;
  return wear > 0.0 ? (wear > Roles[1].Law.Wear ? 2 : 1) : 0;
}

QDoubleSpinBox* MakeSpin(QWidget* parent, const QString& name, double least, double most,
                         double step, const QString& unit)
{
  auto* spin = new QDoubleSpinBox(parent);
  spin->setObjectName(name);
  spin->setRange(least, most);
  spin->setSingleStep(step);
  spin->setSuffix(unit);
  spin->setKeyboardTracking(false);
  return spin;
}

// Does not repaint if the text is unchanged.
void SetText(QTableWidgetItem* item, const QString& text)
{
  if (item->text() != text)
  {
    item->setText(text);
  }
}
// Distance of the drill to a structure, or the status of its protection.
QString TextOf(const StudyForbidden& forbidden, const StudyDrillReading& reading, bool isTouching)
{
  for (const DrillApproach& one : reading.Approaches)
  {
    if (forbidden.IsReady() && one.Name == forbidden.Name)
    {
      const QString least = QString::number(one.Least, 'f', 1);
      return isTouching
                 ? QString("%1 mm away (minimum %2 mm)").arg(one.Distance, 0, 'f', 1).arg(least)
                 : QString("Minimum %1 mm in the last touch").arg(least);
    }
  }
  return QString::fromStdString(ProtectionText(forbidden));
}
} // namespace

DrillPanel::DrillPanel(StudyController& study, const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Questions(questions), Table(new QTableWidget(this)),
      Alarm(new QLabel(this))
{
  this->Alarm->setTextFormat(Qt::PlainText);
  auto* column = new QVBoxLayout(this);
  auto* burr = new QWidget(this);
  auto* buttons = new QWidget(this);
  this->MakeBurr(burr);
  this->MakeButtons(buttons);
  this->MakeTable();
  this->Alarm->setObjectName("drill-alarm");
  this->Alarm->setWordWrap(true);
  column->addWidget(burr);
  column->addWidget(this->Table, 1);
  column->addWidget(this->Alarm);
  column->addWidget(buttons);
  connect(&study, &StudyController::StateChanged, this, &DrillPanel::ShowState);
  connect(&study, &StudyController::StepsChanged, this, &DrillPanel::ShowReading);
  connect(&study, &StudyController::Touched, this, &DrillPanel::ShowReading);
  connect(&study, &StudyController::TouchChanged, this, &DrillPanel::ShowReading);
  connect(&study, &StudyController::DrilledChanged, this, &DrillPanel::ShowReading);
  this->ShowState();
  this->ShowReading();
}

void DrillPanel::MakeBurr(QWidget* row)
{
  auto* form = new QFormLayout(row);
  form->setContentsMargins(0, 0, 0, 0);
  this->Pedal = new QPushButton("Drill (hold D)", row);
  this->Pedal->setObjectName("drill-pedal");
  this->Pedal->setToolTip("While held, removes touched material that can be drilled. The D key and "
                          "the device's first button do the same.");
  connect(this->Pedal, &QPushButton::pressed, this, [this] { this->Press(true); });
  connect(this->Pedal, &QPushButton::released, this, [this] { this->Press(false); });
  this->Radius = MakeSpin(row, "burr-radius", 0.2, 20.0, 0.1, " mm");
  this->Turns = MakeSpin(row, "burr-turns", 0.0, DrillLimits::Turns, 100.0, " /s");
  this->Turns->setDecimals(0);
  connect(this->Radius, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double radius)
          {
            StudyState next = this->Study.State();
            next.Tool.Radius = radius;
            this->Study.Change("Change the burr's radius", next, "burr");
          });
  connect(this->Turns, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double turns)
          {
            StudyState next = this->Study.State();
            next.Drill.Turns = turns;
            this->Study.Change("Change the drill's speed", next, "turns");
          });
  form->addRow(this->Pedal);
  form->addRow("Burr radius", this->Radius);
  form->addRow("Speed", this->Turns);
}

QPushButton* DrillPanel::AddButton(QWidget* row, const QString& text, const QString& name,
                                   const std::function<void()>& act)
{
  auto* button = new QPushButton(text, row);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, act);
  constexpr int Columns = 3;
  auto* grid = qobject_cast<QGridLayout*>(row->layout());
  grid->addWidget(button, grid->count() / Columns, grid->count() % Columns);
  return button;
}

void DrillPanel::MakeButtons(QWidget* row)
{
  (new QGridLayout(row))->setContentsMargins(0, 0, 0, 0);
  const auto command = [this](DrillCommand wanted)
  { return [this, wanted] { this->Study.Current().Touch().Command(wanted); }; };
  this->Undo = this->AddButton(row, "Undo stroke", "drill-undo", command(DrillCommand::Undo));
  this->Redo = this->AddButton(row, "Redo stroke", "drill-redo", command(DrillCommand::Redo));
  this->AddButton(row, "Reset", "drill-reset", command(DrillCommand::Reset));
  this->AddButton(row, "Save...", "drill-save", [this] { this->Save(); });
  this->AddButton(row, "Open...", "drill-open", [this] { this->Open(); });
  this->AddButton(row, "Export...", "drill-export", [this] { this->Export(); });
}

void DrillPanel::MakeTable()
{
  this->Table->setObjectName("drill-structures");
  this->Table->setColumnCount(Columns);
  this->Table->setHorizontalHeaderLabels({"Structure", "Drill role", "Alarm", "Status"});
  this->Table->verticalHeader()->hide();
  this->Table->horizontalHeader()->setSectionResizeMode(StandColumn, QHeaderView::Stretch);
  this->Table->setTextElideMode(Qt::ElideMiddle); // left and right differ at the end
  this->Table->setMinimumHeight(MostRows * this->Table->verticalHeader()->defaultSectionSize());
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
}

void DrillPanel::ChangeStructure(int label, const QString& message,
                                 const std::function<void(SceneStructure&)>& change)
{
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    if (structure.Id == label)
    {
      change(structure);
    }
  }
  this->Study.Change(message, next);
}

void DrillPanel::MakeRow(int row, const SceneStructure& structure)
{
  const QString title = ScreenString(TitleOf(structure));
  auto* name = new QTableWidgetItem(title);
  name->setData(Qt::UserRole, structure.Id);
  this->Table->setItem(row, SiteColumn, name);
  this->Table->setItem(row, StandColumn, new QTableWidgetItem);
  auto* role = new QComboBox(this->Table);
  for (const DrillRole& one : Roles)
  {
    role->addItem(one.Name);
  }
  auto* alarm = MakeSpin(this->Table, "alarm", 0.0, DrillLimits::Alarm, 0.5, " mm");
  const int label = structure.Id;
  connect(role, qOverload<int>(&QComboBox::activated), this,
          [this, label, title](int chosen)
          {
            const DrillRole& to = Roles.at(static_cast<std::size_t>(chosen));
            this->ChangeStructure(label, "Change the drill role of " + title + " to " + to.Name,
                                  [&to](SceneStructure& one)
                                  {
                                    one.Drill = to.Law;
                                    one.IsForbidden = to.IsForbidden;
                                  });
          });
  connect(alarm, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this, label, title](double distance)
          {
            this->ChangeStructure(label, "Change the alarm distance of " + title,
                                  [distance](SceneStructure& one)
                                  { one.AlarmDistance = distance; });
          });
  this->Table->setCellWidget(row, RoleColumn, role);
  this->Table->setCellWidget(row, AlarmColumn, alarm);
}

void DrillPanel::ShowRow(int row, const SceneStructure& structure)
{
  SetText(this->Table->item(row, SiteColumn), ScreenString(TitleOf(structure)));
  auto* role = qobject_cast<QComboBox*>(this->Table->cellWidget(row, RoleColumn));
  auto* alarm = qobject_cast<QDoubleSpinBox*>(this->Table->cellWidget(row, AlarmColumn));
  const QSignalBlocker quiet(alarm);
  role->setCurrentIndex(RoleOf(structure));
  alarm->setValue(structure.AlarmDistance);
  alarm->setEnabled(structure.IsForbidden);
}

bool DrillPanel::HasRowsOf(const StudyState& state) const
{
  bool hasAll = this->Table->rowCount() == static_cast<int>(state.Structures.size());
  for (int row = 0; hasAll && row < this->Table->rowCount(); ++row)
  {
    hasAll = this->Table->item(row, SiteColumn)->data(Qt::UserRole).toInt() ==
             state.Structures[static_cast<std::size_t>(row)].Id;
  }
  return hasAll;
}

void DrillPanel::ShowState()
{
  const StudyState& state = this->Study.State();
  {
    const QSignalBlocker quietRadius(this->Radius);
    const QSignalBlocker quietTurns(this->Turns);
    this->Radius->setValue(state.Tool.Radius);
    this->Turns->setValue(state.Drill.Turns);
  }
  if (!this->HasRowsOf(state))
  {
    this->Table->setRowCount(0);
    this->Table->setRowCount(static_cast<int>(state.Structures.size()));
    for (int row = 0; row < this->Table->rowCount(); ++row)
    {
      this->MakeRow(row, state.Structures[static_cast<std::size_t>(row)]);
    }
  }
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    this->ShowRow(row, state.Structures[static_cast<std::size_t>(row)]);
  }
  this->ShowReading();
}

void DrillPanel::ShowReading()
{
  const bool isTouching = this->Study.IsTouching();
  const StudyDrillReading& reading =
      isTouching ? this->Study.Reading().Drill : this->Study.Current().Touch().Drill().Last();
  const std::vector<StudyForbidden> forbidden =
      ForbiddenOf(this->Study.State(), this->Study.Current().Pipeline());
  this->Pedal->setEnabled(isTouching && !reading.Drilled.empty() && reading.Hold.empty());
  this->Undo->setEnabled(isTouching && reading.CanUndo);
  this->Redo->setEnabled(isTouching && reading.CanRedo);
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    const QTableWidgetItem* name = this->Table->item(row, SiteColumn);
    const int label = name->data(Qt::UserRole).toInt();
    QString text;
    for (const StudyDrilled& one : reading.Drilled)
    {
      if (one.Id == label)
      {
        text = QString::number(one.RemovedVolume, 'f', 1) + " mm\u00b3 removed";
      }
    }
    for (const StudyForbidden& one : forbidden)
    {
      if (one.Id == label)
      {
        text = TextOf(one, reading, isTouching);
      }
    }
    SetText(this->Table->item(row, StandColumn), text);
    this->Table->item(row, StandColumn)->setToolTip(text);
  }
  this->ShowAlarm(isTouching ? reading : StudyDrillReading(), forbidden);
}

void DrillPanel::ShowAlarm(const StudyDrillReading& reading,
                           const std::vector<StudyForbidden>& forbidden)
{
  QString text = ScreenString(reading.Problem);
  const QString hold = ScreenString(this->HoldText(reading, forbidden));
  text = hold.isEmpty() ? text : hold;
  if (const QString alarm = TouchNotice::AlarmText(reading); !alarm.isEmpty())
  {
    text = hold.isEmpty() ? alarm : alarm + ". " + hold;
  }
  if (text != this->Alarm->text())
  {
    QPalette colors = this->Alarm->palette();
    colors.setColor(QPalette::WindowText,
                    ReadableOn(colors.color(QPalette::Window), QColor("#d32f2f")));
    this->Alarm->setPalette(colors);
    this->Alarm->setText(text);
  }
}

// While touch is off, what would keep the pedal from cutting.
std::string DrillPanel::HoldText(const StudyDrillReading& reading,
                                 std::vector<StudyForbidden> forbidden) const
{
  const auto& structures = this->Study.State().Structures;
  const bool isDrilled = std::any_of(structures.begin(), structures.end(),
                                     [](const SceneStructure& one) { return one.IsDrilled(); });
  if (!reading.Drilled.empty() || !isDrilled)
  {
    return reading.Hold;
  }
  forbidden.erase(std::remove_if(forbidden.begin(), forbidden.end(),
                                 [](const StudyForbidden& one) { return one.IsReady(); }),
                  forbidden.end());
  return DrillHoldText(forbidden);
}

void DrillPanel::Press(bool isDown)
{
  this->Study.Current().Touch().RunDrill(isDown);
}

void DrillPanel::Save()
{
  const std::vector<DrillRecord> records = this->Study.Current().Touch().Drill().Take().Records;
  if (records.empty())
  {
    this->Study.Report("Nothing was drilled: there is no drilling state to save.");
    return;
  }
  const QString file = this->Questions.ToSave(this, "Save the drilling state", "drill.state",
                                              "Drilling states (*.state)");
  if (!file.isEmpty())
  {
    const std::filesystem::path path = file.toStdString();
    this->Study.Write(path, [path, records](const ProgressFunction&)
                      { WriteDrillRecords(path, records); });
  }
}

void DrillPanel::Open()
{
  const QStringList files =
      this->Questions.ToOpen(this, "Open a drilling state", "Drilling states (*.state *.drill)");
  if (!files.isEmpty())
  {
    this->Study.OpenDrilled(files.front().toStdString());
  }
}

void DrillPanel::Export()
{
  const int row = this->Table->currentRow();
  const auto& drilled = this->Study.Reading().Drill.Drilled;
  int label = drilled.empty() ? 0 : drilled.front().Id;
  label = row >= 0 ? this->Table->item(row, SiteColumn)->data(Qt::UserRole).toInt() : label;
  const QString file = this->Questions.ToSave(
      this, "Export the drilled structure", "drilled.stl",
      QString::fromStdString("Surfaces and images (" +
                             PatternsOf(SurfaceFormats().WrittenEndings()) + " " +
                             PatternsOf(ImageFormats().WrittenEndings()) + ")"));
  if (!file.isEmpty())
  {
    const std::filesystem::path path = file.toStdString();
    this->Study.Try(
        [&]
        { this->Study.Write(path, this->Study.Current().Touch().Drill().Exporting(label, path)); });
  }
}
} // namespace palpate
