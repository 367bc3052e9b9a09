#include "NearMinima.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr int EvaluationsOfProof = 64;
constexpr std::size_t MostMinima = 4;
} // namespace

// Minima are not merged however near they are.
NearMinima::NearMinima(const ParametricTouchSurface& surface, double reach,
                       double exactness) noexcept
    : Search(&surface.Search()), Reach(reach), Exactness(exactness),
      Clearance(*Search, reach + 0.5 * exactness, 0.5 * exactness, 0.0)
{
}

bool NearMinima::Find(const Vector3& queryWorld, const ClosestPoint& from, int& evaluationsLeft,
                      ClosestPoint& nearest) noexcept
{
  if (this->IsUsedUp)
  {
    return false;
  }
  std::array<ClosestPoint, MostMinima> known;
  known[0] = this->Search->Track(queryWorld, from);
  const double distance = std::abs(known[0].SignedDistance);
  if (!this->IsExact(known[0]) || !(distance < this->Reach))
  {
    return false;
  }
  for (std::size_t count = 1; count <= MostMinima; ++count)
  {
    const auto answer =
        this->Clearance.AskWithin(distance + this->Exactness, queryWorld, known.data(), count,
                                  std::min(evaluationsLeft, EvaluationsOfProof));
    evaluationsLeft -= answer.Evaluations;
    this->IsUsedUp = answer.State == Proof::Finding::Open;
    if (answer.State == Proof::Finding::Clear)
    {
      nearest = *std::min_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count),
                                  [](const ClosestPoint& a, const ClosestPoint& b) {
                                    return std::abs(a.SignedDistance) < std::abs(b.SignedDistance);
                                  });
      return true;
    }
    if (this->IsUsedUp || count == MostMinima || !this->IsExact(answer.Minimum))
    {
      return false;
    }
    known[count] = answer.Minimum;
  }
  return false;
}
} // namespace palpate
