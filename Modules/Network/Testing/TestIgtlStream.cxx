#include "IgtlStream.h"

#include <gtest/gtest.h>

namespace palpate::igtl_stream_test
{
namespace
{
// All of 127.0.0.0/8 is this machine; a stream that is local has 127.0.0.1 only.
TEST(IgtlStream, LocalStreamHasNoOtherAddress)
{
  IgtlStream local;
  ASSERT_TRUE(local.Listen(0, true).IsOk());
  IgtlStream peer;
  EXPECT_FALSE(peer.Connect("127.0.0.2", local.Port()).IsOk());
  EXPECT_TRUE(peer.Connect("127.0.0.1", local.Port()).IsOk());
  IgtlStream open;
  ASSERT_TRUE(open.Listen(0, false).IsOk());
  EXPECT_TRUE(peer.Connect("127.0.0.2", open.Port()).IsOk());
}
} // namespace
} // namespace palpate::igtl_stream_test
