#pragma once

#include "Servo.h"
#include "TouchDoubles.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// A servo and a hand that goes along a path there and back, a place a tick at 1 kHz, as often as
/// asked: all that a tick takes, from the device's sample to its force.
class ServoStroke
{
public:
  /// World, mm; an even number of places. Throws std::runtime_error for a scene that cannot be
  /// felt.
  ServoStroke(std::shared_ptr<const TouchScene> scene, std::vector<Vector3> path);

  std::size_t Ticks() const { return this->Path.size(); }

  /// Goes on in time at each call.
  void Stroke();
  /// The same, and the time that each tick took, ns, taken to the shortest of the calls.
  void StrokeTimed(std::vector<double>& shortest);

  /// Of the last stroke: where the hand was (mm) and what it felt (N).
  const std::vector<Vector3>& Probes() const { return this->Gone; }
  const std::vector<Vector3>& Proxies() const { return this->Touched; }
  const std::vector<Vector3>& Forces() const { return this->Applied; }
  double PublishSeconds() const { return this->Seconds; }
  /// That the servo added to what the models take, a structure; 0 where not known.
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
