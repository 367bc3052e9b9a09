#include "RingBuffer.h"

#include <gtest/gtest.h>

#include <thread>

namespace palpate::ring_buffer_test
{
namespace
{
TEST(RingBuffer, KeepsOrderAndCountsDrops)
{
  RingBuffer<int> buffer(3);
  int value = 0;
  EXPECT_FALSE(buffer.Pop(value));
  for (int round = 0; round < 5; ++round)
  {
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_EQ(buffer.Push(i), i < 3);
    }
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_TRUE(buffer.Pop(value));
      EXPECT_EQ(value, i);
    }
    EXPECT_FALSE(buffer.Pop(value));
  }
  EXPECT_EQ(buffer.Dropped(), 10u);
}

TEST(RingBuffer, HasCapacityOfAtLeastOne)
{
  RingBuffer<int> buffer(0);
  EXPECT_TRUE(buffer.Push(1));
  EXPECT_FALSE(buffer.Push(2));
}

TEST(RingBuffer, DeliversOrCountsEveryValueOnce)
{
  constexpr int count = 100'000;
  RingBuffer<int> buffer(64);
  std::atomic<bool> isDone{false};
  std::thread writer(
      [&]
      {
        for (int i = 0; i < count; ++i)
        {
          buffer.Push(i);
        }
        isDone.store(true, std::memory_order_release);
      });
  int received = 0;
  int last = -1;
  bool isOrdered = true;
  for (bool wasDone = false; !wasDone;)
  {
    // Read before popping: values pushed before the end are then popped below.
    wasDone = isDone.load(std::memory_order_acquire);
    for (int value = 0; buffer.Pop(value); ++received)
    {
      isOrdered = isOrdered && value > last;
      last = value;
    }
  }
  writer.join();
  EXPECT_TRUE(isOrdered);
  EXPECT_EQ(static_cast<std::uint64_t>(received) + buffer.Dropped(), std::uint64_t{count});
}
} // namespace
} // namespace palpate::ring_buffer_test
