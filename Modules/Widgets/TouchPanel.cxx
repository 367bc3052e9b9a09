#include "TouchPanel.h"

#include "PlainLabel.h"
#include "ScreenString.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
double Norm(const PlainVector3& vector)
{
  return std::hypot(vector.X, vector.Y, vector.Z);
}

QLabel* MakeText(const char* name, QWidget* parent)
{
  QLabel* label = MakePlainLabel(name, parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // What is below does not move when it wraps.
  label->setMinimumHeight(2 * label->fontMetrics().lineSpacing());
  label->setAlignment(Qt::AlignTop);
  return label;
}
} // namespace

TouchPanel::TouchPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Tools(new QHBoxLayout), Device(new DevicePanel(study, this)),
      Radius(new QDoubleSpinBox(this)), Length(new QDoubleSpinBox(this)),
      Shaft(new QDoubleSpinBox(this)), Scale(new QDoubleSpinBox(this)),
      FollowCamera(new QCheckBox(this)), Start(new QPushButton(this)),
      Record(new QPushButton(this)), Recording(MakeText("recording", this)),
      Safety(MakeText("safety", this)), Felt(MakeText("felt", this)),
      Advice(MakeText("advice", this))
{
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  this->MakeSettings(form);
  this->MakeButtons();
  column->addWidget(this->Device);
  column->addLayout(form);
  column->addLayout(this->Tools);
  column->addWidget(this->Start);
  column->addWidget(this->Record);
  column->addWidget(this->Recording);
  column->addWidget(this->Safety);
  column->addWidget(this->Felt);
  column->addWidget(this->Advice);
  connect(&study, &StudyController::StateChanged, this, &TouchPanel::ShowState);
  connect(&study, &StudyController::TouchChanged, this, &TouchPanel::ShowTouch);
  connect(&study, &StudyController::StepsChanged, this, &TouchPanel::ShowTouch);
  connect(&study, &StudyController::ReplayChanged, this, &TouchPanel::ShowTouch);
  connect(&study, &StudyController::Touched, this, &TouchPanel::ShowReading);
  this->ShowState();
}

void TouchPanel::AddTools(const QList<QAction*>& actions)
{
  for (QAction* action : actions)
  {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    this->Tools->addWidget(button);
  }
}

void TouchPanel::MakeButtons()
{
  this->Start->setObjectName("start-touch");
  this->Record->setObjectName("record");
  connect(this->Start, &QPushButton::clicked, this,
          [this]
          {
            Q_EMIT StartAsked();
            this->ShowTouch();
          });
  connect(this->Record, &QPushButton::clicked, this, &TouchPanel::RecordAsked);
}

void TouchPanel::MakeSettings(QFormLayout* form)
{
  this->Radius->setObjectName("tool-radius");
  this->Radius->setRange(0.0, 100.0);
  this->Radius->setSingleStep(0.5);
  this->Radius->setKeyboardTracking(false);
  form->addRow("Tool radius, mm", this->Radius);
  connect(this->Radius, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double radius)
          {
            StudyState next = this->Study.State();
            next.Tool.Radius = radius;
            this->Study.Change(QString("Change the tool's radius to %1 mm").arg(radius), next,
                               "tool radius");
          });
  this->Length->setObjectName("tool-length");
  this->Length->setRange(0.0, 100.0);
  this->Length->setKeyboardTracking(false);
  this->Length->setSpecialValueText("a sphere");
  this->Length->setToolTip(
      "Of a capsule's axis: it lies down, tips, and touches in several places");
  form->addRow("Tool length, mm", this->Length);
  connect(this->Length, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double length) { this->ChangeShape(length, this->Shaft->value()); });
  this->Shaft->setObjectName("tool-shaft");
  this->Shaft->setRange(0.0, 20.0);
  this->Shaft->setSingleStep(0.5);
  this->Shaft->setKeyboardTracking(false);
  this->Shaft->setSpecialValueText("no shaft");
  this->Shaft->setToolTip("Of a drill or a needle: a ball of the tool's radius on a shaft of the "
                          "tool's length, which touches but does not cut");
  form->addRow("Shaft radius, mm", this->Shaft);
  connect(this->Shaft, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double shaft)
          {
            const double length = this->Length->value();
            this->ChangeShape(length > 0.0 ? length : TouchToolSettings().Length, shaft);
          });
  this->Scale->setObjectName("scale");
  this->Scale->setRange(0.0, 100.0);
  this->Scale->setSingleStep(0.1);
  this->Scale->setKeyboardTracking(false);
  this->Scale->setSpecialValueText("all is in reach");
  this->Scale->setToolTip("Scene mm per mm of hand movement");
  form->addRow("Scale", this->Scale);
  connect(this->Scale, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          &TouchPanel::ChangeScale);
  this->FollowCamera->setText("The device's axes follow the camera");
  form->addRow(this->FollowCamera);
  connect(this->FollowCamera, &QCheckBox::clicked, this,
          [this](bool isOn)
          {
            StudyState next = this->Study.State();
            next.Placement.AxesFollowCamera = isOn;
            this->Device->KeepAxes(isOn);
            this->Study.Change(isOn ? "Let the axes follow the camera" : "Fix the axes", next);
          });
}

// Without a length there is no shaft either.
void TouchPanel::ChangeShape(double length, double shaft)
{
  using Shape = TouchToolSettings::Shape;
  const bool isSphere = length <= 0.0;
  StudyState next = this->Study.State();
  next.Tool.Kind = isSphere ? Shape::Sphere : (shaft > 0.0 ? Shape::Drill : Shape::Capsule);
  next.Tool.Length = isSphere ? TouchToolSettings().Length : length;
  next.Tool.ShaftRadius = shaft > 0.0 ? shaft : TouchToolSettings().ShaftRadius;
  const QString kind = shaft > 0.0 ? "drill on a shaft" : "capsule";
  this->Study.Change(isSphere ? QString("Touch with a sphere")
                              : QString("Touch with a %1 of %2 mm").arg(kind).arg(length),
                     next, "tool shape");
}

void TouchPanel::ChangeScale(double scale)
{
  StudyState next = this->Study.State();
  next.Placement.Scale = scale > 0.0 ? std::optional<double>(scale) : std::nullopt;
  this->Device->KeepScale(scale);
  this->Study.Change(scale > 0.0 ? QString("Change the scale to %1").arg(scale)
                                 : QString("Put all structures in reach"),
                     next, "scale");
}

void TouchPanel::ShowState()
{
  const StudyState& state = this->Study.State();
  const QSignalBlocker radius(this->Radius);
  const QSignalBlocker length(this->Length);
  const QSignalBlocker shaft(this->Shaft);
  const QSignalBlocker scale(this->Scale);
  this->Radius->setValue(state.Tool.Radius);
  using Shape = TouchToolSettings::Shape;
  const bool isDrill = state.Tool.Kind == Shape::Drill;
  const bool isLong = isDrill || state.Tool.Kind == Shape::Capsule;
  this->Length->setValue(isLong ? state.Tool.Length : 0.0);
  this->Length->setEnabled(isLong || state.Tool.Kind == Shape::Sphere);
  this->Shaft->setValue(isDrill ? state.Tool.ShaftRadius : 0.0);
  this->Shaft->setEnabled(this->Length->isEnabled());
  this->Scale->setValue(state.Placement.Scale.value_or(0.0));
  this->FollowCamera->setChecked(state.Placement.AxesFollowCamera);
  this->ShowTouch();
}

void TouchPanel::ShowTouch()
{
  const bool isTouching = this->Study.IsTouching();
  const bool isAwaiting = this->Study.Current().IsAwaitingDevice();
  const bool isOpening = this->Study.Current().IsOpeningDevice() || isAwaiting;
  const bool isReplaying = this->Study.IsReplaying();
  this->Start->setText(isTouching    ? "Stop touching"
                       : isAwaiting  ? "Waiting for the device... (stop)"
                       : isOpening   ? "Opening the device... (stop)"
                       : isReplaying ? "Close the replay and touch"
                                     : "Start touching");
  const bool canTouch = this->Study.CanTouch();
  const bool takesValues = !canTouch && this->Study.HasValues();
  this->Start->setText(takesValues && !isTouching && !isOpening ? "Touch image values..."
                                                                : this->Start->text());
  this->Start->setEnabled(isTouching || isOpening || canTouch || takesValues);
  this->Start->setToolTip(this->Start->isEnabled() ? "" : "Make a structure touchable first");
  this->Record->setEnabled(isTouching);
  this->ShowRecording();
  if (!isTouching && !isReplaying)
  {
    this->Safety->setText(isAwaiting ? "No force: the device is lost." : "Touch is off.");
    this->Felt->clear();
    this->Advice->setText(ScreenString(this->Study.Current().DeviceNotice()));
  }
}

void TouchPanel::ShowRecording()
{
  StudyTouch& touch = this->Study.Current().Touch();
  const bool isRecording = this->Study.IsRecording();
  this->Record->setText(isRecording ? "Stop recording" : "Record...");
  const auto nameOf = [](const std::filesystem::path& file)
  { return ScreenString(file.filename().string()); };
  QString text;
  if (const StudyReplay* replay = this->Study.Current().Replay())
  {
    text = "Replays " + nameOf(replay->File()) + ": nothing is felt";
  }
  else if (!touch.RecordingFile().empty() && this->Study.IsTouching())
  {
    const double seconds = static_cast<double>(this->Study.Reading().RecordedTicks) / touch.Rate();
    text = QString("%1 %2: %3 s")
               .arg(isRecording ? "Recording" : "Recorded", nameOf(touch.RecordingFile()))
               .arg(seconds, 0, 'f', 1);
  }
  this->Recording->setText(text);
}

QString TouchPanel::Warnings() const
{
  QStringList lines;
  if (this->Study.IsReplaying())
  {
    return {};
  }
  for (const std::string& warning : this->Study.Current().Touch().Warnings())
  {
    lines += ScreenString(warning);
  }
  const StudyTouchReading& reading = this->Study.Reading();
  for (const std::string& message : {this->Study.Current().DeviceNotice(), reading.Guidance,
                                     reading.DeviceProblem, reading.RecordingProblem})
  {
    if (!message.empty())
    {
      lines += ScreenString(message);
    }
  }
  return lines.join("\n");
}

void TouchPanel::ShowReading()
{
  const StudyTouchReading& reading = this->Study.Reading();
  const QString safety = ScreenString(reading.Safety);
  this->Safety->setText(this->Study.IsReplaying() ? "Then: " + safety : safety);
  this->ShowRecording();
  const QString touched = this->Study.TouchedTitle();
  const QString name = touched.isEmpty() ? "nothing" : touched;
  QString felt = QString("Touches %1: %2 N, %3 mm deep")
                     .arg(name)
                     .arg(Norm(reading.Newest.ForceWorld), 0, 'f', 2)
                     .arg(reading.Newest.Depth, 0, 'f', 2);
  if (reading.Newest.IsBeyondLinear)
  {
    felt += "; beyond linear elasticity, the force is an estimate";
  }
  this->Felt->setText(felt);
  const QString warnings = this->Warnings();
  if (this->Advice->text() != warnings)
  {
    this->Advice->setText(warnings);
  }
}
} // namespace palpate
