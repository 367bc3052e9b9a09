#include "ComplianceAtlas.h"

#include "ComplianceSampler.h"
#include "IcosahedronDirections.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
// Least squares over directions all round, three for each harmonic.
struct MapFit
{
  explicit MapFit(int degree)
      : Basis(degree), Directions(static_cast<int>(
                           std::ceil(std::sqrt(0.3 * static_cast<double>(Basis.Size()))) + 1.0))
  {
  }

  Eigen::MatrixXd Solve(const Eigen::MatrixXd& values) const
  {
    const std::vector<Vector3>& directions = this->Directions.Directions();
    const std::vector<double> weights = this->Directions.SolidAngles();
    const auto size = static_cast<Eigen::Index>(this->Basis.Size());
    Eigen::MatrixXd rows(size, values.rows()); // transposed
    Eigen::MatrixXd weighted = values;
    for (Eigen::Index i = 0; i < values.rows(); ++i)
    {
      const double root = std::sqrt(weights[static_cast<std::size_t>(i)]);
      this->Basis.Evaluate(directions[static_cast<std::size_t>(i)], rows.col(i).data());
      rows.col(i) *= root;
      weighted.row(i) *= root;
    }
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(rows);
    return normal.selfadjointView<Eigen::Lower>().ldlt().solve(rows * weighted);
  }

  SphericalHarmonicBasis Basis;
  IcosahedronDirections Directions;
};
} // namespace

Status ComplianceAtlas::Make(const SphericalHarmonicModel& model, const ElasticSolid& solid,
                             const ReducedCompliance& reduced, const Settings& settings,
                             const KernelProgress& progress, ComplianceAtlas& atlas)
{
  const double meanRadius = model.Coefficients()[0] / std::sqrt(4.0 * 3.14159265358979323846);
  const double largest =
      settings.LargestPatch > 0.0 ? settings.LargestPatch : DefaultPatch * meanRadius;
  if (settings.Degree < 0 || settings.Degree > MostDegree)
  {
    return Status::Failure("The degree of the maps is not a number from 0 to " +
                           std::to_string(MostDegree) + ".");
  }
  if (!(largest < meanRadius))
  {
    return Status::Failure("The largest patch is not smaller than the organ.");
  }
  const ComplianceSampler sampler(model, solid, reduced);
  const MapFit fit(settings.Degree);
  const std::vector<Vector3>& directions = fit.Directions.Directions();
  const auto& triangles = fit.Directions.Triangles();
  const std::size_t between = std::max<std::size_t>(1, triangles.size() / 150); // steps
  const std::size_t checks = triangles.size() / between;
  const std::size_t all = directions.size() + checks;
  const auto goesOn = [&](std::size_t done)
  { return !progress || progress(static_cast<double>(done) / static_cast<double>(all)); };

  Eigen::MatrixXd values(static_cast<Eigen::Index>(directions.size()), Eigen::Index{Maps});
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    if (!goesOn(i))
    {
      return Status::Failure("Cancelled.");
    }
    const PatchCompliance place = sampler.At(directions[i], largest);
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
    {
      values(row, static_cast<Eigen::Index>(term)) = place.Coefficients[term];
    }
    values(row, Eigen::Index{Maps} - 1) = sampler.PatchAt(directions[i], largest).Curvature;
  }
  const Eigen::MatrixXd coefficients = fit.Solve(values);
  atlas.MaximumDegree = settings.Degree;
  atlas.PatchLimit = largest;
  atlas.Poisson = solid.PoissonRatio;
  atlas.Evaluators.clear();
  for (Eigen::Index map = 0; map < coefficients.cols(); ++map)
  {
    const std::vector<double> column(coefficients.col(map).data(),
                                     coefficients.col(map).data() + coefficients.rows());
    atlas.Evaluators.emplace_back(settings.Degree, column);
  }

  atlas.Left = Error();
  atlas.Left.PatchRadius = 0.4 * largest;
  double sum = 0.0;
  for (std::size_t i = 0; i < checks; ++i)
  {
    if (!goesOn(directions.size() + i))
    {
      return Status::Failure("Cancelled.");
    }
    Vector3 direction = Vector3::Zero();
    for (const int corner : triangles[i * between])
    {
      direction += directions[static_cast<std::size_t>(corner)];
    }
    direction.normalize();
    const double truth = sampler.Compliance(sampler.PatchAt(direction, atlas.Left.PatchRadius));
    const double off =
        atlas.At(direction).Compliance.At(atlas.Left.PatchRadius).Compliance / truth - 1.0;
    sum += off * off;
    if (std::abs(off) > atlas.Left.Largest)
    {
      atlas.Left.Largest = std::abs(off);
      atlas.Left.Worst = direction;
    }
  }
  atlas.Left.Rms = std::sqrt(sum / static_cast<double>(checks));
  return goesOn(all) ? Status::Success() : Status::Failure("Cancelled.");
}

std::size_t ComplianceAtlas::Bytes() const noexcept
{
  std::size_t bytes = sizeof(*this);
  for (const SphericalHarmonicEvaluator& evaluator : this->Evaluators)
  {
    bytes += sizeof(evaluator) + evaluator.TableBytes();
  }
  return bytes;
}

ComplianceAtlas::Place ComplianceAtlas::At(const Vector3& direction) const noexcept
{
  Place place;
  place.Compliance.LargestRadius = this->PatchLimit;
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    const auto sample = this->Evaluators[term].Evaluate(direction);
    place.Compliance.Coefficients[term] = sample.Radius;
    place.Slopes[term] = sample.SurfaceGradient;
  }
  const auto curvature = this->Evaluators[PatchCompliance::Terms].Evaluate(direction);
  place.MeanCurvature = curvature.Radius;
  place.CurvatureSlope = curvature.SurfaceGradient;
  return place;
}
} // namespace palpate
