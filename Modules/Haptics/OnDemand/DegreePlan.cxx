#include "DegreePlan.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
using Ordered = std::vector<std::pair<double, std::size_t>>;

// From near to far, those at hand taken to be nearer by `stay`.
Ordered Sorted(const std::vector<DegreeCandidate>& candidates, double stay,
               const std::vector<std::size_t>& chosen,
               const std::function<double(std::size_t)>& distance)
{
  Ordered ordered;
  for (const std::size_t one : chosen)
  {
    ordered.emplace_back(distance(one) - (candidates[one].IsAtHand ? stay : 0.0), one);
  }
  std::sort(ordered.begin(), ordered.end());
  return ordered;
}
} // namespace

DegreeChoice ChooseDegrees(const std::vector<DegreeCandidate>& candidates,
                           const DegreeBounds& bounds,
                           const std::function<double(std::size_t)>& height)
{
  std::vector<std::size_t> wanted;
  std::vector<std::size_t> farther; // and at hand
  std::size_t bytes = 0;
  for (std::size_t one = 0; one < candidates.size(); ++one)
  {
    if (candidates[one].Away <= bounds.Way)
    {
      wanted.push_back(one);
      bytes += candidates[one].Bytes;
    }
    else if (candidates[one].IsAtHand)
    {
      farther.push_back(one);
    }
  }
  DegreeChoice choice;
  const auto away = [&candidates](std::size_t one) { return candidates[one].Away; };
  std::size_t left = bounds.Room;
  const auto fits = [&](std::size_t one)
  {
    const bool isIn = candidates[one].Bytes <= left;
    left -= isIn ? candidates[one].Bytes : 0;
    return isIn;
  };
  const Ordered near = bytes > bounds.Room ? Sorted(candidates, bounds.Stay, wanted, height)
                                           : Sorted(candidates, 0.0, wanted, away);
  const Ordered far = Sorted(candidates, 0.0, farther, away);
  for (const auto& [distance, one] : near)
  {
    const bool isIn = fits(one);
    if (isIn && !candidates[one].IsAtHand)
    {
      choice.Bring.push_back(one);
    }
    else if (!isIn && candidates[one].IsAtHand)
    {
      choice.Drop.push_back(one);
    }
  }
  for (const auto& [distance, one] : far)
  {
    if (!fits(one))
    {
      choice.Drop.push_back(one);
    }
  }
  std::reverse(choice.Drop.begin(), choice.Drop.end());
  return choice;
}
} // namespace palpate
