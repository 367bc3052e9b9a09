#pragma once

#include "PlainVector3.h"
#include "Status.h"

#include <cstdint>
#include <string>

namespace palpate
{
struct TouchState;

/// How a person steers: fractions of the full deflection, from -1 to 1, in the device's frame.
struct SteeringInput
{
  PlainVector3 Push;         ///< along x, y, z
  PlainVector3 Turn;         ///< about x, y, z, by the right hand
  std::uint32_t Buttons = 0; ///< one bit each, set while pressed
};

/// A stick, a cap or a pad, which says how a computed hand moves (SteeredDevice). Open, Close and
/// Problem: owner thread. Read and Show: servo thread, between Open and Close.
class SteeringSource
{
public:
  SteeringSource() = default;
  SteeringSource(const SteeringSource&) = delete;
  SteeringSource& operator=(const SteeringSource&) = delete;
  /// The source closes itself.
  virtual ~SteeringSource() = default;

  virtual std::string Name() const = 0; ///< for display
  virtual int Buttons() const = 0;      ///< number of those that every source of the kind has
  /// Why Read returned false, and what to do.
  virtual std::string Problem() const = 0;
  virtual Status Open() = 0;
  virtual void Close() noexcept = 0;
  /// The newest deflection. Returns false, and from then on, if the source failed. Never waits.
  virtual bool Read(SteeringInput& input) noexcept = 0;
  /// What a tick computed, for sources that tell it to the hand.
  virtual void Show(const TouchState& state) noexcept { static_cast<void>(state); }
};
} // namespace palpate
