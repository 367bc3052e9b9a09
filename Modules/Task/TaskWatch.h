#pragma once

#include "PalpateTaskModule.h"
#include "TaskConduct.h"
#include "TaskSettings.h"
#include "TouchState.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// Measures a trial tick by tick, whether a person or a simulated hand holds the device.
///
/// In a condition with force the tool is where it is held by what it touches (the proxy), otherwise
/// where the hand is: so it has to be shown, too.
class PALPATETASK_EXPORT TaskWatch
{
public:
  /// `toolRadius` (mm): of the tool's sphere, 0 for a point.
  TaskWatch(const TaskSettings& task, bool hasForce, double toolRadius);

  /// The next tick. Neither allocates before KeepTrace nor throws.
  void Take(const TouchState& tick);
  /// From the next tick on the tool's way is kept for the answer, while the button is down.
  void KeepTrace(bool isKept) { this->Keeps = isKept; }

  /// Whether a limit has ended the trial.
  bool IsOver() const { return this->Conduct.End != TaskEnd::Done; }
  const TaskConduct& Measured() const { return this->Conduct; }
  /// Where the tool was, at least 0.2 mm apart, at most some thousand points.
  const std::vector<Vector3>& Trace() const { return this->Kept; }
  /// Where it touches: the sphere's lowest point in what is touched, without contact its centre.
  Vector3 TipWorld(const TouchState& tick) const;

private:
  void MeasureForce(const TouchState& tick, double passed);

  double MostSeconds;
  double MostForce;
  bool HasForce;
  double ToolRadius;
  TaskConduct Conduct;
  double ForceSeconds = 0.0; // N s
  bool HasTicked = false;
  bool Keeps = false;
  bool Touches = false;
  std::int64_t First = 0; // ns
  std::int64_t Last = 0;  // ns
  Vector3 LastTool = Vector3::Zero();
  std::vector<Vector3> Kept;
};
} // namespace palpate
