#pragma once

#include "Vector3.h"

#include <Eigen/Geometry>

#include <array>
#include <igtlTransformMessage.h>
#include <string>

namespace palpate::test
{
/// A TRANSFORM message as the protocol's own library packs it.
inline igtl::TransformMessage::Pointer IgtlTransform(const std::string& name, const Vector3& place,
                                                     const Matrix3& turn = Matrix3::Identity())
{
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[row][column] = static_cast<float>(turn(row, column));
    }
    matrix[row][3] = static_cast<float>(place[row]);
  }
  igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
  message->SetDeviceName(name.c_str());
  message->SetMatrix(matrix);
  message->Pack();
  return message;
}
} // namespace palpate::test
