#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace palpate::test
{
/// Whether a condition became true before a deadline, which only a failing test reaches.
inline bool IsSoon(const std::function<bool()>& isTrue,
                   std::chrono::seconds longEnough = std::chrono::seconds(60))
{
  const auto end = std::chrono::steady_clock::now() + longEnough;
  while (!isTrue())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}
} // namespace palpate::test
