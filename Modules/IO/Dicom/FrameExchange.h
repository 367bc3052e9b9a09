#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <sys/socket.h>
#include <sys/types.h>

/// Protocol between a DicomFrameDecoder and palpate-dicom-decoder, over a local socket: the client
/// sends a request and its stream, the decoder answers with the samples. A decoder that refuses a
/// frame exits instead.
namespace palpate
{
struct FrameRequest
{
  enum class Codec : std::uint32_t
  {
    RunLength,
    Jpeg,
    JpegLs
  };
  Codec Coding = Codec::RunLength;
  std::uint32_t Columns = 0; ///< 1 to 65,535, as Rows
  std::uint32_t Rows = 0;
  std::uint32_t BytesPerSample = 0; ///< of the answer: 1, 2 or (run-length) 4, little-endian
  std::uint32_t Precision = 0;      ///< bits per sample
  std::uint32_t StreamBytes = 0;

  std::size_t SampleBytes() const
  {
    return static_cast<std::size_t>(this->Columns) * this->Rows * this->BytesPerSample;
  }
};

/// Returns false if the peer has closed the socket.
inline bool SendAll(int socket, const void* bytes, std::size_t count)
{
  const char* next = static_cast<const char*>(bytes);
  while (count > 0)
  {
    const ssize_t sent = send(socket, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR)
    {
      return false;
    }
    const auto done = static_cast<std::size_t>(sent < 0 ? 0 : sent);
    next += done;
    count -= done;
  }
  return true;
}

/// Returns false if the peer closes the socket before `count` bytes.
inline bool ReceiveAll(int socket, void* bytes, std::size_t count)
{
  char* next = static_cast<char*>(bytes);
  while (count > 0)
  {
    const ssize_t received = recv(socket, next, count, 0);
    if (received == 0 || (received < 0 && errno != EINTR))
    {
      return false;
    }
    const auto done = static_cast<std::size_t>(received < 0 ? 0 : received);
    next += done;
    count -= done;
  }
  return true;
}
} // namespace palpate
