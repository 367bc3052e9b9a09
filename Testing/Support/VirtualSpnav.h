#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace palpate::test
{
/// Stands for spacenavd: a socket that takes clients, and sends what a test says.
class VirtualSpnav
{
public:
  explicit VirtualSpnav(const std::string& path)
  {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    this->Listening = socket(AF_UNIX, SOCK_STREAM, 0);
    EXPECT_EQ(bind(this->Listening, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(listen(this->Listening, 4), 0);
  }
  ~VirtualSpnav() { this->End(); }

  void Accept() { this->Client = accept(this->Listening, nullptr, nullptr); }
  void Send(const std::array<std::int32_t, 8>& event)
  {
    EXPECT_EQ(send(this->Client, event.data(), sizeof(event), 0),
              static_cast<ssize_t>(sizeof(event)));
  }
  void End()
  {
    for (int* open : {&this->Client, &this->Listening})
    {
      if (*open >= 0)
      {
        close(*open);
        *open = -1;
      }
    }
  }

private:
  int Listening = -1;
  int Client = -1;
};
} // namespace palpate::test
