#include "StudyReplay.h"

#include "Refusal.h"
#include "SafetyText.h"
#include "TouchRecording.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
bool BeganBefore(const TouchState& one, const TouchState& other)
{
  return one.Tick.Started < other.Tick.Started;
}
} // namespace

std::shared_ptr<const TouchRecording> ReadReplay(const std::filesystem::path& file)
{
  auto recording = std::make_shared<TouchRecording>();
  RequireInput(ReadTouchRecording(file.string(), *recording));
  const std::vector<TouchState>& ticks = recording->Ticks;
  if (ticks.empty())
  {
    Refuse(file, "has no ticks", "record the touch again");
  }
  if (!std::is_sorted(ticks.begin(), ticks.end(), BeganBefore))
  {
    Refuse(file, "is damaged: its time runs backwards", "record the touch again");
  }
  return recording;
}

StudyReplay::StudyReplay(std::filesystem::path file,
                         std::shared_ptr<const TouchRecording> recording, Clock& clock)
    : Path(std::move(file)), Recorded(std::move(recording)), Time(clock)
{
}

double StudyReplay::Duration() const
{
  const std::vector<TouchState>& ticks = this->Recorded->Ticks;
  return SecondsPerNanosecond *
         static_cast<double>(ticks.back().Tick.Started - ticks.front().Tick.Started);
}

double StudyReplay::Position() const
{
  const double passed = this->Playing ? this->Rate * SecondsPerNanosecond *
                                            static_cast<double>(this->Time.Now() - this->Since)
                                      : 0.0;
  return std::min(this->Held + passed, this->Duration());
}

// Continues from this position, starting now.
void StudyReplay::HoldTo(double seconds)
{
  this->Held = seconds;
  this->Since = this->Time.Now();
}

void StudyReplay::MoveTo(double seconds)
{
  if (!std::isnan(seconds))
  {
    this->HoldTo(std::clamp(seconds, 0.0, this->Duration()));
    this->HasLeapt = true;
  }
}

void StudyReplay::Play()
{
  if (this->Position() >= this->Duration())
  {
    this->MoveTo(0.0);
  }
  this->HoldTo(this->Position());
  this->Playing = true;
}

void StudyReplay::Pause()
{
  this->HoldTo(this->Position());
  this->Playing = false;
}

void StudyReplay::SetSpeed(double speed)
{
  if (!std::isnan(speed))
  {
    this->HoldTo(this->Position());
    this->Rate = std::clamp(speed, LeastSpeed, LargestSpeed);
  }
}

// The last tick that had begun by then.
std::size_t StudyReplay::TickAt(double seconds) const
{
  const std::vector<TouchState>& ticks = this->Recorded->Ticks;
  const std::int64_t time =
      ticks.front().Tick.Started + std::llround(seconds / SecondsPerNanosecond);
  const auto after = std::upper_bound(ticks.begin(), ticks.end(), time,
                                      [](std::int64_t t, const TouchState& tick)
                                      { return t < tick.Tick.Started; });
  return after == ticks.begin() ? 0 : static_cast<std::size_t>(after - ticks.begin()) - 1;
}

const StudyTouchReading& StudyReplay::Poll(const std::vector<int>& labels)
{
  const double position = this->Position();
  if (this->Playing && position >= this->Duration())
  {
    this->Pause();
  }
  const std::vector<TouchState>& ticks = this->Recorded->Ticks;
  const std::size_t now = this->TickAt(position);
  const std::size_t shown = this->TickAt(std::max(position - SecondsBefore, 0.0));
  const bool goesOn = !this->HasLeapt && now >= this->Last && shown <= this->Last;
  const std::size_t first = goesOn ? this->Last + 1 : shown;
  this->Reading.NewTicks.assign(ticks.begin() + static_cast<std::ptrdiff_t>(first),
                                ticks.begin() + static_cast<std::ptrdiff_t>(now) + 1);
  this->Last = now;
  this->HasLeapt = false;
  this->Reading.Newest = ticks[now];
  this->Reading.Safety = SafetyText(ticks[now]);
  const auto touched = static_cast<std::size_t>(ticks[now].Structure);
  this->Reading.TouchedId = touched < labels.size() ? labels[touched] : 0;
  return this->Reading;
}
} // namespace palpate
