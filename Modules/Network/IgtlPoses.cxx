#include "IgtlPoses.h"

#include "SingularValues.h"

#include <Eigen/Geometry>

#include <cstring>
#include <igtl_transform.h>

namespace palpate
{
namespace
{
// Three columns of a rotation, then the place.
bool IsPose(const std::vector<std::uint8_t>& content, IgtlPose& pose)
{
  std::array<float, 12> numbers{};
  if (content.size() != sizeof numbers)
  {
    return false;
  }
  std::memcpy(numbers.data(), content.data(), sizeof numbers);
  igtl_transform_convert_byte_order(numbers.data());
  Matrix3 turn;
  Vector3 place;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const float* column = numbers.data() + 3 * i;
    turn.col(static_cast<Eigen::Index>(i)) = Vector3(column[0], column[1], column[2]);
  }
  place = Vector3(numbers[9], numbers[10], numbers[11]);
  constexpr double Farthest = 1e6; // mm
  if (!turn.allFinite() || !(place.norm() < Farthest))
  {
    return false;
  }
  // Some senders have quaternions of another length than 1: the nearest rotation is meant.
  constexpr double Least = 0.5;
  constexpr double Most = 2.0;
  const SingularValues parts = SingularValuesOf(turn);
  if (!(turn.determinant() > 0.0) || !(parts.Values[2] > Least) || !(parts.Values[0] < Most))
  {
    return false;
  }
  const Eigen::Quaterniond q = Eigen::Quaterniond(parts.NearestOrthogonal()).normalized();
  pose.Position = place;
  pose.Orientation = {q.x(), q.y(), q.z(), q.w()};
  return true;
}
} // namespace

bool IgtlPoses::Take(const std::uint8_t* bytes, std::size_t count)
{
  const bool isUnderstood = this->Parser.Take(bytes, count);
  while (const std::optional<IgtlMessage> message = this->Parser.Next())
  {
    IgtlPose pose;
    if (message->Type == "STATUS")
    {
      this->Confirmed += message->Name == "Force" ? 1 : 0;
      continue;
    }
    if (!this->Name.empty() && this->Name != message->Name)
    {
      continue;
    }
    if (IsPose(message->Content, pose))
    {
      this->Name = message->Name;
      this->Last = pose;
      this->IsFresh = true;
    }
    else
    {
      ++this->NoPoses;
    }
  }
  return isUnderstood;
}

const IgtlPose* IgtlPoses::Newest() noexcept
{
  const IgtlPose* newest = this->IsFresh ? &this->Last : nullptr;
  this->IsFresh = false;
  return newest;
}
} // namespace palpate
