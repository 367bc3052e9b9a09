#pragma once

#include "ComparedBody.h"
#include "CorrectedShape.h"
#include "HandSkill.h"
#include "TaskHand.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A simulated hand that corrects a mask: it pulls where the surface seems to be farthest from the
/// organ's edge, which it sees with an error (HandSkill), until nothing seems to be a millimetre
/// off. A pull is by the tool, which grips the surface where it touches it, as in the window; it is
/// as wide as looks best.
class MaskPuller
{
public:
  /// Keeps the addresses.
  MaskPuller(TaskHand& hand, const HandSkill& skill, const ComparedBody& truth)
      : Hand(hand), Skill(skill), Truth(truth)
  {
  }

  void Correct(CorrectedShape& mask);

private:
  struct Place
  {
    std::size_t Point = 0;
    double Wanted = 0.0; ///< mm, outwards, as it is seen
  };

  std::vector<double> Wanted(const SurfaceCorrection& pulls) const;
  Place Worst(const SurfaceCorrection& pulls, const std::vector<double>& wanted);
  void Touch(const Vector3& place, const Vector3& normal);
  SurfacePull Pull(const SurfaceCorrection& pulls, const Place& worst);
  void FeelAgain(CorrectedShape& mask);

  TaskHand& Hand;
  const HandSkill& Skill;
  const ComparedBody& Truth;
};
} // namespace palpate
