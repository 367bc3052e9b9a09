#include "IgtlStream.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr int ConnectMilliseconds = 3000;

Status Failed(const std::string& what)
{
  return Status::Failure(what + ": " + std::strerror(errno) + ".");
}

bool IsConnectedWithin(int socket, int milliseconds)
{
  pollfd waiting{socket, POLLOUT, 0};
  int error = 0;
  socklen_t size = sizeof error;
  if (poll(&waiting, 1, milliseconds) != 1 ||
      getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) != 0)
  {
    errno = ETIMEDOUT;
    return false;
  }
  errno = error;
  return error == 0;
}

bool IsLater()
{
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}
} // namespace

Status IgtlStream::Listen(int port, bool isLocal)
{
  this->Close();
  this->Listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int yes = 1;
  setsockopt(this->Listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(isLocal ? INADDR_LOOPBACK : INADDR_ANY);
  auto* general = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (this->Listener < 0 || bind(this->Listener, general, size) != 0 ||
      listen(this->Listener, 1) != 0 || getsockname(this->Listener, general, &size) != 0)
  {
    const Status failed = Failed("Port " + std::to_string(port) + " cannot be used");
    this->Close();
    return failed;
  }
  this->ListeningPort = ntohs(address.sin_port);
  return Status::Success();
}

Status IgtlStream::Connect(const std::string& host, int port)
{
  this->Close();
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* first = nullptr;
  const int unknown = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &first);
  if (unknown != 0)
  {
    return Status::Failure(host + " is not known: " + gai_strerror(unknown) + ".");
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(first, freeaddrinfo);
  for (const addrinfo* one = first; one != nullptr; one = one->ai_next)
  {
    const int peer = socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (peer >= 0 && (connect(peer, one->ai_addr, one->ai_addrlen) == 0 ||
                      (errno == EINPROGRESS && IsConnectedWithin(peer, ConnectMilliseconds))))
    {
      this->Take(peer);
      return Status::Success();
    }
    const int error = errno;
    close(peer);
    errno = error;
  }
  return Failed(host + " does not answer on port " + std::to_string(port));
}

void IgtlStream::Close() noexcept
{
  this->Leave();
  if (this->Listener >= 0)
  {
    close(this->Listener);
  }
  this->Listener = -1;
}

void IgtlStream::Leave() noexcept
{
  if (this->Peer >= 0)
  {
    close(this->Peer);
  }
  this->Peer = -1;
}

void IgtlStream::Take(int peer) noexcept
{
  const int yes = 1;
  setsockopt(peer, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes); // messages are small and urgent
  if (this->SendBuffer > 0)
  {
    setsockopt(peer, SOL_SOCKET, SO_SNDBUF, &this->SendBuffer, sizeof this->SendBuffer);
  }
  this->Peer = peer;
}

void IgtlStream::Wait(int milliseconds) noexcept
{
  pollfd waiting{this->HasPeer() ? this->Peer : this->Listener, POLLIN, 0};
  if (poll(&waiting, 1, milliseconds) == 1 && !this->HasPeer())
  {
    const int peer = accept4(this->Listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (peer >= 0)
    {
      this->Take(peer);
    }
  }
}

std::ptrdiff_t IgtlStream::Receive(std::uint8_t* bytes, std::size_t most) noexcept
{
  const ssize_t count = recv(this->Peer, bytes, most, 0);
  return count > 0 ? count : count < 0 && IsLater() ? 0 : -1;
}

std::ptrdiff_t IgtlStream::Send(const std::uint8_t* bytes, std::size_t count) noexcept
{
  const ssize_t sent = send(this->Peer, bytes, count, MSG_NOSIGNAL);
  return sent >= 0 ? sent : IsLater() ? 0 : -1;
}

std::size_t IgtlStream::Unconfirmed() const noexcept
{
  int bytes = 0;
  return ioctl(this->Peer, TIOCOUTQ, &bytes) == 0 ? static_cast<std::size_t>(bytes) : 0;
}
} // namespace palpate
