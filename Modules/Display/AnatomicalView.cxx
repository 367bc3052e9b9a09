#include "AnatomicalView.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
Vector3 Towards(ViewSide side)
{
  switch (side)
  {
  case ViewSide::Anterior:
    return -Vector3::UnitY();
  case ViewSide::Posterior:
    return Vector3::UnitY();
  case ViewSide::Left:
    return Vector3::UnitX();
  case ViewSide::Right:
    return -Vector3::UnitX();
  case ViewSide::Superior:
    return Vector3::UnitZ();
  case ViewSide::Inferior:
    break;
  }
  return -Vector3::UnitZ();
}
} // namespace

ViewFrame FrameOf(ViewSide side)
{
  const Vector3 towards = Towards(side);
  const bool isAlongBody = side == ViewSide::Superior || side == ViewSide::Inferior;
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
  switch (side)
  {
  case ViewSide::Anterior:
    return "Anterior";
  case ViewSide::Posterior:
    return "Posterior";
  case ViewSide::Left:
    return "Left";
  case ViewSide::Right:
    return "Right";
  case ViewSide::Superior:
    return "Superior";
  case ViewSide::Inferior:
    break;
  }
  return "Inferior";
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
