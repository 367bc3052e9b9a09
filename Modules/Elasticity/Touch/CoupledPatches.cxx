#include "CoupledPatches.h"

#include "ElasticPatch.h"
#include "Units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
class Solver
{
public:
  Solver(const ComplianceAtlas& atlas, const RadialModel& model, const CoupledPatches::Wall* walls,
         std::size_t count, double ballRadius) noexcept
      : Count(std::min(count, CoupledPatches::MostWalls)), Ball(ballRadius), Width(0.5 * ballRadius)
  {
    std::array<CoupledPatches::Wall, CoupledPatches::MostWalls> ordered;
    // Deepest first, so that the result does not depend on the order.
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      auto* const end = ordered.data() + i;
      auto* const place =
          std::upper_bound(ordered.data(), end, walls[i],
                           [](const CoupledPatches::Wall& a, const CoupledPatches::Wall& b)
                           { return a.Depth > b.Depth; });
      std::move_backward(place, end, end + 1);
      *place = walls[i];
    }
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Patches[i] =
          ElasticPatch(atlas, model, ordered[i].Direction, ordered[i].Depth, ballRadius);
      this->Gaps[i] = ordered[i].Gap;
      for (std::size_t j = 0; j < i; ++j)
      {
        this->Couplings[i][j] = this->Couplings[j][i] = this->CouplingOf(i, j).Value;
      }
    }
  }

  // Gauss and Seidel: a patch moves others by a fraction of what it moves itself.
  void Solve() noexcept
  {
    constexpr int MostRounds = 30;
    constexpr double Tolerance = 1e-12;
    bool isDone = false;
    for (int round = 0; round < MostRounds && !isDone; ++round)
    {
      isDone = true;
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        double depth = this->Patches[i].Depth();
        for (std::size_t j = 0; j < this->Count; ++j)
        {
          depth -= i != j ? this->Couplings[i][j] * this->ForceOf(j) : 0.0;
        }
        const double before = this->ForceOf(i);
        this->Patches[i].Press(std::max(0.0, depth), this->Patches[i].Contact().PatchRadius);
        const double change = std::abs(this->ForceOf(i) - before);
        isDone = isDone && change <= Tolerance * (1.0 + this->ForceOf(i));
      }
    }
  }

  void Tell(PressedPlace* places) const noexcept
  {
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      places[i] = {this->Patches[i].Point().normalized(), this->ForceOf(i),
                   this->Patches[i].Contact().PatchRadius};
    }
  }

  ElasticForce Sum() const noexcept
  {
    ElasticForce sum;
    std::array<double, CoupledPatches::MostWalls> slopes{};
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        sum.Energy += this->ForceOf(i) * this->ForceOf(j) * this->Couplings[i][j];
      }
      const ElasticForce one = this->Patches[i].ForceOfHeldBall();
      sum.ForceWorld += one.ForceWorld;
      sum.Energy += one.Energy;
      sum.PatchRadius = std::max(sum.PatchRadius, one.PatchRadius);
      sum.IsValid = sum.IsValid && one.IsValid;
      slopes[i] = one.Slope;
    }
    const double size = sum.ForceWorld.norm();
    for (std::size_t i = 0; i < this->Count && size > 0.0; ++i)
    {
      const double along = this->Patches[i].Normal().dot(sum.ForceWorld) / size;
      sum.Slope += slopes[i] * along * along;
    }
    return sum;
  }

  // Slope of the energy by the place where the walls hold the ball, with which the patches move and
  // their normals turn; the ball itself stays.
  Vector3 SlopeByHeldPlace(const Vector3& push) const noexcept
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const ElasticPatch& patch = this->Patches[i];
      Vector3 slope = patch.EnergySlope() + this->ForceOf(i) * patch.Bent(push);
      for (std::size_t j = 0; j < this->Count; ++j)
      {
        slope -= i != j
                     ? Vector3(this->ForceOf(i) * this->ForceOf(j) * this->CouplingOf(i, j).Slope)
                     : Vector3::Zero();
      }
      sum += patch.Followed(slope, this->Distance(i));
    }
    return sum;
  }

private:
  // mm/N, and its slope by the place of the first patch.
  struct Coupling
  {
    double Value;
    Vector3 Slope;
  };

  double ForceOf(std::size_t i) const noexcept { return this->Patches[i].Contact().Force; }
  // Of a wall from where the walls hold the ball's centre, mm.
  double Distance(std::size_t i) const noexcept { return this->Ball + this->Gaps[i]; }

  Coupling CouplingOf(std::size_t i, std::size_t j) const noexcept
  {
    const ElasticPatch& one = this->Patches[i];
    const ElasticPatch& other = this->Patches[j];
    // c(D)/c(0) of a half-space is q erf(x/s)/x with x = D/a: 1 for x = 0, and far away that of
    // two points, 5/(3 pi x).
    constexpr double Far = 5.0 / (3.0 * Pi);
    constexpr double Least = 1e-6;
    const double spread = 2.0 * Far / std::sqrt(Pi);
    const Vector3 across = one.Point() - other.Point();
    const double x = std::max(Least, across.norm() / this->Width);
    const double share = Far * std::erf(x / spread) / x;
    const double fall =
        2.0 * Far / (std::sqrt(Pi) * spread) * std::exp(-x * x / (spread * spread)) / x - share / x;
    const double half = 0.5 * (1.0 + one.Normal().dot(other.Normal()));
    const double facing = half * half * half;
    const double facingSlope = 1.5 * half * half;
    const double whole =
        0.5 * (one.Softness(this->Width) + other.Softness(this->Width)) / this->Width;
    return {whole * facing * share,
            whole * facing * fall / (x * this->Width * this->Width) * across +
                facingSlope * whole * share * one.Bent(other.Normal()) +
                0.5 * facing * share / this->Width * one.SoftnessSlope(this->Width)};
  }

  std::size_t Count;
  double Ball;  // mm
  double Width; // of the bumps whose coupling is taken, mm
  std::array<ElasticPatch, CoupledPatches::MostWalls> Patches;
  std::array<double, CoupledPatches::MostWalls> Gaps{};
  std::array<std::array<double, CoupledPatches::MostWalls>, CoupledPatches::MostWalls> Couplings{};
};
} // namespace

ElasticForce CoupledPatches::Of(const ComplianceAtlas& atlas, const RadialModel& model,
                                const Wall* walls, std::size_t count, double ballRadius,
                                const Hold& hold, PressedPlace* places) noexcept
{
  constexpr double MostLateral = 0.5; // of the push
  Solver solver(atlas, model, walls, count, ballRadius);
  solver.Solve();
  if (places != nullptr)
  {
    solver.Tell(places);
  }
  ElasticForce force = solver.Sum();
  const Vector3 lateral = -(hold.Motion * solver.SlopeByHeldPlace(hold.Push));
  const double size = lateral.norm();
  const double most = MostLateral * force.ForceWorld.norm();
  force.IsValid = force.IsValid && size <= most;
  force.ForceWorld += size > most ? Vector3(most / size * lateral) : lateral;
  return force;
}
} // namespace palpate
