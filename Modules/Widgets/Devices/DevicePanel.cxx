#include "DevicePanel.h"

#include "DeviceSettings.h"
#include "PlainLabel.h"
#include "ScreenString.h"

#include <QApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int WatchMilliseconds = 2000;
constexpr int FewestButtons = 2; // the first is the drill's pedal

std::string KindOf(const std::string& device)
{
  return device.substr(0, device.find(':'));
}

void ShowRow(QFormLayout* form, QWidget* field, bool isShown)
{
  field->setVisible(isShown);
  if (QWidget* label = form->labelForField(field))
  {
    label->setVisible(isShown);
  }
}
} // namespace

DevicePanel::DevicePanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Device(new DeviceChoice(this)),
      Line(MakePlainLabel("device-line", this)), Form(new QFormLayout(this)),
      Clutch(new QComboBox(this)), Offer(new QWidget(this))
{
  this->MakeRows();
  connect(this->Device, &DeviceChoice::Changed, this, &DevicePanel::TakeChoice);
  connect(this->Device, &DeviceChoice::Opened, this, [this] { this->Search({}); });
  connect(this->Clutch, qOverload<int>(&QComboBox::activated), this, &DevicePanel::TakeClutch);
  connect(&study, &StudyController::StateChanged, this, &DevicePanel::ShowState);
  connect(&study, &StudyController::TouchChanged, this, &DevicePanel::ShowLine);
  connect(&this->Watch, &QTimer::timeout, this, &DevicePanel::SearchAgain);
  this->ShowState();
}

DevicePanel::~DevicePanel()
{
  if (this->Searching)
  {
    this->Study.Current().Jobs().Cancel(*this->Searching);
  }
}

void DevicePanel::MakeRows()
{
  this->Form->setContentsMargins(0, 0, 0, 0);
  this->Device->setObjectName("device");
  this->Form->addRow("Device", this->Device);
  this->Line->setWordWrap(true);
  this->Line->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Form->addRow(this->Line);
  this->Clutch->setObjectName("clutch-button");
  this->Clutch->setToolTip(
      "While it is held nothing is felt and the tool stays: move the hand, and "
      "go on from there. Button 1 is the drill's pedal");
  this->Form->addRow("Clutch", this->Clutch);
  auto* row = new QHBoxLayout(this->Offer);
  row->setContentsMargins(0, 0, 0, 0);
  auto* attempt = new QPushButton("First use, step by step...", this->Offer);
  attempt->setObjectName("try-device");
  auto* later = new QPushButton("Not now", this->Offer);
  later->setObjectName("not-now");
  row->addWidget(attempt, 1);
  row->addWidget(later);
  this->Form->addRow(this->Offer);
  connect(attempt, &QPushButton::clicked, this,
          [this]
          {
            this->EndOffer();
            Q_EMIT TrialAsked();
          });
  connect(later, &QPushButton::clicked, this, &DevicePanel::EndOffer);
}

void DevicePanel::TakeChoice()
{
  this->Study.Change("Choose the device " + this->Device->currentText(),
                     DeviceSettings::WithDevice(this->Study.State(), this->Device->Chosen()),
                     "device");
}

void DevicePanel::KeepScale(double scale)
{
  DeviceSettings kept = DeviceSettings::Kept(this->Study.State().Device);
  kept.Scale = scale;
  kept.Keep(this->Study.State().Device);
}

void DevicePanel::KeepAxes(bool followCamera)
{
  DeviceSettings kept = DeviceSettings::Kept(this->Study.State().Device);
  kept.AxesFollowCamera = followCamera;
  kept.Keep(this->Study.State().Device);
}

void DevicePanel::EndOffer()
{
  DeviceSettings kept = DeviceSettings::Kept(this->Study.State().Device);
  kept.IsKnown = true;
  kept.Keep(this->Study.State().Device);
  this->Offer->hide();
}

void DevicePanel::TakeClutch()
{
  const int button = this->Clutch->currentData().toInt();
  DeviceSettings kept = DeviceSettings::Kept(this->Study.State().Device);
  kept.ClutchButton = button;
  kept.Keep(this->Study.State().Device);
  this->Study.Current().Touch().SetClutchButton(button);
}

void DevicePanel::ShowState()
{
  const std::string& device = this->Study.State().Device;
  const QSignalBlocker quiet(this->Device);
  this->Device->Choose(device);
  if (device == this->Shown)
  {
    return;
  }
  this->Shown = device;
  this->Found.clear();
  this->ShowClutch();
  const bool isPlugged = IsPluggedIn(device);
  this->Offer->setVisible(isPlugged && !DeviceSettings::Kept(device).IsKnown);
  isPlugged ? this->Watch.start(WatchMilliseconds) : this->Watch.stop();
  this->ShowLine();
  this->SearchAgain();
}

void DevicePanel::ShowClutch()
{
  const DeviceCapabilities device = UsualCapabilities(this->Shown);
  const int usual = DeviceSettings::UsualClutch(device);
  const int button = DeviceSettings::Kept(this->Shown).ClutchButton.value_or(usual);
  this->Clutch->clear();
  this->Clutch->addItem("None", -1);
  for (int n = 1; n < device.Buttons; ++n)
  {
    this->Clutch->addItem(QString("Button %1").arg(n + 1), n);
  }
  this->Clutch->setCurrentIndex(std::max(0, this->Clutch->findData(button)));
  ShowRow(this->Form, this->Clutch, device.Buttons >= FewestButtons);
  this->Study.Current().Touch().SetClutchButton(button);
}

QString DevicePanel::LineNow() const
{
  const std::string& device = this->Study.State().Device;
  const std::string identity = DeviceSettings::IdentityOf(device).toStdString();
  const bool isAny = identity == KindOf(device); // of the kind
  const auto found = std::find_if(this->Found.begin(), this->Found.end(),
                                  [&](const DeviceReport& one)
                                  { return (isAny ? KindOf(one.Name) : one.Name) == identity; });
  if (this->Study.IsTouching())
  {
    return "In use.";
  }
  if (found != this->Found.end())
  {
    return ScreenString(StateLine(*found));
  }
  return isAny || this->Found.empty() ? "Looking for it..." : "It is looked for when touch starts.";
}

void DevicePanel::ShowLine()
{
  this->Line->setText(this->LineNow());
  this->Line->setVisible(IsPluggedIn(this->Study.State().Device));
}

void DevicePanel::SearchAgain()
{
  const std::string& device = this->Study.State().Device;
  const bool isFree = !this->Study.IsTouching() && !this->Study.Current().IsOpeningDevice() &&
                      !this->Study.Current().IsAwaitingDevice() &&
                      QApplication::activeModalWidget() == nullptr; // which may use it
  if (isFree && this->isVisible() && IsPluggedIn(device))
  {
    this->Search(KindOf(device));
  }
}

// All kinds, or one; in the background, but for one that is in use.
void DevicePanel::Search(const std::string& kind)
{
  if (this->Searching)
  {
    return;
  }
  const bool isUsed = this->Study.IsTouching() || this->Study.Current().IsOpeningDevice();
  const std::string used = isUsed ? this->Study.State().Device : "";
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, kind, used](const ProgressFunction&)
  {
    std::vector<DeviceReport> found = kind.empty() ? ListDevices(used) : ListDevicesOf(kind);
    return StudyJob::Delivery(
        [this, found = std::move(found)]
        {
          this->Searching.reset();
          this->Found = found;
          this->Device->Show(found);
          this->ShowLine();
        });
  };
  job.Fail = [this](const std::string&) { this->Searching.reset(); };
  this->Searching = this->Study.Current().Jobs().Start(std::move(job));
}
} // namespace palpate
