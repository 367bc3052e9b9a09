#pragma once

#include "IgtlImage.h"
#include "IgtlParser.h"
#include "IgtlPeer.h"
#include "IgtlStream.h"
#include "IgtlTouch.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// A connection by OpenIGTLink over which images and label maps arrive, and to which messages with
/// models and the course of a touch are sent; every peer that connects gets all models again. A
/// thread of its own talks to the peer. While two images wait to be taken, nothing is received, so
/// the peer has to wait.
class IgtlLink
{
public:
  /// Of a message with an image; longer ones are named when they begin, and skipped.
  static constexpr std::uint64_t MostImageBytes = std::uint64_t{1} << 30U;

  IgtlLink() = default;
  IgtlLink(const IgtlLink&) = delete;
  IgtlLink& operator=(const IgtlLink&) = delete;
  ~IgtlLink() { this->Close(); }

  /// Port 0 means any free one.
  Status Open(const IgtlPeer& peer);
  /// Returns after at most 50 ms.
  void Close() noexcept;

  /// The port that is listened on while it is open.
  int Port() const noexcept { return this->Stream.Port(); }
  bool HasPeer() const noexcept { return this->IsConnected.load(); }
  /// Whether it connected to a peer that is gone now, or one that does not speak OpenIGTLink. A
  /// link that listens goes on.
  bool HasEnded() const noexcept { return this->IsOver.load(); }

  /// The messages (IgtlSurfaceMessage) that every peer gets, in place of the former ones; one that
  /// is connected gets them now.
  void Offer(std::vector<std::vector<std::uint8_t>> messages);
  /// Tells the peer of a touch (IgtlTouchMessages), up to 100 times a second: of ticks that the
  /// connection cannot take, only the newest is kept.
  void Show(const IgtlTouch& now);
  /// Tells it that the touch has ended, with a force of 0 N.
  void EndTouch();
  /// Whether the peer, if there is one, has been sent all that was offered and shown.
  bool IsAllSent() const noexcept { return this->IsSent.load(); }

  /// The oldest image that was not taken yet; none if there is none.
  std::optional<IgtlImage> TakeImage();
  /// What was wrong with messages and peers since the last call, as sentences.
  std::vector<std::string> TakeProblems();

private:
  void Run();
  void Exchange();
  bool Receive();
  bool Send();
  bool PrepareNext();
  void BeginPeer();
  void EndPeer(const char* problem);
  bool IsFull();
  void Report(const std::string& problem);

  IgtlPeer Peer;
  std::atomic<bool> MustEnd{false};
  std::atomic<bool> IsConnected{false};
  std::atomic<bool> IsOver{false};
  std::atomic<bool> IsSent{true};

  std::mutex Mutex; ///< of the following six
  std::deque<IgtlImage> Images;
  std::vector<std::string> Problems;
  std::vector<std::vector<std::uint8_t>> Offers;
  std::size_t NextOffer = 0; ///< the first that the peer has not got
  std::optional<IgtlTouch> Newest;
  bool IsNewestSent = true;

  // Of the thread while it runs.
  IgtlStream Stream;
  std::optional<IgtlParser> Parser;
  std::vector<std::uint8_t> Arrived;
  std::vector<std::uint8_t> Sending;
  std::size_t SentBytes = 0;
  IgtlTouch Told; ///< the last that was sent
  std::thread Thread;
};
} // namespace palpate
