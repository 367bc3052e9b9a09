#pragma once

#include "SpnavEvents.h"

#include <atomic>

namespace palpate
{
/// A six-axis cap by spacenavd: a client of its socket. Reads what waits, never more.
class SpaceMouseSource final : public SteeringSource
{
public:
  /// Where the daemon's clients look for it: $SPNAV_SOCKET, else its usual place.
  static std::string DefaultSocket();

  explicit SpaceMouseSource(std::string socket) : Path(std::move(socket)) {}
  ~SpaceMouseSource() override { this->SpaceMouseSource::Close(); }

  std::string Name() const override { return "SpaceMouse"; }
  int Buttons() const override { return 2; }
  std::string Problem() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(SteeringInput& input) noexcept override;

private:
  std::string Path;
  int Socket = -1;
  SpnavEvents Events;
};
} // namespace palpate
