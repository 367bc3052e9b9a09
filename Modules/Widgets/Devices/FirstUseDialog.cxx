#include "FirstUseDialog.h"

#include "DeviceSettings.h"
#include "PlainLabel.h"
#include "SafetyText.h"
#include "ScreenString.h"

#include <QApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr int PollMilliseconds = 16;

const char* TitleOf(int page)
{
  constexpr std::array<const char*, 4> Titles{
      {"1 of 4: choose the device", "2 of 4: move it", "3 of 4: feel a wall", "4 of 4: stop it"}};
  return Titles.at(static_cast<std::size_t>(page));
}

const char* TextOf(int page)
{
  constexpr std::array<const char*, 4> Texts{
      {"Plug it in, switch it on, and hold its handle loosely.",
       "Move it to both sides, up and down, to you and away, and see the pointer follow. There is "
       "no force.",
       "Push away from you until you feel a soft wall, and hold for a moment. It pushes back "
       "gently; "
       "let go if it does anything else.",
       "Push into the wall again, and while it pushes back, press Esc or hold the clutch button. "
       "What the device is sent is recorded: it must be 0 N within two ticks."}};
  return Texts.at(static_cast<std::size_t>(page));
}

const char* MouseTextOf(int page)
{
  constexpr std::array<const char*, 4> Texts{
      {"", " Mouse: move over the field; the wheel goes to and fro.",
       " Mouse: hold the left button.", " Mouse: hold the left button."}};
  return Texts.at(static_cast<std::size_t>(page));
}
} // namespace

FirstUseDialog::FirstUseDialog(StudyController& study, QWidget* parent)
    : QDialog(parent), Study(study),
      Attempt(study.ServoClock(), this->Folder.path().toStdString(), study.Request()),
      Opener(study.ServoClock(), study.Current().Jobs(),
             [this](auto device, const std::string& problem)
             { this->TakeDevice(std::move(device), problem); }),
      Title(MakePlainLabel("first-use-title", this)), What(MakePlainLabel("first-use-text", this)),
      Choice(new QWidget(this)), Device(new DeviceChoice(this)), Pad(new TrialPad(this)),
      Bars(new QWidget(this)), Result(MakePlainLabel("first-use-result", this)),
      Stop(new QPushButton("Stop force (Esc)", this)),
      Allow(new QPushButton("Allow force again", this)), Next(new QPushButton(this))
{
  this->setWindowTitle("First use of a device");
  this->setObjectName("first-use");
  auto* column = new QVBoxLayout(this);
  QFont bold = this->Title->font();
  bold.setBold(true);
  this->Title->setFont(bold);
  this->What->setWordWrap(true);
  column->addWidget(this->Title);
  column->addWidget(this->What);
  this->MakeChoice(column);
  column->addWidget(this->Pad, 1);
  this->MakeBars(column);
  this->Result->setWordWrap(true);
  this->Result->setMinimumHeight(2 * this->fontMetrics().lineSpacing());
  this->Result->setAlignment(Qt::AlignTop);
  this->Result->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::MinimumExpanding);
  column->addWidget(this->Result);
  this->MakeButtons(column);
  connect(&this->Timer, &QTimer::timeout, this, &FirstUseDialog::Look);
  connect(this->Pad, &TrialPad::Led, this,
          [this](const Vector3& target) { this->Target = target; });
  qApp->installEventFilter(this);
  this->Study.StopTouch();
  this->Device->Choose(study.State().Device);
  this->TurnTo(Page::Choose);
  this->SearchDevice();
  this->Timer.start(PollMilliseconds);
  this->resize(520, 400);
}

FirstUseDialog::~FirstUseDialog()
{
  this->Opener.Cancel();
  if (this->Searching)
  {
    this->Study.Current().Jobs().Cancel(*this->Searching);
  }
}

void FirstUseDialog::MakeChoice(QVBoxLayout* column)
{
  auto* form = new QFormLayout(this->Choice);
  form->setContentsMargins(0, 0, 0, 0);
  this->Device->setObjectName("first-use-device");
  form->addRow("Device", this->Device);
  column->addWidget(this->Choice);
  connect(this->Device, &DeviceChoice::Changed, this, &FirstUseDialog::SearchDevice);
}

void FirstUseDialog::MakeBars(QVBoxLayout* column)
{
  constexpr std::array<const char*, 4> Texts{
      {"left and right", "up and down", "to and fro", "turn"}};
  auto* row = new QHBoxLayout(this->Bars);
  row->setContentsMargins(0, 0, 0, 0);
  for (std::size_t n = 0; n < Texts.size(); ++n)
  {
    this->Names[n] = MakePlainLabel("", this->Bars);
    this->Names[n]->setText(Texts[n]);
    this->Axes[n] = new QProgressBar(this->Bars);
    this->Axes[n]->setRange(0, 100);
    this->Axes[n]->setTextVisible(false);
    auto* one = new QVBoxLayout;
    one->addWidget(this->Names[n]);
    one->addWidget(this->Axes[n]);
    row->addLayout(one);
  }
  column->addWidget(this->Bars);
}

void FirstUseDialog::MakeButtons(QVBoxLayout* column)
{
  auto* row = new QHBoxLayout;
  this->Stop->setObjectName("first-use-stop");
  this->Allow->setObjectName("first-use-allow");
  this->Next->setObjectName("first-use-next");
  auto* close = new QPushButton("Close", this);
  close->setObjectName("first-use-close");
  for (QPushButton* button : {this->Stop, this->Allow, this->Next, close})
  {
    button->setAutoDefault(false);
  }
  row->addWidget(this->Stop);
  row->addWidget(this->Allow);
  row->addStretch(1);
  row->addWidget(close);
  row->addWidget(this->Next);
  column->addLayout(row);
  connect(this->Stop, &QPushButton::clicked, this, [this] { this->Attempt.StopForce(); });
  connect(this->Allow, &QPushButton::clicked, this,
          [this]
          {
            this->Result->clear();
            this->Attempt.AllowForce();
          });
  connect(this->Next, &QPushButton::clicked, this, &FirstUseDialog::GoOn);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

// Escape is the stop under test: it closes nothing.
void FirstUseDialog::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape)
  {
    event->accept();
    return;
  }
  QDialog::keyPressEvent(event);
}

bool FirstUseDialog::eventFilter(QObject*, QEvent* event)
{
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    this->Attempt.StopForce();
  }
  return false;
}

void FirstUseDialog::done(int result)
{
  this->Timer.stop();
  this->Opener.Cancel();
  this->Attempt.End();
  if (result == Accepted)
  {
    this->Study.Change("Choose the device " + this->Device->currentText(),
                       DeviceSettings::WithDevice(this->Study.State(), this->Device->Chosen()));
  }
  QDialog::done(result);
}

// In the background; the device is closed then.
void FirstUseDialog::SearchDevice()
{
  const std::string device = this->Device->Chosen();
  if (this->At != Page::Choose || this->Searching)
  {
    return;
  }
  this->Looked = device;
  const std::string kind = device.substr(0, device.find(':'));
  if (!IsPluggedIn(device))
  {
    this->Tell(kind == "simulated" ? "The mouse is the hand: nothing has to be plugged in." : "");
    return;
  }
  this->Tell("Looking for it...");
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, kind](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, found = ListDevicesOf(kind)]
        {
          this->Searching.reset();
          this->Device->Show(found);
          if (this->At == Page::Choose && !this->Opener.IsOpening())
          {
            this->Tell(found.empty() ? "" : ScreenString(StateLine(found.front())));
          }
          if (this->Looked != this->Device->Chosen())
          {
            this->SearchDevice(); // another was chosen meanwhile
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Searching.reset();
    this->Tell(ScreenString(message));
  };
  this->Searching = this->Study.Current().Jobs().Start(std::move(job));
}

void FirstUseDialog::Tell(const QString& text, bool isGood)
{
  this->Result->setStyleSheet(isGood ? "font-weight: bold" : "");
  this->Result->setText(text);
}

void FirstUseDialog::Begin()
{
  const std::string device = this->Device->Chosen();
  DeviceSettings kept = DeviceSettings::Kept(device);
  kept.IsKnown = true;
  kept.Keep(device);
  this->Tell("Opening the device...");
  this->Opener.Open(device, false);
  this->ShowButtons();
}

void FirstUseDialog::TakeDevice(std::unique_ptr<HapticDevice> device, const std::string& problem)
{
  if (device == nullptr)
  {
    this->Tell(ScreenString(problem));
    this->ShowButtons();
    return;
  }
  const std::string name = this->Device->Chosen();
  const int usual = DeviceSettings::UsualClutch(device->Capabilities());
  const Status status = this->Attempt.Start(
      std::move(device), DeviceSettings::Kept(name).ClutchButton.value_or(usual));
  if (!status.IsOk())
  {
    this->Tell(ScreenString(status.Message()));
    return;
  }
  this->Pad->SetWorkspace(this->Attempt.Capabilities().Workspace);
  const Eigen::AlignedBox3d& workspace = this->Attempt.Capabilities().Workspace;
  this->Led = workspace.isEmpty() ? Vector3(Vector3::Zero()) : Vector3(workspace.center());
  this->Target = this->Led;
  this->TurnTo(Page::Move);
}

void FirstUseDialog::GoOn()
{
  switch (this->At)
  {
  case Page::Choose:
    this->Begin();
    break;
  case Page::Move:
    this->TurnTo(Page::Feel);
    break;
  case Page::Feel:
    this->TurnTo(Page::Stop);
    break;
  case Page::Stop:
    this->accept();
    break;
  }
}

void FirstUseDialog::TurnTo(Page page)
{
  this->At = page;
  this->Title->setText(TitleOf(static_cast<int>(page)));
  const bool isMouse = this->Device->Chosen() == "simulated";
  this->What->setText(QString(TextOf(static_cast<int>(page))) +
                      (isMouse ? MouseTextOf(static_cast<int>(page)) : ""));
  this->Tell("");
  if (page == Page::Feel || page == Page::Stop)
  {
    const Status status =
        this->Attempt.GoTo(page == Page::Feel ? DeviceTrial::Step::Feel : DeviceTrial::Step::Stop);
    this->Tell(ScreenString(status.Message()));
    this->Pad->SetWall(this->Attempt.Wall());
  }
  this->Choice->setVisible(page == Page::Choose);
  this->Pad->setVisible(page != Page::Choose);
  this->Bars->setVisible(page == Page::Move || page == Page::Feel);
  for (std::size_t n = 0; n < this->Axes.size(); ++n)
  {
    const bool isShown = page == Page::Move ? n < 3 || this->Attempt.Turns() : n == 0;
    this->Axes[n]->setVisible(isShown);
    this->Names[n]->setVisible(isShown);
  }
  this->Names[0]->setText(page == Page::Feel ? "held" : "left and right");
  this->ShowButtons();
}

bool FirstUseDialog::MayGoOn() const
{
  switch (this->At)
  {
  case Page::Choose:
    return !this->Opener.IsOpening();
  case Page::Move:
    return this->Attempt.HasMoved();
  case Page::Feel:
    return this->Attempt.Felt() >= 1.0;
  case Page::Stop:
    break;
  }
  return this->Attempt.Proof() && this->Attempt.Proof()->IsPassed();
}

void FirstUseDialog::ShowButtons()
{
  const bool isOn = this->At != Page::Choose;
  this->Stop->setVisible(isOn);
  this->Allow->setVisible(isOn);
  this->Next->setText(this->At == Page::Choose ? "Start"
                      : this->At == Page::Stop ? "Done"
                                               : "Next");
  this->Next->setEnabled(this->MayGoOn());
}

// No faster than a hand.
void FirstUseDialog::LeadHand()
{
  constexpr double Step = 3.0; // mm a look, 0.2 m/s
  const Vector3 way = this->Target - this->Led;
  this->Led += std::min(1.0, Step / std::max(way.norm(), Step)) * way;
  this->Attempt.LeadHand(this->Led);
}

void FirstUseDialog::Look()
{
  if (!this->Attempt.IsRunning())
  {
    return;
  }
  this->LeadHand();
  const TouchState& newest = this->Attempt.Poll().Newest;
  if (newest.State == DeviceState::Error)
  {
    const QString problem = ScreenString(this->Attempt.Device().Problem());
    this->Attempt.End();
    this->Pad->Clear();
    this->TurnTo(Page::Choose);
    this->Tell("No force. " + problem + " Then begin again.");
    return;
  }
  if (newest.HasSample)
  {
    this->Pad->ShowPointer(Vector3(newest.Sample.Position), Vector3(newest.ForceDevice).norm(),
                           this->Attempt.MostForce());
  }
  const bool isTold = newest.Safety.Fault != SafetyFault::None && !this->Attempt.Proof();
  this->Tell(isTold ? "No force. " + ScreenString(SafetyText(newest)) : QString());
  this->ShowProgress();
  this->ShowProof();
  const bool isOff = newest.Safety.Fault != SafetyFault::None;
  this->Stop->setEnabled(!isOff);
  this->Allow->setEnabled(isOff);
  this->ShowButtons();
}

void FirstUseDialog::ShowProgress()
{
  const auto show = [this](std::size_t n, double part)
  { this->Axes[n]->setValue(static_cast<int>(100.0 * part)); };
  if (this->At == Page::Move)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      show(axis, this->Attempt.Moved()[axis]);
    }
    show(3, this->Attempt.Turned());
    const QString guidance = ScreenString(this->Attempt.Device().Guidance());
    const bool isLacking =
        this->Attempt.HasMoved() && this->Attempt.Turns() && this->Attempt.Turned() < 1.0;
    if (!guidance.isEmpty() || isLacking)
    {
      this->Tell(isLacking ? "If its handle turns, turn it, too." : guidance);
    }
  }
  else if (this->At == Page::Feel)
  {
    show(0, this->Attempt.Felt());
  }
}

void FirstUseDialog::ShowProof()
{
  if (this->At != Page::Stop)
  {
    return;
  }
  if (!this->Attempt.Problem().empty())
  {
    this->Tell(ScreenString(this->Attempt.Problem()));
    return;
  }
  if (!this->Attempt.Proof())
  {
    return;
  }
  const StopProof& proof = *this->Attempt.Proof();
  if (!proof.HadForce())
  {
    this->Tell("No force acted when it was stopped, which proves nothing: allow force again, push "
               "into the wall, then press Esc.");
  }
  else if (proof.IsPassed())
  {
    this->Tell(QString("The stop works: %1 N before it, 0 N in tick %2 after it (%3 ms) and in the "
                       "%4 ticks since, by a recording of %5.")
                   .arg(proof.ForceBefore, 0, 'f', 2)
                   .arg(proof.Ticks)
                   .arg(1e-6 * static_cast<double>(proof.Delay), 0, 'f', 1)
                   .arg(proof.TicksAfter)
                   .arg(this->Attempt.RecordedTicks()),
               true);
  }
  else
  {
    this->Tell(QString("The stop FAILED: %1 N before it, and not 0 N within %2 ticks. Do not touch "
                       "with this device; switch it off.")
                   .arg(proof.ForceBefore, 0, 'f', 2)
                   .arg(StopProof::MostTicks),
               true);
  }
}
} // namespace palpate
