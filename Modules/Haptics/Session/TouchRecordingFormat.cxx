#include "TouchRecordingFormat.h"

#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
// One list of fields serves writing and reading: fields of 64 bits are copied, smaller ones are
// converted to numbers.
class WordWriter
{
public:
  explicit WordWriter(std::uint64_t* words) noexcept : Next(words) {}
  template <typename T>
  void Field(const T& value) noexcept
  {
    static_assert(sizeof(T) == sizeof(std::uint64_t));
    std::memcpy(this->Next++, &value, sizeof(value));
  }
  template <typename T>
  void Small(const T& value) noexcept
  {
    *this->Next++ = static_cast<std::uint64_t>(value);
  }

private:
  std::uint64_t* Next;
};

class WordReader
{
public:
  explicit WordReader(const std::uint64_t* words) noexcept : Next(words) {}
  template <typename T>
  void Field(T& value) noexcept
  {
    static_assert(sizeof(T) == sizeof(std::uint64_t));
    std::memcpy(&value, this->Next++, sizeof(value));
  }
  template <typename T>
  void Small(T& value) noexcept
  {
    const std::uint64_t word = *this->Next++;
    value = static_cast<T>(word);
    this->HaveFitted = this->HaveFitted && static_cast<std::uint64_t>(value) == word;
  }
  bool AllFitted() const noexcept { return this->HaveFitted; }

private:
  const std::uint64_t* Next;
  bool HaveFitted = true;
};

template <typename State, typename Visitor>
void VisitFlags(State& s, Visitor visit)
{
  visit(s.Tick.IsLate);
  visit(s.HasSample);
  visit(s.WasTaken);
  visit(s.WasRearmed);
  visit(s.Safety.IsArmed);
  visit(s.Safety.IsRamping);
  visit(s.Safety.IsDamping);
  visit(s.Safety.IsLimited);
  visit(s.Safety.IsSlewing);
  visit(s.WasContinued);
  visit(s.IsDrilling);
  visit(s.IsBeyondLinear);
  visit(s.Safety.WillResume);
  visit(s.IsClutched);
  visit(s.IsBuried);
  visit(s.IsBehind);
}

std::uint64_t FlagsOf(const TouchState& state) noexcept
{
  std::uint64_t flags = 0;
  std::uint64_t bit = 1;
  VisitFlags(state,
             [&](bool flag)
             {
               flags |= flag ? bit : 0;
               bit <<= 1;
             });
  return flags;
}

void SetFlags(std::uint64_t flags, TouchState& state) noexcept
{
  VisitFlags(state,
             [&](bool& flag)
             {
               flag = (flags & 1) != 0;
               flags >>= 1;
             });
}

template <typename Words, typename Vector>
void VisitVector(Words& words, Vector& v)
{
  words.Field(v.X);
  words.Field(v.Y);
  words.Field(v.Z);
}

template <typename Words, typename State, typename Flags>
void VisitTick(Words& words, State& s, Flags& flags)
{
  words.Field(s.Tick.Number);
  words.Field(s.Tick.Scheduled);
  words.Field(s.Tick.Started);
  words.Field(s.Tick.BootTime);
  words.Field(s.Tick.SkippedPeriods);
  words.Field(flags);
  words.Small(s.State);
  words.Small(s.Safety.Fault);
  words.Field(s.Safety.Energy);
  VisitVector(words, s.Sample.Position);
  for (auto& number : s.Sample.Orientation)
  {
    words.Field(number);
  }
  words.Small(s.Sample.Buttons);
  words.Field(s.Sample.Sequence);
  words.Field(s.Sample.Time);
  VisitVector(words, s.ProbeWorld);
  VisitVector(words, s.ProxyWorld);
  VisitVector(words, s.ForceDevice);
  VisitVector(words, s.ForceWorld);
  words.Small(s.Structure);
  words.Field(s.Depth);
  words.Field(s.Scene);
  words.Small(s.Command);
  words.Field(s.DrillVersion);
  words.Field(s.DrillOrders);
  words.Field(s.PatchRadius);
  words.Field(s.ElasticEnergy);
  VisitVector(words, s.TorqueDevice);
  for (auto* orientation : {&s.ProbeOrientation, &s.ProxyOrientation})
  {
    for (auto& number : *orientation)
    {
      words.Field(number);
    }
  }
}

template <typename Words, typename Session>
void VisitSession(Words& words, Session& s)
{
  words.Field(s.Settings.Rate);
  words.Small(s.Settings.ModelInterval);
  words.Field(s.Settings.VelocityTimeConstant);
  words.Field(s.Settings.RampDuration);
  words.Field(s.Settings.MaximumSlew);
  words.Field(s.Device.MaximumForce);
  words.Field(s.Device.MaximumDamping);
  words.Field(s.Device.Damping);
  words.Field(s.Device.Friction);
  words.Field(s.Device.Rate);
  VisitVector(words, s.Device.GravityCompensation);
  words.Small(s.Device.HasMotors);
  words.Field(s.Device.MaximumTorque);
}
} // namespace

TouchRecordingFormat::SessionRecord
TouchRecordingFormat::Encode(const RecordedSession& session) noexcept
{
  SessionRecord record{};
  WordWriter words(record.data());
  // The guaranteed rate of samples is the one that forces depend on.
  RecordedSession kept = session;
  kept.Device.Rate = session.Device.LeastRate();
  VisitSession(words, kept);
  return record;
}

TouchRecordingFormat::TickRecord TouchRecordingFormat::Encode(const TouchState& state) noexcept
{
  TickRecord record{};
  WordWriter words(record.data());
  const std::uint64_t flags = FlagsOf(state);
  VisitTick(words, state, flags);
  return record;
}

bool TouchRecordingFormat::Decode(const SessionRecord& record, RecordedSession& session) noexcept
{
  WordReader words(record.data());
  VisitSession(words, session);
  return words.AllFitted() && session.Settings.Rate > 0.0 && std::isfinite(session.Settings.Rate);
}

bool TouchRecordingFormat::Decode(const TickRecord& record, TouchState& state) noexcept
{
  WordReader words(record.data());
  std::uint64_t flags = 0;
  VisitTick(words, state, flags);
  SetFlags(flags, state);
  return words.AllFitted() && flags == FlagsOf(state) && state.State <= DeviceState::Error &&
         state.State >= DeviceState::Closed && state.Command <= DrillCommand::Reset &&
         state.Safety.Fault >= SafetyFault::None && state.Safety.Fault <= SafetyFault::UntakenForce;
}
} // namespace palpate
