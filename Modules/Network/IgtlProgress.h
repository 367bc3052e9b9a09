#pragma once

#include <cstdint>

namespace palpate
{
/// Whether a peer keeps up with what it is sent, judged by what it has confirmed: bytes or
/// messages. One of them at a time is followed, until it is confirmed.
class IgtlProgress
{
public:
  /// ns until each has to be confirmed.
  explicit IgtlProgress(std::int64_t longest) noexcept : Longest(longest) {}

  /// So many more have been sent at `now` (ns).
  void Sent(std::uint64_t count, std::int64_t now) noexcept;
  /// `unconfirmed`: the last of those sent, which the peer has not confirmed at `now` (ns).
  void Update(std::uint64_t unconfirmed, std::int64_t now) noexcept;

  /// From one that was not confirmed in time until one that was sent later is.
  bool IsBehind() const noexcept { return this->Behind; }

private:
  std::int64_t Longest;
  std::uint64_t Total = 0;
  std::uint64_t Mark = 0;
  std::int64_t MarkTime = 0;
  bool HasMark = false;
  bool Behind = false;
};
} // namespace palpate
