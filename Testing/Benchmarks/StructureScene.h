#pragma once

#include "Servo.h"
#include "TouchDoubles.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// A servo in a scene of many structures that can all be touched, of which a hand strokes one: an
/// organ of degree 12. The others, balls of 20 facets 60 mm apart, are round it.
class StructureScene
{
public:
  static constexpr int Ticks = 4000;

  /// Throws std::runtime_error where the scene cannot be made.
  explicit StructureScene(int count);

  /// Strokes the organ once, 1.5 mm deep at 50 mm/s and 1 kHz. Goes on in time at each call.
  void Stroke();
  /// The same, and the time that each tick took, ns, taken to the shortest of the calls.
  void StrokeTimed(std::vector<double>& shortest);

  /// Of the last stroke, N.
  const std::vector<Vector3>& Forces() const { return this->Applied; }
  double PublishSeconds() const { return this->Seconds; }
  /// That the servo added to what the models take, a structure; 0 where not known.
  double BytesPerStructure() const { return this->Bytes; }

private:
  void TickAt(std::size_t place);

  std::vector<Vector3> Path;
  std::vector<Vector3> Applied;
  test::ScriptedDevice Device;
  Servo Loop;
  TickInfo Tick;
  double Seconds = 0.0;
  double Bytes = 0.0;
};
} // namespace palpate::bench
