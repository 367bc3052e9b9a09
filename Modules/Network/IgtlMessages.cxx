#include "IgtlMessages.h"

#include <algorithm>
#include <array>
#include <igtlPolyDataMessage.h>
#include <igtlSensorMessage.h>
#include <igtlStringMessage.h>
#include <igtlTimeStamp.h>
#include <igtlTransformMessage.h>
#include <igtlUnit.h>
#include <igtl_unit.h>

namespace palpate
{
namespace
{
std::vector<std::uint8_t> Packed(igtl::MessageBase& message)
{
  const igtl::TimeStamp::Pointer now = igtl::TimeStamp::New();
  now->GetTime();
  igtl::TimeStamp::Pointer stamp = now;
  message.SetTimeStamp(stamp);
  message.Pack();
  const auto* bytes = static_cast<const std::uint8_t*>(message.GetPackPointer());
  return {bytes, bytes + message.GetPackSize()};
}
} // namespace

std::vector<std::uint8_t> IgtlForceMessage(const std::string& name, const PlainVector3& force)
{
  const igtl::SensorMessage::Pointer message = igtl::SensorMessage::New();
  message->SetDeviceName(name.c_str());
  message->SetLength(3);
  const igtl::Unit::Pointer unit = igtl::Unit::New();
  unit->Init();
  unit->Append(IGTL_UNIT_SI_DERIVED_NEWTON, 1);
  message->SetUnit(unit.GetPointer());
  const std::array<double, 3> values{force.X, force.Y, force.Z};
  for (unsigned i = 0; i < 3; ++i)
  {
    message->SetValue(i, values[i]);
  }
  return Packed(*message);
}

std::vector<std::uint8_t> IgtlPlaceMessage(const std::string& name, const PlainVector3& placeWorld)
{
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  matrix[0][3] = static_cast<float>(-placeWorld.X);
  matrix[1][3] = static_cast<float>(-placeWorld.Y);
  matrix[2][3] = static_cast<float>(placeWorld.Z);
  const igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
  message->SetDeviceName(name.c_str());
  message->SetMatrix(matrix);
  return Packed(*message);
}

std::vector<std::uint8_t> IgtlEventMessage(const std::string& text)
{
  std::string copy = text; // the library asks for one that it could change
  const igtl::StringMessage::Pointer message = igtl::StringMessage::New();
  message->SetDeviceName("Event");
  message->SetString(copy);
  return Packed(*message);
}

std::vector<std::uint8_t> IgtlSurfaceMessage(const std::string& name, const IndexedMesh& surface)
{
  const igtl::PolyDataPointArray::Pointer points = igtl::PolyDataPointArray::New();
  for (const Vector3& point : surface.Points)
  {
    points->AddPoint(static_cast<float>(-point.x()), static_cast<float>(-point.y()),
                     static_cast<float>(point.z()));
  }
  const igtl::PolyDataCellArray::Pointer triangles = igtl::PolyDataCellArray::New();
  for (const std::array<int, 3>& corners : surface.Triangles)
  {
    std::array<igtlUint32, 3> cell{};
    std::copy(corners.begin(), corners.end(), cell.begin());
    triangles->AddCell(3, cell.data());
  }
  const igtl::PolyDataMessage::Pointer message = igtl::PolyDataMessage::New();
  message->SetDeviceName(name.c_str());
  message->SetPoints(points.GetPointer());
  message->SetPolygons(triangles.GetPointer());
  return Packed(*message);
}
} // namespace palpate
