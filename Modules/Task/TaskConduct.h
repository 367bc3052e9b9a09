#pragma once

#include "Vector3.h"

#include <string>
#include <vector>

namespace palpate
{
/// Why a trial ended.
enum class TaskEnd
{
  Done,    ///< by its participant
  Time,    ///< beyond the time limit
  Force,   ///< beyond the limit of the force
  GivenUp, ///< by its participant or examiner, without an answer
};

/// What was measured while a trial ran.
struct TaskConduct
{
  TaskEnd End = TaskEnd::Done;
  double Seconds = 0.0;
  double MeanForce = 0.0; ///< N, while something is touched
  double PeakForce = 0.0; ///< N
  double TouchedSeconds = 0.0;
  int Contacts = 0; ///< that began
  double DeepestMillimeters = 0.0;
  double PathMillimeters = 0.0; ///< of the tool
};

/// An answer; what its kind does not ask for is ignored.
struct TaskAnswer
{
  /// Nodule: where, none for "there is none". Landmarks: one for each, NaN for those left out.
  /// Outline, path: where the tool went. mm.
  std::vector<Vector3> PointsWorld;
  double Diameter = 0.0;           ///< mm
  Vector3 Shift = Vector3::Zero(); ///< as in TaskPose
  Vector3 Turn = Vector3::Zero();
  double Dice = 0.0;         ///< of a corrected mask with the true one
  double MeanDistance = 0.0; ///< mm, of their surfaces
};
} // namespace palpate
