#include "SpaceMouseSource.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr std::size_t MostBytes =
    4096; // 128 events, of which a daemon sends a few hundred a second

int ConnectedTo(const std::string& path)
{
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof(address.sun_path))
  {
    errno = ENAMETOOLONG;
    return -1;
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int made = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (made >= 0 && connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
  {
    const int reason = errno;
    close(made);
    errno = reason;
    return -1;
  }
  return made;
}
} // namespace

std::string SpaceMouseSource::DefaultSocket()
{
  const char* given = std::getenv("SPNAV_SOCKET");
  return given != nullptr && *given != '\0' ? given : "/var/run/spnav.sock";
}

std::string SpaceMouseSource::Problem() const
{
  return "The connection to spacenavd has ended: start it, then open the device again.";
}

Status SpaceMouseSource::Open()
{
  this->Close();
  this->Socket = ConnectedTo(this->Path);
  if (this->Socket < 0)
  {
    const bool isForbidden = errno == EACCES || errno == EPERM;
    return Status::Failure(
        isForbidden ? "The socket of spacenavd at " + this->Path +
                          " may not be used by this user: ask who set it up to allow it."
                    : "spacenavd does not answer at " + this->Path + " (" + std::strerror(errno) +
                          "): install and start it, and plug the SpaceMouse in.");
  }
  this->Events = {};
  return Status::Success();
}

void SpaceMouseSource::Close() noexcept
{
  if (this->Socket >= 0)
  {
    close(this->Socket);
    this->Socket = -1;
  }
}

bool SpaceMouseSource::Read(SteeringInput& input) noexcept
{
  std::array<std::uint8_t, MostBytes> bytes;
  const ssize_t count = recv(this->Socket, bytes.data(), bytes.size(), 0);
  if (count > 0)
  {
    this->Events.Take(bytes.data(), static_cast<std::size_t>(count));
  }
  input = this->Events.Input();
  const bool isEmpty = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
  return count > 0 || isEmpty;
}
} // namespace palpate
