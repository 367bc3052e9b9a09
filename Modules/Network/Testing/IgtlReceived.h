#pragma once

#include "Vector3.h"

#include <array>
#include <cstring>
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlSensorMessage.h>
#include <igtlTransformMessage.h>
#include <string>

namespace palpate::test
{
/// The next message of a connection, unpacked by the protocol's own library; an empty name when
/// none comes.
struct IgtlReceived
{
  explicit IgtlReceived(igtl::ClientSocket& socket)
  {
    this->Header->InitPack();
    if (socket.Receive(this->Header->GetPackPointer(), this->Header->GetPackSize()) !=
        this->Header->GetPackSize())
    {
      return;
    }
    this->Header->Unpack();
    this->Body.resize(static_cast<std::size_t>(this->Header->GetBodySizeToRead()));
    socket.Receive(this->Body.data(), static_cast<int>(this->Body.size()));
    this->Kind = this->Header->GetDeviceType();
    this->Name = this->Header->GetDeviceName();
  }

  /// Of a TRANSFORM.
  Vector3 Place() const
  {
    igtl::Matrix4x4 matrix;
    this->Unpacked<igtl::TransformMessage>()->GetMatrix(matrix);
    return {matrix[0][3], matrix[1][3], matrix[2][3]};
  }
  /// Of a SENSOR with three values.
  Vector3 Values() const
  {
    const auto message = this->Unpacked<igtl::SensorMessage>();
    return {message->GetValue(0), message->GetValue(1), message->GetValue(2)};
  }
  /// Whether a STRING contains it.
  bool Says(const std::string& text) const { return this->Body.find(text) != std::string::npos; }

  std::string Kind;
  std::string Name;

private:
  template <typename Message>
  typename Message::Pointer Unpacked() const
  {
    typename Message::Pointer message = Message::New();
    message->SetMessageHeader(this->Header);
    message->AllocatePack();
    std::memcpy(message->GetPackBodyPointer(), this->Body.data(), this->Body.size());
    message->Unpack(1);
    return message;
  }

  igtl::MessageHeader::Pointer Header = igtl::MessageHeader::New();
  std::string Body;
};
} // namespace palpate::test
