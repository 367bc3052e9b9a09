#pragma once

#include "Servo.h"
#include "TouchDoubles.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// A servo and a hand that moves along a path forwards and backwards, one place per tick at 1 kHz,
/// as often as requested: the whole cost of a tick, from the device's sample to its force.
class ServoStroke
{
public:
  /// `path` in world mm, an even number of places. Throws std::runtime_error for a scene that
  /// cannot be touched.
  ServoStroke(std::shared_ptr<const TouchScene> scene, std::vector<Vector3> path);

  std::size_t Ticks() const { return this->Path.size(); }

  /// Time continues from call to call.
  void Stroke();
  /// The same with the duration of each tick (ns), as the minimum over the calls.
  void StrokeTimed(std::vector<double>& shortest);

  /// Positions of the hand (mm) and forces (N) of the last stroke.
  const std::vector<Vector3>& Probes() const { return this->Gone; }
  const std::vector<Vector3>& Proxies() const { return this->Touched; }
  const std::vector<Vector3>& Forces() const { return this->Applied; }
  double PublishSeconds() const { return this->Seconds; }
  /// Bytes per structure that the servo needs in addition to the models; 0 if unknown.
  double BytesPerStructure() const { return this->Bytes; }

private:
  void TickAt(std::size_t place);
  std::size_t PlaceOf(std::size_t tick) const;
  void Keep(std::size_t tick);

  std::vector<Vector3> Path;
  std::vector<Vector3> Gone;
  std::vector<Vector3> Touched;
  std::vector<Vector3> Applied;
  test::ScriptedDevice Device;
  Servo Loop;
  TickInfo Tick;
  double Seconds = 0.0;
  double Bytes = 0.0;
};
} // namespace palpate::bench
