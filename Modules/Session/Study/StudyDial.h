#pragma once

#include "PalpateSessionModule.h"
#include "TouchSettings.h"
#include "TradeSetting.h"

#include <array>

namespace palpate
{
/// How true a whole scene is felt: one number for all its structures, from the fastest to the
/// truest, or not one.
enum class StudyDial
{
  ByHand,    ///< each structure as it says itself
  Automatic, ///< for each structure the fastest that is as true as its mask or a hand can tell
  Harmonics4,
  Harmonics8,
  Harmonics12,
  Harmonics16,
  SubVoxelLinear,
  SubVoxelCubic
};
/// The dial's positions, fastest first.
constexpr std::array<StudyDial, 6> AllStudyRungs{
    {StudyDial::Harmonics4, StudyDial::Harmonics8, StudyDial::Harmonics12, StudyDial::Harmonics16,
     StudyDial::SubVoxelLinear, StudyDial::SubVoxelCubic}};

/// "by hand", "automatic", "harmonics of degree 4", ..., "sub-voxel, cubic".
PALPATESESSION_EXPORT const char* NameOf(StudyDial dial);

/// Of AllStudyRungs, from 0; -1 for a dial that stands at none.
PALPATESESSION_EXPORT int RungOf(StudyDial dial);

/// What a rung is, before it is known which degree a structure supports.
PALPATESESSION_EXPORT TradeSetting SettingOf(int rung, const TouchToolSettings& tool);
} // namespace palpate
