#include "IgtlPoses.h"

#include "Vector3.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cstring>
#include <igtl_header.h>
#include <igtl_transform.h>
#include <igtl_util.h>

namespace palpate
{
namespace
{
constexpr std::size_t HeaderBytes = IGTL_HEADER_SIZE;
constexpr std::uint64_t MostPoseBytes = 4096; // with the extended header and metadata of version 3
constexpr int NewestVersion = 3;

igtl_header HeaderOf(const std::vector<std::uint8_t>& message)
{
  igtl_header header;
  std::memcpy(&header, message.data(), HeaderBytes);
  igtl_header_convert_byte_order(&header);
  return header;
}

// Of a field that a zero ends, if there is room for one.
template <std::size_t Size>
std::string TextOf(const char (&field)[Size])
{
  return {field, strnlen(field, Size)};
}

std::uint32_t BigEndian(const std::uint8_t* bytes, int count)
{
  std::uint32_t number = 0;
  for (int i = 0; i < count; ++i)
  {
    number = number << 8 | bytes[i];
  }
  return number;
}

// The part of a body that is the message's own content: version 2 puts an extended header before
// it, and metadata behind it. Empty if the lengths contradict each other.
std::vector<std::uint8_t> ContentOf(const std::vector<std::uint8_t>& body, int version)
{
  if (version < 2)
  {
    return body;
  }
  constexpr std::size_t LeastExtended = 12;
  if (body.size() < LeastExtended)
  {
    return {};
  }
  const std::uint64_t before = BigEndian(body.data(), 2);
  const std::uint64_t behind =
      std::uint64_t{BigEndian(body.data() + 2, 2)} + BigEndian(body.data() + 4, 4);
  if (before < LeastExtended || before + behind > body.size())
  {
    return {};
  }
  return {body.begin() + static_cast<std::ptrdiff_t>(before),
          body.end() - static_cast<std::ptrdiff_t>(behind)};
}

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
  const Eigen::JacobiSVD<Matrix3> parts(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3& lengths = parts.singularValues();
  if (!(turn.determinant() > 0.0) || !(lengths.minCoeff() > Least) || !(lengths.maxCoeff() < Most))
  {
    return false;
  }
  const Matrix3 rotation = parts.matrixU() * parts.matrixV().transpose();
  const Eigen::Quaterniond q = Eigen::Quaterniond(rotation).normalized();
  pose.Position = place;
  pose.Orientation = {q.x(), q.y(), q.z(), q.w()};
  return true;
}
} // namespace

bool IgtlPoses::Take(const std::uint8_t* bytes, std::size_t count)
{
  while (count > 0)
  {
    const std::size_t wanted =
        this->HasHeader ? static_cast<std::size_t>(std::min<std::uint64_t>(this->BodyLeft, count))
                        : std::min(count, HeaderBytes - this->Message.size());
    if (!this->HasHeader || this->IsKept)
    {
      this->Message.insert(this->Message.end(), bytes, bytes + wanted);
    }
    bytes += wanted;
    count -= wanted;
    if (this->HasHeader)
    {
      this->BodyLeft -= wanted;
    }
    else if (this->Message.size() == HeaderBytes && !this->BeginMessage())
    {
      return false;
    }
    if (this->HasHeader && this->BodyLeft == 0)
    {
      this->EndMessage();
    }
  }
  return true;
}

bool IgtlPoses::BeginMessage()
{
  const igtl_header header = HeaderOf(this->Message);
  const std::string type = TextOf(header.name);
  const bool isName =
      std::all_of(type.begin(), type.end(), [](unsigned char c) { return c >= ' ' && c < 0x7F; });
  if (header.version < 1 || header.version > NewestVersion || type.empty() || !isName)
  {
    return false;
  }
  this->HasHeader = true;
  this->BodyLeft = header.body_size;
  this->IsKept = type == "TRANSFORM" && this->BodyLeft <= MostPoseBytes &&
                 (this->Name.empty() || this->Name == TextOf(header.device_name));
  return true;
}

void IgtlPoses::EndMessage()
{
  if (this->IsKept)
  {
    const igtl_header header = HeaderOf(this->Message);
    std::vector<std::uint8_t> body(this->Message.begin() + HeaderBytes, this->Message.end());
    IgtlPose pose;
    if (crc64(body.data(), body.size(), 0) == header.crc &&
        IsPose(ContentOf(body, header.version), pose))
    {
      this->Name = TextOf(header.device_name);
      this->Last = pose;
      this->IsFresh = true;
    }
    else
    {
      ++this->Damaged;
    }
  }
  this->Message.clear();
  this->HasHeader = false;
}

const IgtlPose* IgtlPoses::Newest() noexcept
{
  const IgtlPose* newest = this->IsFresh ? &this->Last : nullptr;
  this->IsFresh = false;
  return newest;
}
} // namespace palpate
