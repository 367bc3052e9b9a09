#include "DirectionSlide.h"

#include "SphereMapQuality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr std::uint8_t MostHalvings = 5;
// A fold takes a few passes. Chains of reverts that run on across the mesh end here: nothing moves.
constexpr int MostPasses = 64;

using Triangles = std::vector<std::array<int, 3>>;

double DeterminantOf(const std::vector<Vector3>& directions, const std::array<int, 3>& t)
{
  return SphericalDeterminant(directions[static_cast<std::size_t>(t[0])],
                              directions[static_cast<std::size_t>(t[1])],
                              directions[static_cast<std::size_t>(t[2])]);
}

Vector3 Along(const Vector3& direction, const Vector3& step)
{
  const double angle = step.norm();
  return angle > 0.0 ? (std::cos(angle) * direction + (std::sin(angle) / angle) * step).normalized()
                     : direction;
}

// Steps of one call and how often each was halved.
class GuardedSlide
{
public:
  GuardedSlide(const std::vector<Vector3>& directions, const std::vector<Vector3>& steps,
               double longestStep)
      : Start(directions), Moved(directions), Steps(steps), Halvings(steps.size(), 0),
        Changed(steps.size(), 1)
  {
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      Vector3& step = this->Steps[i];
      step -= step.dot(directions[i]) * directions[i];
      const double length = step.norm();
      step *= length > longestStep ? longestStep / length : 1.0;
      this->Moved[i] = Along(directions[i], step);
    }
  }

  // False once nothing is left to mend.
  bool Mend(const Triangles& triangles, double leastShare)
  {
    std::vector<char> tooFar(this->Steps.size(), 0);
    bool any = false;
    for (const std::array<int, 3>& t : triangles)
    {
      const bool touched = this->Changed[static_cast<std::size_t>(t[0])] != 0 ||
                           this->Changed[static_cast<std::size_t>(t[1])] != 0 ||
                           this->Changed[static_cast<std::size_t>(t[2])] != 0;
      if (touched && DeterminantOf(this->Moved, t) < leastShare * DeterminantOf(this->Start, t))
      {
        any = true;
        for (const int corner : t)
        {
          tooFar[static_cast<std::size_t>(corner)] = 1;
        }
      }
    }
    for (std::size_t i = 0; any && i < tooFar.size(); ++i)
    {
      this->Changed[i] = tooFar[i];
      if (tooFar[i] != 0)
      {
        this->Shorten(i);
      }
    }
    return any;
  }

  void RevertAll()
  {
    this->Moved = this->Start;
    std::fill(this->Halvings.begin(), this->Halvings.end(), std::uint8_t{MostHalvings + 1});
  }

  DirectionSlide Report() const
  {
    DirectionSlide report;
    for (std::size_t i = 0; i < this->Steps.size(); ++i)
    {
      const bool wished = this->Halvings[i] > 0;
      const bool reverted = this->Halvings[i] > MostHalvings;
      report.Halved += wished && !reverted ? 1 : 0;
      report.Reverted += reverted ? 1 : 0;
    }
    return report;
  }

  std::vector<Vector3>& Result() noexcept { return this->Moved; }

private:
  void Shorten(std::size_t i)
  {
    Vector3& step = this->Steps[i];
    if (this->Halvings[i] > MostHalvings || step.isZero(0.0))
    {
      return;
    }
    ++this->Halvings[i];
    step *= this->Halvings[i] > MostHalvings ? 0.0 : 0.5;
    this->Moved[i] = Along(this->Start[i], step);
  }

  const std::vector<Vector3>& Start;
  std::vector<Vector3> Moved;
  std::vector<Vector3> Steps;
  std::vector<std::uint8_t> Halvings;
  std::vector<char> Changed;
};

bool AreFinite(const std::vector<Vector3>& vectors)
{
  return std::all_of(vectors.begin(), vectors.end(),
                     [](const Vector3& v) { return v.allFinite(); });
}
} // namespace

Status SlideDirections(const std::vector<std::array<int, 3>>& triangles,
                       const std::vector<Vector3>& steps, double longestStep, double leastShare,
                       std::vector<Vector3>& directions, DirectionSlide& slide)
{
  if (steps.size() != directions.size() || !AreFinite(steps))
  {
    return Status::Failure("Every direction needs one finite step.");
  }
  GuardedSlide guarded(directions, steps, longestStep);
  int passes = 0;
  while (guarded.Mend(triangles, leastShare) && passes < MostPasses)
  {
    ++passes;
  }
  if (passes == MostPasses)
  {
    guarded.RevertAll();
  }
  if (!IsBijective(triangles, guarded.Result()))
  {
    return Status::Failure("The parametrisation is not one to one.");
  }
  directions = std::move(guarded.Result());
  slide = guarded.Report();
  return Status::Success();
}
} // namespace palpate
