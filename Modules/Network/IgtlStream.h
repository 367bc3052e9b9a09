#pragma once

#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace palpate
{
/// A TCP connection to one peer, which either side may have begun. Nothing blocks but Listen's and
/// Connect's few system calls. For one thread.
class IgtlStream
{
public:
  IgtlStream() = default;
  /// With a send buffer of about so many bytes for what the peer's system has not confirmed; the
  /// system rounds it up.
  explicit IgtlStream(int sendBuffer) : SendBuffer(sendBuffer) {}
  IgtlStream(const IgtlStream&) = delete;
  IgtlStream& operator=(const IgtlStream&) = delete;
  ~IgtlStream() { this->Close(); }

  /// Waits for a peer on a port of this machine; 0: any free one. `isLocal`: only for peers on this
  /// machine.
  Status Listen(int port, bool isLocal);
  /// Connects to a peer that listens; fails after three seconds.
  Status Connect(const std::string& host, int port);
  void Close() noexcept;
  /// Ends the connection; a stream that listens waits for the next peer.
  void Leave() noexcept;

  /// The port that is listened on.
  int Port() const noexcept { return this->ListeningPort; }
  bool HasPeer() const noexcept { return this->Peer >= 0; }

  /// Waits until something arrives, for at most `milliseconds`, and takes a peer that connects.
  void Wait(int milliseconds) noexcept;
  /// The bytes that have arrived, up to `most`; 0 if there are none, less than 0 if the connection
  /// has ended.
  std::ptrdiff_t Receive(std::uint8_t* bytes, std::size_t most) noexcept;
  /// Sends what can be sent now; less than 0 if the connection has ended.
  std::ptrdiff_t Send(const std::uint8_t* bytes, std::size_t count) noexcept;
  /// Bytes of those sent that the peer's system has not confirmed yet.
  std::size_t Unconfirmed() const noexcept;

private:
  void Take(int peer) noexcept;

  int Listener = -1;
  int Peer = -1;
  int ListeningPort = 0;
  int SendBuffer = 0; ///< 0: the system's own choice
};
} // namespace palpate
