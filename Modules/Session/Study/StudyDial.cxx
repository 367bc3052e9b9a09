#include "StudyDial.h"

#include <algorithm>

namespace palpate
{
const char* NameOf(StudyDial dial)
{
  constexpr std::array<const char*, 8> Names{"by hand",
                                             "automatic",
                                             "harmonics of degree 4",
                                             "harmonics of degree 8",
                                             "harmonics of degree 12",
                                             "harmonics of degree 16",
                                             "sub-voxel, linear",
                                             "sub-voxel, cubic"};
  return Names.at(static_cast<std::size_t>(dial));
}

int RungOf(StudyDial dial)
{
  const auto found = std::find(AllStudyRungs.begin(), AllStudyRungs.end(), dial);
  return found != AllStudyRungs.end() ? static_cast<int>(found - AllStudyRungs.begin()) : -1;
}

TradeSetting SettingOf(int rung, const TouchToolSettings& tool)
{
  constexpr std::array<int, 4> Degrees{{4, 8, 12, 16}};
  TradeSetting setting;
  setting.ToolPoints = tool.Points;
  const StudyDial dial = AllStudyRungs.at(static_cast<std::size_t>(rung));
  const bool isField = dial == StudyDial::SubVoxelLinear || dial == StudyDial::SubVoxelCubic;
  setting.Representation = isField ? TouchRepresentation::SubVoxel : TouchRepresentation::Harmonics;
  setting.Degree = isField ? setting.Degree : Degrees.at(static_cast<std::size_t>(rung));
  setting.Interpolation = dial == StudyDial::SubVoxelCubic ? FieldInterpolation::TricubicBSpline
                                                           : FieldInterpolation::Trilinear;
  return setting;
}
} // namespace palpate
