#pragma once

#include "Clock.h"
#include "Inverse3Address.h"
#include "Inverse3Exchange.h"

#include <memory>

namespace palpate
{
/// A session with Haply's service, on a thread of its own. The service answers each message with
/// one state, so that the servo's forces set the rate; one message is on its way at a time, but 0 N
/// after another force overtakes a reply that is awaited. A force that nothing renews for 20 ms is
/// followed by 0 N.
class Inverse3Client
{
public:
  /// Keeps both addresses, which must outlive it.
  Inverse3Client(Clock& clock, Inverse3Address address, Inverse3Exchange& exchange);
  ~Inverse3Client();

  /// Connects, and learns which devices there are, within two seconds.
  Status Start();
  /// After 0 N.
  void Stop() noexcept;
  /// There is a new command. Servo thread; never waits.
  void Wake() noexcept;
  /// A Minverse. After Start.
  bool IsSmall() const noexcept;

private:
  class Session;
  std::unique_ptr<Session> Running;
};
} // namespace palpate
