#include "CoupledPatches.h"

#include "ElasticPatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

class Solver
{
public:
  Solver(const ComplianceAtlas& atlas, const SphericalHarmonicModel& model,
         const CoupledPatches::Wall* walls, std::size_t count, double ballRadius) noexcept
      : Count(std::min(count, CoupledPatches::MostWalls)), Width(0.5 * ballRadius)
  {
    std::array<CoupledPatches::Wall, CoupledPatches::MostWalls> ordered;
    std::copy_n(walls, this->Count, ordered.begin());
    // So that the result does not depend on the order.
    std::sort(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(this->Count),
              [](const CoupledPatches::Wall& a, const CoupledPatches::Wall& b)
              { return a.Depth > b.Depth; });
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Patches[i] =
          ElasticPatch(atlas, model, ordered[i].Direction, ordered[i].Depth, ballRadius);
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
          depth -= i != j ? this->Coupling(i, j).Compliance * this->ForceOf(j) : 0.0;
        }
        const double before = this->ForceOf(i);
        this->Patches[i].Press(std::max(0.0, depth), this->Patches[i].Contact().PatchRadius);
        const double change = std::abs(this->ForceOf(i) - before);
        isDone = isDone && change <= Tolerance * (1.0 + this->ForceOf(i));
      }
    }
  }

  ElasticForce Sum() const noexcept
  {
    ElasticForce sum;
    std::array<double, CoupledPatches::MostWalls> slopes{};
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      Vector3 energySlope = Vector3::Zero(); // by the place of patch i
      for (std::size_t j = 0; j < this->Count; ++j)
      {
        if (i != j)
        {
          const Pair pair = this->Coupling(i, j);
          const double product = this->ForceOf(i) * this->ForceOf(j);
          energySlope -= product * pair.Slope;
          sum.Energy += i < j ? product * pair.Compliance : 0.0;
        }
      }
      const ElasticForce one = this->Patches[i].Force(energySlope);
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

private:
  struct Pair
  {
    double Compliance; // c_ij, mm/N
    Vector3 Slope;     // of it by the place of patch i on its surface, 1/N
  };

  double ForceOf(std::size_t i) const noexcept { return this->Patches[i].Contact().Force; }

  Pair Coupling(std::size_t i, std::size_t j) const noexcept
  {
    const ElasticPatch& one = this->Patches[i];
    const ElasticPatch& other = this->Patches[j];
    const Vector3 between = one.Point() - other.Point();
    const double distance = std::max(between.norm(), 1e-6 * this->Width);
    // c(D)/c(0) of a half-space is q erf(x/s)/x with x = D/a: 1 for x = 0, and far away that of
    // two points, 5/(3 pi x).
    constexpr double Far = 5.0 / (3.0 * Pi);
    const double spread = 2.0 * Far / std::sqrt(Pi);
    const double x = distance / this->Width;
    const double share = Far * std::erf(x / spread) / x;
    const double shareSlope =
        (2.0 * Far / (std::sqrt(Pi) * spread) * std::exp(-x * x / (spread * spread)) - share) / x;
    const double facing = 0.5 * (1.0 + one.Normal().dot(other.Normal()));
    const double whole =
        0.5 * (one.Softness(this->Width) + other.Softness(this->Width)) / this->Width;
    Pair pair{whole * share * facing,
              whole * facing * shareSlope / this->Width / distance * between};
    // The normal turns by the curvature times the way.
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Vector3& along = one.Shape().Directions[k];
      pair.Slope +=
          0.5 * whole * share * one.Shape().Principal[k] * other.Normal().dot(along) * along;
    }
    return pair;
  }

  std::size_t Count;
  double Width; // of the bumps whose coupling is taken, mm
  std::array<ElasticPatch, CoupledPatches::MostWalls> Patches;
};
} // namespace

ElasticForce CoupledPatches::Of(const ComplianceAtlas& atlas, const SphericalHarmonicModel& model,
                                const Wall* walls, std::size_t count, double ballRadius) noexcept
{
  Solver solver(atlas, model, walls, count, ballRadius);
  solver.Solve();
  return solver.Sum();
}
} // namespace palpate
