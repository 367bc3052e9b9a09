#pragma once

#include "LibusbFalconLink.h"
#include "UsbfsShim.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

namespace palpate::test
{
using Bytes = std::vector<std::uint8_t>;

/// Polls a condition, for longer than any healthy machine needs.
template <typename Condition>
bool Eventually(const Condition& condition)
{
  constexpr std::chrono::seconds Patience(10);
  const auto end = std::chrono::steady_clock::now() + Patience;
  while (!condition())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::yield();
  }
  return true;
}

/// Receives until there are `count` bytes.
inline Bytes ReceiveBytes(FalconLink& link, std::size_t count)
{
  Bytes bytes(count);
  std::size_t length = 0;
  EXPECT_TRUE(Eventually(
      [&]
      {
        length += link.Receive(bytes.data() + length, count - length);
        return length == count;
      }))
      << length << " of " << count;
  bytes.resize(length);
  return bytes;
}

inline bool SendBytes(FalconLink& link, const Bytes& bytes)
{
  return link.Send(bytes.data(), bytes.size());
}

/// Real libusb on a virtual Falcon, in this process and in real time.
struct ShimmedFalcon
{
  ShimmedFalcon()
  {
    // These tests only open descriptors, and machines without USB have nothing else.
    libusb_set_option(nullptr, LIBUSB_OPTION_NO_DEVICE_DISCOVERY);
  }

  VirtualFalcon Model;
  UsbfsFalcon Bus{Model};
  UsbfsShim Node{Bus};
  LibusbFalconLink Link{[this] { return this->Node.Open(); }};
};

/// Boots up to the loader's second stage, in which it echoes its input.
inline void EnterLoader(FalconLink& link)
{
  for (const FtdiRequest request :
       {FtdiRequest::Baud(312, 4), FtdiRequest::EightDataBits(), FtdiRequest::NoFlowControl(),
        FtdiRequest::RequestToSend(false), FtdiRequest::DataTerminalReady(false),
        FtdiRequest::DataTerminalReady(true)})
  {
    const Status status = link.Control(request);
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }
  ASSERT_TRUE(SendBytes(link, {0x0a, 0x43, 0x0d}));
  ASSERT_EQ(ReceiveBytes(link, 4), (Bytes{0x0a, 0x44, 0x2c, 0x0d}));
  ASSERT_TRUE(link.Control(FtdiRequest::DataTerminalReady(false)).IsOk());
  ASSERT_TRUE(link.Control(FtdiRequest::Baud(21)).IsOk());
  ASSERT_TRUE(Eventually([&link] { return link.ClearToSend(); }));
  ASSERT_TRUE(SendBytes(link, {0x41}));
  ASSERT_EQ(ReceiveBytes(link, 1), Bytes{0x41});
}

/// The head of a boot stream and of a first block of `words` words, which must follow.
inline Bytes ImageHead(unsigned words)
{
  Bytes head(28, 0);
  head[0] = 0xaa;
  head[1] = 0x08;
  head[22] = static_cast<std::uint8_t>(words & 0xffU);
  head[23] = static_cast<std::uint8_t>(words >> 8U);
  return head;
}
} // namespace palpate::test
