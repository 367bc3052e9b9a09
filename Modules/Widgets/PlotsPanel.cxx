#include "PlotsPanel.h"

#include "TouchRecording.h"

#include <QHBoxLayout>

#include <cmath>

namespace palpate
{
PlotsPanel::PlotsPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study),
      ForceChart(new StripChart("Force", "N", QColor("#D55E00"), this)),
      DepthChart(new StripChart("Penetration", "mm", QColor("#0072B2"), this)),
      DurationChart(new StripChart("Tick", "\u00B5s", QColor("#009E73"), this)),
      PeriodChart(new StripChart("Period", "ms", QColor("#CC79A7"), this))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  for (StripChart* chart :
       {this->ForceChart, this->DepthChart, this->DurationChart, this->PeriodChart})
  {
    row->addWidget(chart, 1);
  }
  connect(&study, &StudyController::TouchChanged, this, &PlotsPanel::Begin);
  connect(&study, &StudyController::ReplayChanged, this, &PlotsPanel::BeginReplay);
  connect(&study, &StudyController::Touched, this, &PlotsPanel::TakeTicks);
}

void PlotsPanel::Clear()
{
  for (StripChart* chart :
       {this->ForceChart, this->DepthChart, this->DurationChart, this->PeriodChart})
  {
    chart->Clear();
  }
  this->LastStarted = -1.0;
  this->LastDurations = {};
}

void PlotsPanel::SetLimits(double force, double rate)
{
  this->ForceChart->SetLimit(force);
  this->DurationChart->SetLimit(1e6 / rate);
  this->PeriodChart->SetLimit(1e3 / rate);
}

void PlotsPanel::Begin()
{
  if (this->Study.IsTouching())
  {
    this->Clear();
    this->SetLimits(this->Study.Current().Touch().Capabilities().MaximumForce,
                    this->Study.State().Rate);
  }
}

void PlotsPanel::BeginReplay()
{
  const StudyReplay* replay = this->Study.Current().Replay();
  if (replay != nullptr && replay->File() != this->Replayed)
  {
    const RecordedSession& session = replay->Recording().Session;
    this->Clear();
    this->SetLimits(session.Device.MaximumForce, session.Settings.Rate);
  }
  this->Replayed = replay != nullptr ? replay->File() : std::filesystem::path();
}

void PlotsPanel::TakeTicks()
{
  const StudyTouchReading& reading = this->Study.Reading();
  const bool isNext =
      !reading.NewTicks.empty() && reading.NewTicks.front().Tick.Number == this->LastNumber + 1;
  if (this->Study.IsReplaying() && !reading.NewTicks.empty() && !isNext)
  {
    this->Clear(); // the replay jumped
  }
  for (const TouchState& tick : reading.NewTicks)
  {
    const double time = 1e-9 * static_cast<double>(tick.Tick.Started);
    const PlainVector3& force = tick.ForceWorld;
    this->ForceChart->Add(time, std::hypot(force.X, force.Y, force.Z));
    this->DepthChart->Add(time, tick.Depth);
    if (this->LastStarted >= 0.0)
    {
      this->PeriodChart->Add(time, 1e3 * (time - this->LastStarted));
    }
    this->LastStarted = time;
    this->LastNumber = tick.Tick.Number;
  }
  if (this->Study.IsTouching())
  {
    this->AddDuration(reading.Durations); // recordings have none
  }
}

// Tick times are accumulated: shows their mean since the previous reading.
void PlotsPanel::AddDuration(const PeriodStatistics& durations)
{
  const auto count = static_cast<double>(durations.Count());
  const double sum = durations.Mean() * count;
  if (count > this->LastDurations.Count && this->LastStarted >= 0.0)
  {
    const double mean = (sum - this->LastDurations.Sum) / (count - this->LastDurations.Count);
    this->DurationChart->Add(this->LastStarted, 1e-3 * mean);
  }
  this->LastDurations = {count, sum};
}
} // namespace palpate
