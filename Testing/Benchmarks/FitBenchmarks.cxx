#include "FitBenchmarks.h"

#include "EigenPeers.h"
#include "FitRun.h"
#include "HuberWeights.h"
#include "IcosahedronDirections.h"
#include "MomentSolver.h"
#include "OrthogonalSolver.h"
#include "RadialModelFit.h"
#include "RandomShapes.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Options = RadialModelFitOptions;

constexpr int FitDegree = 12;

// The paper's case: 4,002 directions, degree 12, noise of 0.1 mm; for the robust fit a tenth of the
// samples far off.
class FitCase
{
public:
  explicit FitCase(bool outliers = false) : Moments(FitDegree)
  {
    const IcosahedronDirections sphere(20);
    test::Random random(12);
    const RadialModel organ = test::RandomOrgan(random, FitDegree);
    std::normal_distribution<double> noise(0.0, 0.1);
    const SphericalHarmonicBasis basis(FitDegree);
    this->Samples = {sphere.Directions(), {}, sphere.SolidAngles()};
    const auto rows = static_cast<Eigen::Index>(sphere.Directions().size());
    this->Design.resize(rows, static_cast<Eigen::Index>(basis.Size()));
    std::vector<double> values(basis.Size());
    for (Eigen::Index i = 0; i < rows; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      this->Samples.Radii.push_back(organ.Radius(this->Samples.Directions[at]) + noise(random) +
                                    (outliers && i % 10 == 0 ? 5.0 : 0.0));
      basis.Evaluate(this->Samples.Directions[at], values.data());
      this->Design.row(i) = Eigen::Map<Eigen::RowVectorXd>(values.data(), this->Design.cols());
    }
    this->Radii = Eigen::Map<const Vector>(this->Samples.Radii.data(), rows);
    const std::vector<double> weights = NormalisedWeights(this->Samples.Weights);
    this->Weights = Eigen::Map<const Vector>(weights.data(), rows);
    const Vector scales = this->Weights.cwiseSqrt();
    this->WeightedDesign = scales.asDiagonal() * this->Design;
    this->WeightedRadii = scales.cwiseProduct(this->Radii);
  }

  void FitByMoments(Options::Robust robust = Options::Robust::None)
  {
    this->Fit(this->Moments, robust);
  }

  void FitOrthogonally()
  {
    OrthogonalSolver solver(FitDegree);
    this->Fit(solver, Options::Robust::None);
  }

  void Fit(LeastSquaresSolver& solver, Options::Robust robust)
  {
    Options options;
    options.Degree = FitDegree;
    options.RobustKind = robust;
    this->Outcome = FitRun(this->Samples, options, solver).Run(this->Result);
    this->Ours =
        Eigen::Map<const Vector>(this->Result.Coefficients.data(),
                                 static_cast<Eigen::Index>(this->Result.Coefficients.size()));
  }

  using Method = void (EigenPeers::*)(const double* design, std::ptrdiff_t rows,
                                      std::ptrdiff_t columns, const double* right,
                                      double* solution) const;
  void Solve(const EigenPeers& peers, Method method)
  {
    this->Solution.resize(this->Design.cols());
    (peers.*method)(this->WeightedDesign.data(), this->Design.rows(), this->Design.cols(),
                    this->WeightedRadii.data(), this->Solution.data());
  }

  // Reweighted least squares with the same weights and the same end.
  void SolveRobustly()
  {
    HuberWeights huber({this->Weights.begin(), this->Weights.end()});
    Vector before = NormalEquations(this->WeightedDesign, this->WeightedRadii);
    for (int step = 0; step < 50; ++step)
    {
      const Vector residuals = this->Radii - this->Design * before;
      const std::vector<double> left(residuals.begin(), residuals.end());
      huber.Rescale(left, static_cast<double>(this->Design.cols()), 0.0);
      huber.Update(left);
      const Vector scales =
          this->Weights
              .cwiseProduct(Eigen::Map<const Vector>(huber.Factors().data(), residuals.size()))
              .cwiseSqrt();
      this->Solution =
          NormalEquations(scales.asDiagonal() * this->Design, scales.cwiseProduct(this->Radii));
      if ((this->Solution - before).norm() <= 1e-4 * huber.Scale() * std::sqrt(4.0 * M_PI))
      {
        return;
      }
      before = this->Solution;
    }
  }

  std::string Disagreement(double tolerance) const
  {
    if (!this->Outcome.IsOk())
    {
      return this->Outcome.Message();
    }
    const double difference = (this->Ours - this->Solution).norm() / this->Solution.norm();
    if (difference <= tolerance)
    {
      return {};
    }
    std::ostringstream text;
    text << "coefficients differ by " << difference << " of their size";
    return text.str();
  }

protected:
  static Vector NormalEquations(const Matrix& design, const Vector& right)
  {
    Vector solution(design.cols());
    FastestEigenPeers().NormalEquations(design.data(), design.rows(), design.cols(), right.data(),
                                        solution.data());
    return solution;
  }

  RadialSamples Samples;
  Matrix Design;
  Vector Radii;
  Vector Weights;
  Matrix WeightedDesign;
  Vector WeightedRadii;
  MomentSolver Moments; // keeps its tables from fit to fit
  RadialModelFitResult Result;
  Status Outcome = Status::Failure("the fit did not run");
  Vector Ours = Vector::Zero((FitDegree + 1) * (FitDegree + 1));
  Vector Solution;
};

} // namespace

std::vector<PairedBenchmark> FitBenchmarks()
{
  const auto fit = std::make_shared<FitCase>();
  const auto robust = std::make_shared<FitCase>(true);
  // Eigen is given the matrix; ours makes it.
  const auto solve = [fit](const EigenPeers& (*peers)(), FitCase::Method method)
  { return [fit, peers, method] { fit->Solve(peers(), method); }; };
  const auto orthogonal = [fit] { fit->FitOrthogonally(); };
  const auto moments = [fit] { fit->FitByMoments(); };
  // A condition below 2 and thousands of roundings; the robust ones stop within a ten-thousandth of
  // the noise.
  const auto agree = [fit] { return fit->Disagreement(1e-12); };
  return {{"sh/fit/orthogonal/4002x169", "Eigen HouseholderQR, matrix given", orthogonal,
           solve(FastestEigenPeers, &EigenPeers::Householder), agree},
          {"sh/fit/orthogonal/4002x169/pivoted", "Eigen ColPivHouseholderQR, matrix given",
           orthogonal, solve(FastestEigenPeers, &EigenPeers::PivotedHouseholder), agree},
          {"sh/fit/4002x169", "Eigen normal equations, matrix given", moments,
           solve(FastestEigenPeers, &EigenPeers::NormalEquations), agree},
          {"sh/fit/4002x169/sse2", "Eigen normal equations for SSE2, matrix given", moments,
           solve(PortableEigenPeers, &EigenPeers::NormalEquations), agree},
          {"sh/fit/robust/4002x169", "the same weights with Eigen normal equations",
           [robust] { robust->FitByMoments(Options::Robust::Huber); },
           [robust] { robust->SolveRobustly(); }, [robust] { return robust->Disagreement(1e-6); }}};
}
} // namespace palpate::bench
