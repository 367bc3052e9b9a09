#include "DrillPanel.h"

#include "DrillLimits.h"
#include "ImageFormat.h"
#include "ScreenString.h"
#include "SurfaceFile.h"
#include "TextContrast.h"
#include "TouchNotice.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
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
} // namespace

DrillPanel::DrillPanel(StudyController& study, const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Questions(questions), Alarm(new QLabel(this))
{
  this->Alarm->setTextFormat(Qt::PlainText);
  auto* column = new QVBoxLayout(this);
  auto* burr = new QWidget(this);
  auto* buttons = new QWidget(this);
  this->MakeBurr(burr);
  this->MakeButtons(buttons);
  this->Alarm->setObjectName("drill-alarm");
  this->Alarm->setWordWrap(true);
  column->addWidget(burr);
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

void DrillPanel::ShowState()
{
  const StudyState& state = this->Study.State();
  {
    const QSignalBlocker quietRadius(this->Radius);
    const QSignalBlocker quietTurns(this->Turns);
    this->Radius->setValue(state.Tool.Radius);
    this->Turns->setValue(state.Drill.Turns);
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
  const auto& drilled = this->Study.Current().Touch().Drill().Last().Drilled;
  const bool isChosen =
      std::any_of(drilled.begin(), drilled.end(),
                  [this](const StudyDrilled& one) { return one.Id == this->Chosen; });
  const int label = isChosen || drilled.empty() ? this->Chosen : drilled.front().Id;
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
