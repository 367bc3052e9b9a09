#pragma once

#include <deque>
#include <utility>

namespace palpate
{
/// Adds a kind, or replaces the one of its name. Addresses of the others stay valid.
template <typename Kind>
void AddOrReplace(std::deque<Kind>& kinds, Kind kind)
{
  for (Kind& one : kinds)
  {
    if (one.Name == kind.Name)
    {
      one = std::move(kind);
      return;
    }
  }
  kinds.push_back(std::move(kind));
}
} // namespace palpate
