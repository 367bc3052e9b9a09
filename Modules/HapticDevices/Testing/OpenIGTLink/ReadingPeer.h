#pragma once

#include "IgtlParser.h"
#include "IgtlTransform.h"
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <igtlStatusMessage.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace palpate::test
{
/// A peer that reads as many forces as a test wants, when it wants. Its system keeps what it has
/// not read.
class ReadingPeer
{
public:
  static constexpr std::size_t ForceBytes = 92;

  /// Connects on this machine; `buffer`: bytes of its receive buffer, 0 for the system's choice.
  ReadingPeer(int port, int buffer) : Socket(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
  {
    if (buffer > 0)
    {
      setsockopt(this->Socket, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    this->IsConnected =
        connect(this->Socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ReadingPeer(const ReadingPeer&) = delete;
  ReadingPeer& operator=(const ReadingPeer&) = delete;
  ~ReadingPeer() { close(this->Socket); }

  void SendPose(const Vector3& place)
  {
    const auto message = IgtlTransform("Stylus", place);
    send(this->Socket, message->GetPackPointer(), static_cast<std::size_t>(message->GetPackSize()),
         MSG_NOSIGNAL);
  }

  /// The x (N) of at most `most` forces, those that are there within `milliseconds`.
  std::vector<double> Read(std::size_t most, int milliseconds)
  {
    std::vector<double> forces;
    pollfd waiting{this->Socket, POLLIN, 0};
    std::array<std::uint8_t, ForceBytes> bytes{};
    while (forces.size() < most && poll(&waiting, 1, milliseconds) == 1)
    {
      const ssize_t count = recv(this->Socket, bytes.data(), bytes.size(), MSG_WAITALL);
      if (count <= 0)
      {
        break;
      }
      this->Parser.Take(bytes.data(), static_cast<std::size_t>(count));
      while (const auto message = this->Parser.Next())
      {
        forces.push_back(First(message->Content));
        if (this->Confirms)
        {
          this->Confirm();
        }
      }
      milliseconds = 0;
    }
    return forces;
  }

  /// Says that it has read a force.
  void Confirm()
  {
    const igtl::StatusMessage::Pointer message = igtl::StatusMessage::New();
    message->SetDeviceName("Force");
    message->SetCode(igtl::StatusMessage::STATUS_OK);
    message->Pack();
    send(this->Socket, message->GetPackPointer(), static_cast<std::size_t>(message->GetPackSize()),
         MSG_NOSIGNAL);
  }

  /// Bytes that its system has and that it has not read.
  std::size_t Waiting() const
  {
    int bytes = 0;
    ioctl(this->Socket, FIONREAD, &bytes);
    return static_cast<std::size_t>(bytes);
  }

  bool IsConnected = false;
  bool Confirms = false; ///< each force that it reads

private:
  // A SENSOR's first number, big-endian, after its length, status and unit.
  static double First(const std::vector<std::uint8_t>& content)
  {
    constexpr std::size_t Before = 10;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof bits; ++i)
    {
      bits = bits << 8U | content.at(Before + i);
    }
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  int Socket;
  IgtlParser Parser{{{"SENSOR", 4096}}};
};
} // namespace palpate::test
