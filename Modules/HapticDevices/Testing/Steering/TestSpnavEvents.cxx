#include "SpnavEvents.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace palpate::spnav_events_test
{
namespace
{
std::vector<std::uint8_t> Bytes(const std::array<std::int32_t, 8>& event)
{
  std::vector<std::uint8_t> bytes(sizeof(event));
  std::memcpy(bytes.data(), event.data(), bytes.size());
  return bytes;
}

TEST(SpnavEvents, AxesAreRightUpAndTowardsThePerson)
{
  SpnavEvents events;
  const auto bytes = Bytes({0, 350, 35, 70, -35, 0, 700, 16});
  events.Take(bytes.data(), bytes.size());
  EXPECT_EQ(Vector3(events.Input().Push), Vector3(1.0, 0.1, -0.2));
  EXPECT_EQ(Vector3(events.Input().Turn), Vector3(-0.1, 0.0, -1.0)) << "no more than full";
}

TEST(SpnavEvents, ButtonsAreHeldUntilReleased)
{
  SpnavEvents events;
  for (const auto& event :
       {std::array<std::int32_t, 8>{1, 0}, {1, 3}, {2, 0}, {1, 32}, {1, -1}, {77, 1}})
  {
    const auto bytes = Bytes(event);
    events.Take(bytes.data(), bytes.size());
  }
  EXPECT_EQ(events.Input().Buttons, 8u);
}

TEST(SpnavEvents, PiecesOfAnyLengthGiveTheSame)
{
  std::mt19937 random(3);
  std::vector<std::uint8_t> all;
  for (int n = 0; n < 50; ++n)
  {
    std::array<std::int32_t, 8> event;
    for (auto& word : event)
    {
      word = static_cast<std::int32_t>(random());
    }
    event[0] = static_cast<std::int32_t>(random() % 4);
    const auto bytes = Bytes(event);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  SpnavEvents whole;
  whole.Take(all.data(), all.size());
  SpnavEvents pieces;
  for (std::size_t at = 0; at < all.size();)
  {
    const std::size_t count = std::min<std::size_t>(1 + random() % 70, all.size() - at);
    pieces.Take(all.data() + at, count);
    at += count;
  }
  EXPECT_EQ(Vector3(pieces.Input().Push), Vector3(whole.Input().Push));
  EXPECT_EQ(Vector3(pieces.Input().Turn), Vector3(whole.Input().Turn));
  EXPECT_EQ(pieces.Input().Buttons, whole.Input().Buttons);
}
} // namespace
} // namespace palpate::spnav_events_test
