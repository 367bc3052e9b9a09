#include "ReplayBar.h"

#include "ScreenString.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double MostSliderSteps = 1e6; // of the slider, for recordings of any length

// A millisecond, or more in long recordings.
double StepOf(const StudyReplay& replay)
{
  return std::max(1e-3, replay.Duration() / MostSliderSteps);
}

QString TimeText(double seconds)
{
  const int minutes = static_cast<int>(seconds / 60.0);
  return QString("%1:%2").arg(minutes).arg(seconds - 60.0 * minutes, 6, 'f', 3, QChar('0'));
}
} // namespace

ReplayBar::ReplayBar(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Name(new QLabel(this)), Play(new QPushButton(this)),
      Slider(new QSlider(Qt::Horizontal, this)), Moment(new QLabel(this)),
      Speed(new QComboBox(this))
{
  this->Name->setTextFormat(Qt::PlainText);
  this->Play->setObjectName("replay-play");
  this->Slider->setObjectName("replay-slider");
  this->Moment->setObjectName("replay-time");
  auto* close = new QPushButton("Close", this);
  close->setObjectName("replay-close");
  this->MakeSpeeds();
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(this->Name);
  row->addWidget(this->Play);
  row->addWidget(this->Slider, 1);
  row->addWidget(this->Moment);
  row->addWidget(this->Speed);
  row->addWidget(close);
  connect(close, &QPushButton::clicked, &study, &StudyController::CloseReplay);
  connect(this->Play, &QPushButton::clicked, this,
          [this]
          {
            const StudyReplay* replay = this->Study.Current().Replay();
            this->Study.PlayReplay(replay != nullptr && !replay->IsPlaying());
          });
  connect(this->Slider, &QSlider::valueChanged, this,
          [this](int step)
          {
            if (StudyReplay* replay = this->Study.Current().Replay())
            {
              replay->MoveTo(step * StepOf(*replay));
            }
          });
  connect(&study, &StudyController::ReplayChanged, this, &ReplayBar::ShowReplay);
  connect(&study, &StudyController::Touched, this, &ReplayBar::ShowMoment);
  this->ShowReplay();
}

void ReplayBar::MakeSpeeds()
{
  this->Speed->setObjectName("replay-speed");
  this->Speed->setToolTip("Playback speed");
  for (const double speed : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0})
  {
    this->Speed->addItem(QString("%1 x").arg(speed), speed);
  }
  connect(this->Speed, qOverload<int>(&QComboBox::activated), this,
          [this](int index)
          {
            if (StudyReplay* replay = this->Study.Current().Replay())
            {
              replay->SetSpeed(this->Speed->itemData(index).toDouble());
            }
          });
}

void ReplayBar::ShowReplay()
{
  const StudyReplay* replay = this->Study.Current().Replay();
  this->setVisible(replay != nullptr);
  if (replay == nullptr)
  {
    return;
  }
  this->Name->setText(ScreenString(replay->File().filename().string()));
  this->Play->setText(replay->IsPlaying() ? "Pause" : "Play");
  {
    const QSignalBlocker blocker(this->Slider);
    this->Slider->setRange(0, static_cast<int>(std::ceil(replay->Duration() / StepOf(*replay))));
    this->Slider->setPageStep(std::max(1, this->Slider->maximum() / 20));
  }
  this->Speed->setCurrentIndex(this->Speed->findData(replay->Speed()));
  this->ShowMoment();
}

void ReplayBar::ShowMoment()
{
  const StudyReplay* replay = this->Study.Current().Replay();
  if (replay == nullptr)
  {
    return;
  }
  // While the user drags, only the text follows.
  if (!this->Slider->isSliderDown())
  {
    const QSignalBlocker blocker(this->Slider);
    this->Slider->setValue(static_cast<int>(std::lround(replay->Position() / StepOf(*replay))));
  }
  this->Moment->setText(TimeText(replay->Position()) + " / " + TimeText(replay->Duration()));
}
} // namespace palpate
