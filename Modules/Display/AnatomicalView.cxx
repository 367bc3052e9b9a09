#include "AnatomicalView.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
struct Side
{
  const char* Name;
  int Axis; // towards the viewer, patient LPS
  double Sign;
};

// In the order of ViewSide.
constexpr std::array<Side, 6> Sides{{{"Anterior", 1, -1.0},
                                     {"Posterior", 1, 1.0},
                                     {"Left", 0, 1.0},
                                     {"Right", 0, -1.0},
                                     {"Superior", 2, 1.0},
                                     {"Inferior", 2, -1.0}}};

const Side& PropertiesOf(ViewSide side)
{
  return Sides[static_cast<std::size_t>(side)];
}
} // namespace

ViewFrame FrameOf(ViewSide side)
{
  const Side& properties = PropertiesOf(side);
  const Vector3 towards = properties.Sign * Vector3::Unit(properties.Axis);
  const bool isAlongBody = properties.Axis == 2;
  const Vector3 up = isAlongBody ? Vector3(-Vector3::UnitY()) : Vector3(Vector3::UnitZ());
  return {up.cross(towards), up, towards};
}

ViewFrame ObliqueFrame()
{
  const Vector3 towards = Vector3(0.5, -0.75, 0.43).normalized();
  const Vector3 right = Vector3::UnitZ().cross(towards).normalized();
  return {right, towards.cross(right), towards};
}

std::string NameOf(ViewSide side)
{
  return PropertiesOf(side).Name;
}

std::string OrientationLetters(const Vector3& directionWorld)
{
  static const char* const Positive = "LPS";
  static const char* const Negative = "RAI";
  std::array<int, 3> axes{{0, 1, 2}};
  std::sort(axes.begin(), axes.end(),
            [&directionWorld](int a, int b)
            { return std::abs(directionWorld[a]) > std::abs(directionWorld[b]); });
  const double strongest = std::abs(directionWorld[axes.front()]);
  std::string letters;
  for (const int axis : axes)
  {
    const double share = directionWorld[axis];
    if (std::abs(share) >= 0.5 * strongest && strongest > 0.0)
    {
      letters += share > 0.0 ? Positive[axis] : Negative[axis];
    }
  }
  return letters;
}

std::array<std::string, 4> EdgeLettersOf(const ViewFrame& frame)
{
  return {OrientationLetters(-frame.RightWorld), OrientationLetters(frame.RightWorld),
          OrientationLetters(frame.UpWorld), OrientationLetters(-frame.UpWorld)};
}
} // namespace palpate
