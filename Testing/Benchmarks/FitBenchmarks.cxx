#include "FitBenchmarks.h"

#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicFit.h"

#include <Eigen/QR>
#include <algorithm>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
// The paper's case: 4,002 directions, degree 12.
class FitCase
{
public:
  FitCase()
  {
    const IcosahedronDirections sphere(20);
    test::Random random(12);
    const SphericalHarmonicModel organ = test::RandomOrgan(random, 12);
    std::normal_distribution<double> noise(0.0, 0.1);
    const SphericalHarmonicBasis basis(Degree);
    this->Samples = {sphere.Directions(), {}, sphere.SolidAngles()};
    const auto rows = static_cast<Eigen::Index>(sphere.Directions().size());
    this->WeightedDesign.resize(rows, static_cast<Eigen::Index>(basis.Size()));
    this->WeightedRadii.resize(rows);
    std::vector<double> values(basis.Size());
    for (Eigen::Index i = 0; i < rows; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      this->Samples.Radii.push_back(organ.Radius(this->Samples.Directions[at]) + noise(random));
      basis.Evaluate(this->Samples.Directions[at], values.data());
      const double scale = std::sqrt(this->Samples.Weights[at]);
      this->WeightedDesign.row(i) =
          scale * Eigen::Map<Eigen::RowVectorXd>(values.data(), this->WeightedDesign.cols());
      this->WeightedRadii[i] = scale * this->Samples.Radii[at];
    }
  }

  void Fit()
  {
    SphericalHarmonicFitOptions options;
    options.Degree = Degree;
    this->Outcome = FitSphericalHarmonics(this->Samples, options, this->Result);
  }

  void SolveWithEigen()
  {
    this->Solution = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(this->WeightedDesign)
                         .solve(this->WeightedRadii);
  }

  std::string Disagreement() const
  {
    if (!this->Outcome.IsOk())
    {
      return this->Outcome.Message();
    }
    const Eigen::Map<const Eigen::VectorXd> ours(this->Result.Coefficients.data(),
                                                 this->Solution.size());
    const double difference = (ours - this->Solution).norm() / this->Solution.norm();
    // A condition below 2 and thousands of roundings.
    if (difference <= 1e-12)
    {
      return {};
    }
    std::ostringstream text;
    text << "coefficients differ by " << difference << " of their size";
    return text.str();
  }

private:
  static constexpr int Degree = 12;
  RadialSamples Samples;
  Eigen::MatrixXd WeightedDesign;
  Eigen::VectorXd WeightedRadii;
  SphericalHarmonicFitResult Result;
  Status Outcome = Status::Failure("the fit did not run");
  Eigen::VectorXd Solution;
};
} // namespace

std::vector<PairedBenchmark> FitBenchmarks()
{
  const auto fit = std::make_shared<FitCase>();
  return {{"sh/fit/4002x169", "Eigen ColPivHouseholderQR of the same matrix", [fit] { fit->Fit(); },
           [fit] { fit->SolveWithEigen(); }, [fit] { return fit->Disagreement(); }}};
}
} // namespace palpate::bench
