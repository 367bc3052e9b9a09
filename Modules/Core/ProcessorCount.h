#pragma once

#include <algorithm>
#include <thread>

namespace palpate
{
/// Of this machine; 1 where that is not known.
inline unsigned ProcessorCount()
{
  return std::max(1U, std::thread::hardware_concurrency());
}
} // namespace palpate
