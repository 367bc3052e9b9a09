#include "ServoStroke.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <malloc.h>
#include <stdexcept>
#include <utility>

namespace palpate::bench
{
namespace
{
using BenchClock = std::chrono::steady_clock;

constexpr std::int64_t Period = 1'000'000; // ns

double BytesInUse()
{
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}
} // namespace

ServoStroke::ServoStroke(std::shared_ptr<const TouchScene> scene, std::vector<Vector3> path)
    : Path(std::move(path)), Gone(Path.size()), Touched(Path.size()), Applied(Path.size()),
      Loop(this->Device, {})
{
  const auto count = static_cast<double>(scene->Structures.size());
  const double before = BytesInUse();
  const auto start = BenchClock::now();
  const Status status = this->Loop.Publish(std::move(scene));
  this->Seconds = std::chrono::duration<double>(BenchClock::now() - start).count();
  this->Bytes = (BytesInUse() - before) / count;
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

// Forwards and backwards, so that strokes are continuous.
std::size_t ServoStroke::PlaceOf(std::size_t tick) const
{
  return tick < this->Path.size() / 2 ? tick : this->Path.size() - 1 - tick;
}

void ServoStroke::TickAt(std::size_t place)
{
  this->Device.Next.Position = this->Path[place];
  this->Device.Next.Time = this->Tick.Started;
  this->Loop.Tick(this->Tick);
  ++this->Tick.Number;
  this->Tick.Scheduled = this->Tick.Started += Period;
}

void ServoStroke::Keep(std::size_t tick)
{
  this->Gone[tick] = this->Path[this->PlaceOf(tick)];
  this->Touched[tick] = this->Loop.Latest().ProxyWorld;
  this->Applied[tick] = this->Device.Applied;
}

void ServoStroke::Stroke()
{
  for (std::size_t tick = 0; tick < this->Ticks(); ++tick)
  {
    this->TickAt(this->PlaceOf(tick));
    this->Applied[tick] = this->Device.Applied;
  }
}

void ServoStroke::StrokeTimed(std::vector<double>& shortest)
{
  shortest.resize(this->Ticks(), INFINITY);
  for (std::size_t tick = 0; tick < this->Ticks(); ++tick)
  {
    const std::size_t place = this->PlaceOf(tick);
    const auto start = BenchClock::now();
    this->TickAt(place);
    const std::chrono::duration<double, std::nano> spent = BenchClock::now() - start;
    shortest[tick] = std::min(shortest[tick], spent.count());
    this->Keep(tick);
  }
}
} // namespace palpate::bench
