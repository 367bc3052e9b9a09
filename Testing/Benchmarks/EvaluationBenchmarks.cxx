#include "EvaluationBenchmarks.h"

#include "IcosahedronDirections.h"
#include "PolynomialKernelChoice.h"
#include "PolynomialTable.h"
#include "RandomShapes.h"
#include "SphericalHarmonicModel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
using Sample = SphericalHarmonicModel::Sample;

// 4,002 directions in random order, and what each way of evaluating made of them.
class EvaluationCase
{
public:
  EvaluationCase()
      : Directions(IcosahedronDirections(20).Directions()), Fast(MakeModel()),
        Slow(Fast.Degree(), Fast.Coefficients(), Fast.CenterWorld(),
             SphericalHarmonicModel::Formulation::Recurrence),
        Table(Fast.Degree(), Fast.Coefficients(), polynomial::Portable.Lanes),
        FastSamples(Directions.size()), SlowSamples(Directions.size())
  {
    test::Random random(13);
    std::shuffle(this->Directions.begin(), this->Directions.end(), random);
  }

  void Independent()
  {
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      this->FastSamples[i] = this->Fast.Evaluate(this->Directions[i]);
    }
  }
  // Each direction waits for the last result, as in an iterative search.
  void Chained() { Chain(this->Fast, this->FastSamples); }
  void Batch()
  {
    this->Fast.EvaluateBatch(this->Directions.data(), this->Directions.size(),
                             this->FastSamples.data());
  }
  void Portable()
  {
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      polynomial::Portable.Evaluate(this->Table.Data(), this->Fast.Degree(),
                                    this->Directions[i].data(), &this->FastSamples[i].Radius);
    }
  }
  void Recurrence()
  {
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      this->SlowSamples[i] = this->Slow.Evaluate(this->Directions[i]);
    }
  }
  void ChainedRecurrence() { Chain(this->Slow, this->SlowSamples); }

  double Items() const { return static_cast<double>(this->Directions.size()); }

  std::string Disagreement() const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < this->FastSamples.size(); ++i)
    {
      const double value = std::abs(this->FastSamples[i].Radius - this->SlowSamples[i].Radius);
      const double gradient =
          (this->FastSamples[i].SurfaceGradient - this->SlowSamples[i].SurfaceGradient).norm();
      worst = std::isnan(value + gradient) ? INFINITY : std::max({worst, value, gradient});
    }
    // Radii of 20 mm: a few roundings.
    if (worst <= 1e-12)
    {
      return {};
    }
    std::ostringstream text;
    text << "results differ by " << worst << " mm";
    return text.str();
  }

private:
  static SphericalHarmonicModel MakeModel()
  {
    test::Random random(12);
    return test::RandomOrgan(random, 12);
  }

  void Chain(const SphericalHarmonicModel& model, std::vector<Sample>& samples) const
  {
    double last = 0.0;
    for (std::size_t i = 0; i < this->Directions.size(); ++i)
    {
      Vector3 direction = this->Directions[i];
      direction.x() += 0.0 * last;
      samples[i] = model.Evaluate(direction);
      last = samples[i].Radius + samples[i].SurfaceGradient.z();
    }
  }

  std::vector<Vector3> Directions;
  SphericalHarmonicModel Fast;
  SphericalHarmonicModel Slow;
  PolynomialTable Table;
  std::vector<Sample> FastSamples;
  std::vector<Sample> SlowSamples;
};
} // namespace

std::vector<PairedBenchmark> EvaluationBenchmarks()
{
  const auto c = std::make_shared<EvaluationCase>();
  const auto agree = [c] { return c->Disagreement(); };
  const std::string recurrence = "the scalar normalised recurrence";
  return {{"sh/gradient/degree12/chained", recurrence, [c] { c->Chained(); },
           [c] { c->ChainedRecurrence(); }, agree, c->Items()},
          {"sh/gradient/degree12/independent", recurrence, [c] { c->Independent(); },
           [c] { c->Recurrence(); }, agree, c->Items()},
          {"sh/gradient/degree12/batch", recurrence, [c] { c->Batch(); }, [c] { c->Recurrence(); },
           agree, c->Items()},
          {"sh/gradient/degree12/portable", recurrence, [c] { c->Portable(); },
           [c] { c->Recurrence(); }, agree, c->Items()}};
}
} // namespace palpate::bench
