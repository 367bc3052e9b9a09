#include "TouchMenu.h"

#include "FirstUseDialog.h"
#include "ToolIcon.h"

#include <QSettings>

namespace palpate
{
namespace
{
constexpr const char* RecordingEnding = ".touch";
constexpr const char* SoundKey = "alarm-sound";
constexpr const char* HearingKey = "hear-touches";
constexpr const char* PushKey = "push-along-sight";
constexpr const char* RecordingFilter = "Recorded touches (*.touch *.part)";
} // namespace

TouchMenu::TouchMenu(StudyController& study, const FileQuestions& questions, QWidget* window)
    : QMenu("&Touch", window), Study(study), Questions(questions), Window(window)
{
  this->Touch = this->addAction("", this, &TouchMenu::ToggleTouch, QKeySequence("Ctrl+T"));
  this->Touch->setIcon(ToolIcon(ToolSign::Touch));
  this->Touch->setPriority(QAction::HighPriority);
  // Escape does the first anywhere in the program, so it is not a menu shortcut.
  this->StopForce = this->addAction("Stop all &force (Esc)", this,
                                    [this] { this->Study.Current().Touch().SwitchForcesOff(); });
  this->AllowForce = this->addAction("&Allow force again", this,
                                     [this] { this->Study.Current().Touch().SwitchForcesOn(); });
  this->Sound = this->addAction("&Sound on alarms");
  this->Sound->setCheckable(true);
  this->Sound->setChecked(QSettings().value(SoundKey, false).toBool());
  connect(this->Sound, &QAction::toggled, this,
          [](bool isOn) { QSettings().setValue(SoundKey, isOn); });
  this->addAction("First &use of a device...", this, &TouchMenu::TryDevice);
  this->AddHearing();
  this->AddPush();
  this->AddWorkspace();
  this->AddRecording();
  connect(&study, &StudyController::TouchChanged, this, &TouchMenu::ShowTouch);
  connect(&study, &StudyController::StepsChanged, this, &TouchMenu::ShowTouch);
  connect(&study, &StudyController::StateChanged, this, &TouchMenu::ShowTouch);
  connect(&study, &StudyController::ReplayChanged, this, &TouchMenu::ShowTouch);
  connect(&study, &StudyController::Touched, this, &TouchMenu::ShowRecording);
  this->ShowTouch();
}

void TouchMenu::AddHearing()
{
  this->Hear = this->addAction("&Hear touches");
  this->Hear->setToolTip(
      "A tone for the force, a rustle for texture, a click when a contact begins; from "
      "the next touch on");
  this->Hear->setCheckable(true);
  connect(this->Hear, &QAction::toggled, this,
          [this](bool isOn)
          {
            QSettings().setValue(HearingKey, isOn);
            this->Study.HearTouches(isOn);
          });
  this->Hear->setChecked(QSettings().value(HearingKey, false).toBool());
}

void TouchMenu::AddPush()
{
  this->AlongSight = this->addAction("&Push along the line of sight");
  this->AlongSight->setToolTip("A press of the mouse pushes away from the viewer instead of along "
                               "the surface's normal");
  this->AlongSight->setCheckable(true);
  this->AlongSight->setChecked(QSettings().value(PushKey, false).toBool());
  connect(this->AlongSight, &QAction::toggled, this,
          [](bool isOn) { QSettings().setValue(PushKey, isOn); });
}

void TouchMenu::AddWorkspace()
{
  this->addSeparator();
  QAction* show = this->addAction("Show the &workspace");
  show->setCheckable(true);
  connect(show, &QAction::toggled, this, &TouchMenu::WorkspaceShown);
  this->Move = this->addAction("&Move workspace");
  this->Move->setCheckable(true);
  this->Move->setShortcut(QString("M"));
  this->Move->setToolTip("Drag it in the 3D view; the wheel moves it in depth");
  connect(this->Move, &QAction::toggled, this, &TouchMenu::WorkspaceMoved);
  this->Fit = this->addAction("F&it workspace", &this->Study, &StudyController::FitWorkspace);
  this->Fit->setToolTip("Put all touchable structures in reach");
}

void TouchMenu::AddRecording()
{
  this->addSeparator();
  this->Record =
      this->addAction("", this, &TouchMenu::ToggleRecording, QKeySequence("Ctrl+Shift+R"));
  this->Record->setPriority(QAction::HighPriority); // with its text in the toolbar
  this->addAction("&Open a recording...", this, &TouchMenu::OpenRecording,
                  QKeySequence("Ctrl+Shift+T"));
  this->Play = this->addAction(
      "", this, [this] { this->Study.PlayReplay(!this->Study.Current().Replay()->IsPlaying()); },
      QKeySequence("P"));
  this->Close = this->addAction("&Close the replay", &this->Study, &StudyController::CloseReplay);
  this->addSeparator();
  this->Table = this->addAction("Export every &tick...", this, &TouchMenu::Export);
}

void TouchMenu::ToggleTouch()
{
  if (this->Study.IsTouching() || this->Study.Current().IsOpeningDevice() ||
      this->Study.Current().IsAwaitingDevice())
  {
    this->Study.StopTouch();
  }
  else if (!this->Study.CanTouch() && this->Study.HasValues())
  {
    Q_EMIT ValuesAsked();
  }
  else
  {
    this->Study.StartTouch();
  }
}

void TouchMenu::TryDevice()
{
  auto* dialog = new FirstUseDialog(this->Study, this->Window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void TouchMenu::Serve(TouchPanel& panel)
{
  connect(&panel, &TouchPanel::StartAsked, this, &TouchMenu::ToggleTouch);
  connect(&panel, &TouchPanel::RecordAsked, this, &TouchMenu::ToggleRecording);
  connect(panel.Devices(), &DevicePanel::TrialAsked, this, &TouchMenu::TryDevice);
  panel.AddTools({this->Move, this->Fit});
}

void TouchMenu::ToggleRecording()
{
  if (this->Study.IsRecording())
  {
    this->Study.StopRecording();
    return;
  }
  QString file = this->Questions.ToSave(this->Window, "Record the touch",
                                        QString("session") + RecordingEnding, RecordingFilter);
  if (!file.isEmpty())
  {
    file += file.endsWith(RecordingEnding) ? "" : RecordingEnding;
    this->Study.StartRecording(file.toStdString());
  }
}

void TouchMenu::OpenRecording()
{
  const QStringList files =
      this->Questions.ToOpen(this->Window, "Open a recorded touch", RecordingFilter);
  if (!files.isEmpty())
  {
    this->Study.OpenReplay(files.front().toStdString());
  }
}

void TouchMenu::Export()
{
  const QString file =
      this->Questions.ToSave(this->Window, "Export every tick", "ticks.csv", "Tables (*.csv)");
  if (!file.isEmpty())
  {
    this->Study.ExportReplay(file.toStdString());
  }
}

// "REC 0:07" in the toolbar.
void TouchMenu::ShowRecording()
{
  const bool isRecording = this->Study.IsRecording();
  const auto seconds = static_cast<int>(static_cast<double>(this->Study.Reading().RecordedTicks) /
                                        this->Study.Current().Touch().Rate());
  const QString text =
      isRecording
          ? QString("REC %1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'))
          : QString("Record");
  if (text == this->Record->iconText())
  {
    return;
  }
  this->Record->setText(isRecording ? "Stop &recording" : "&Record...");
  this->Record->setIconText(text);
  this->Record->setIcon(ToolIcon(isRecording ? ToolSign::Recording : ToolSign::Record));
}

void TouchMenu::ShowTouch()
{
  const bool isTouching = this->Study.IsTouching();
  const StudyReplay* replay = this->Study.Current().Replay();
  const bool takesValues = !this->Study.CanTouch() && this->Study.HasValues();
  this->Touch->setText(isTouching || this->Study.Current().IsAwaitingDevice() ? "&Stop touching"
                       : takesValues ? "&Touch image values..."
                                     : "&Start touching");
  this->Touch->setEnabled(isTouching || this->Study.CanTouch() || takesValues ||
                          this->Study.Current().IsOpeningDevice() ||
                          this->Study.Current().IsAwaitingDevice());
  this->Touch->setIconText(isTouching ? "Stop touching" : "Touch");
  this->StopForce->setEnabled(isTouching);
  this->AllowForce->setEnabled(isTouching);
  this->ShowRecording();
  for (QAction* action : {this->Record, this->Move, this->Fit})
  {
    action->setEnabled(isTouching);
  }
  this->Play->setText(replay != nullptr && replay->IsPlaying() ? "&Pause the replay"
                                                               : "&Play the replay");
  for (QAction* action : {this->Play, this->Close, this->Table})
  {
    action->setEnabled(replay != nullptr);
  }
}
} // namespace palpate
