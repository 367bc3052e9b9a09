#pragma once

#include "PalpateTaskModule.h"
#include "TaskSettings.h"
#include "Vector3.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// How much of a target's path a tool has passed: the part of its places, a millimetre apart, that
/// it reached one after another, each within the target's tolerance.
class PALPATETASK_EXPORT PathCourse
{
public:
  explicit PathCourse(const TaskTarget& target);

  /// The tool's next place, mm.
  void Take(const Vector3& toolWorld);
  double Share() const ///< 0..1
  {
    return static_cast<double>(this->Passed) / static_cast<double>(this->Places.size());
  }

private:
  std::vector<Vector3> Places;
  double Tolerance; ///< mm
  std::size_t Passed = 0;
};
} // namespace palpate
