#include "ComplianceMaps.h"

#include "ComplianceAtlas.h"
#include "ComplianceSampler.h"
#include "IcosahedronDirections.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
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

// To nine digits of the largest, so that files are short.
void RoundTogether(std::vector<double>& values)
{
  const double largest = std::abs(*std::max_element(
      values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const double unit = largest > 0.0 ? std::pow(10.0, 8.0 - std::floor(std::log10(largest))) : 1.0;
  for (double& value : values)
  {
    value = std::round(value * unit) / unit;
  }
}

// The centres of some triangles.
std::vector<Vector3> PlacesBetween(const IcosahedronDirections& directions)
{
  constexpr std::size_t About = 150;
  const auto& triangles = directions.Triangles();
  const std::size_t step = std::max<std::size_t>(1, triangles.size() / About);
  std::vector<Vector3> places;
  for (std::size_t i = 0; i < triangles.size(); i += step)
  {
    Vector3 sum = Vector3::Zero();
    for (const int corner : triangles[i])
    {
      sum += directions.Directions()[static_cast<std::size_t>(corner)];
    }
    places.push_back(sum.normalized());
  }
  return places;
}

// Adds the square of the error at a place.
void Compare(const ComplianceSampler& sampler, const ComplianceAtlas& atlas,
             const Vector3& direction, ComplianceMaps::Error& error)
{
  const double truth = sampler.Compliance(sampler.PatchAt(direction, error.PatchRadius));
  const double off = atlas.At(direction).Compliance.At(error.PatchRadius).Compliance / truth - 1.0;
  error.Rms += off * off;
  if (std::abs(off) > error.Largest)
  {
    error.Largest = std::abs(off);
    error.Worst = direction;
  }
}

// Whether contact is a computation with ordinary numbers: the limits are far beyond TissueMap's. A
// patch that would yield more if it were larger stops growing; small ones must not.
bool IsOfABody(const ComplianceAtlas::Place& place)
{
  constexpr double LeastYield = 1e-6; // mm^2/N
  constexpr double MostYield = 1e9;   // mm^2/N
  constexpr double MostBend = 1e3;    // rad, over the largest patch
  constexpr double Parts = 20.0;      // squared: small patches have to be denser
  const double largest = place.Compliance.LargestRadius;
  bool isBody = std::abs(place.MeanCurvature) * largest <= MostBend;
  for (double part = 1.0; part <= Parts && isBody; ++part)
  {
    const double radius = largest * (part / Parts) * (part / Parts);
    const PatchCompliance::Value value = place.Compliance.At(radius);
    const double yield = radius * value.Compliance;
    isBody =
        yield >= LeastYield && yield <= MostYield && (value.First < 0.0 || radius > 0.5 * largest);
  }
  return isBody;
}

// Harmonics overshoot beside a part that is many times as stiff or soft as the tissue, so far that
// no body yields like that. Short waves are then damped as a diffusion does, as little as will do.
void SmoothUntilOfABody(ComplianceMaps& maps)
{
  const auto sharp = maps.Coefficients;
  for (const double strength : {0.5, 1.0, 2.0, 4.0})
  {
    if (maps.Check().IsOk())
    {
      return;
    }
    for (std::size_t map = 0; map < ComplianceMaps::Count; ++map)
    {
      for (std::size_t i = 0; i < sharp[map].size(); ++i)
      {
        const double wave = std::floor(std::sqrt(static_cast<double>(i))) / (maps.Degree + 1.0);
        maps.Coefficients[map][i] = sharp[map][i] * std::exp(-strength * wave * wave);
      }
      RoundTogether(maps.Coefficients[map]);
    }
  }
}

// The terms of the compliance and the curvature at directions, a row for each. False if `goesOn`,
// which gets the count of those done, stops it.
bool SampleMaps(const ComplianceSampler& sampler, const std::vector<Vector3>& directions,
                double largest, const std::function<bool(std::size_t)>& goesOn,
                Eigen::MatrixXd& values)
{
  constexpr auto Maps = Eigen::Index{ComplianceMaps::Count};
  values.resize(static_cast<Eigen::Index>(directions.size()), Maps);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    if (!goesOn(i))
    {
      return false;
    }
    const PatchCompliance place = sampler.At(directions[i], largest);
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
    {
      values(row, static_cast<Eigen::Index>(term)) = place.Coefficients[term];
    }
    values(row, Maps - 1) = sampler.PatchAt(directions[i], largest).Curvature;
  }
  return true;
}
} // namespace

Status ComplianceMaps::Fit(const RadialModel& model, const ElasticSolid& solid,
                           const ReducedCompliance& reduced, const Settings& settings,
                           const KernelProgress& progress, ComplianceMaps& maps)
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
  const std::vector<Vector3> between = PlacesBetween(fit.Directions);
  const std::size_t all = directions.size() + between.size();
  const auto goesOn = [&](std::size_t done)
  { return !progress || progress(static_cast<double>(done) / static_cast<double>(all)); };

  Eigen::MatrixXd values;
  if (!SampleMaps(sampler, directions, largest, goesOn, values))
  {
    return Status::Failure("Cancelled.");
  }
  const Eigen::MatrixXd coefficients = fit.Solve(values);
  maps.Degree = settings.Degree;
  maps.LargestPatch = largest;
  maps.PoissonRatio = solid.PoissonRatio;
  maps.LongWaves = PackedCompliance::Of(reduced, DrawnDegree);
  for (std::size_t map = 0; map < Count; ++map)
  {
    const auto column = coefficients.col(static_cast<Eigen::Index>(map));
    maps.Coefficients[map].assign(column.data(), column.data() + column.size());
    RoundTogether(maps.Coefficients[map]);
  }

  SmoothUntilOfABody(maps);

  maps.FitError = Error();
  maps.FitError.PatchRadius = 0.4 * largest;
  const ComplianceAtlas atlas(maps);
  for (std::size_t i = 0; i < between.size(); ++i)
  {
    if (!goesOn(directions.size() + i))
    {
      return Status::Failure("Cancelled.");
    }
    Compare(sampler, atlas, between[i], maps.FitError);
  }
  maps.FitError.Rms = std::sqrt(maps.FitError.Rms / static_cast<double>(between.size()));
  return goesOn(all) ? Status::Success() : Status::Failure("Cancelled.");
}

ComplianceMaps ComplianceMaps::Truncated(int degree) const
{
  ComplianceMaps maps = *this;
  if (degree < this->Degree)
  {
    maps.Degree = degree;
    maps.FitError = Error();
    for (std::vector<double>& map : maps.Coefficients)
    {
      map.resize(SphericalHarmonicBasis::CoefficientCount(degree));
    }
  }
  return maps;
}

Status ComplianceMaps::Check() const
{
  constexpr double MostPatch = 1e6; // mm
  const bool isKnown = this->Degree >= 0 && this->Degree <= MostDegree &&
                       this->LargestPatch >= 1.0 / MostPatch && this->LargestPatch <= MostPatch &&
                       this->PoissonRatio >= 0.0 && this->PoissonRatio < 0.5;
  const bool isComplete =
      isKnown &&
      std::all_of(this->Coefficients.begin(), this->Coefficients.end(),
                  [this](const std::vector<double>& map)
                  {
                    return map.size() == SphericalHarmonicBasis::CoefficientCount(this->Degree) &&
                           std::all_of(map.begin(), map.end(),
                                       [](double c) { return std::isfinite(c); });
                  });
  if (!isComplete)
  {
    return Status::Failure("The maps of compliance are incomplete.");
  }
  Status drawn = this->LongWaves.IsEmpty() ? Status::Success() : this->LongWaves.Check();
  if (!drawn.IsOk())
  {
    return drawn;
  }
  const ComplianceAtlas atlas(*this);
  const std::vector<Vector3> directions = SphereQuadrature(3 * this->Degree + 20).Directions;
  const bool isBody = std::all_of(directions.begin(), directions.end(),
                                  [&](const Vector3& d) { return IsOfABody(atlas.At(d)); });
  return isBody ? Status::Success()
                : Status::Failure("The maps of compliance are not those of an elastic body.");
}
} // namespace palpate
