#include "ElasticBenchmarks.h"

#include "BallContact.h"
#include "BallFraction.h"
#include "ComplianceAtlas.h"
#include "ElasticForce.h"
#include "GslHarmonics.h"
#include "OrganSoftening.h"
#include "RandomShapes.h"
#include "SomeMaps.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
constexpr std::size_t ElasticTicks = 500;
constexpr double BallRadius = 8.0; // mm
constexpr int Degrees[] = {8, 12, 16, 20, 24};

std::string NameOfDegree(int degree)
{
  return "elastic/tick/degree" + std::to_string(degree);
}

// Bumps of a few percent at all degrees.
ComplianceMaps RoughMaps(int degree)
{
  test::Random random(72);
  ComplianceMaps maps = test::SomeMaps(degree);
  for (std::vector<double>& map : maps.Coefficients)
  {
    const std::vector<double> bumps = test::RandomCoefficients(random, degree, 2.0);
    for (std::size_t i = 1; i < map.size(); ++i)
    {
      map[i] += 0.02 * map[0] * bumps[i];
    }
  }
  return maps;
}

// The same contacts by both: a ball that wanders at 50 mm/s and 1 kHz, 0.5 to 3.5 mm deep.
class TickCase
{
public:
  explicit TickCase(int degree) : Model(Organ()), Atlas(RoughMaps(degree))
  {
    for (const std::vector<double>& map : RoughMaps(degree).Coefficients)
    {
      this->Maps.emplace_back(degree, map);
    }
    test::Random random(73);
    Vector3 place = test::RandomDirection(random);
    const Vector3 axis = place.unitOrthogonal();
    for (std::size_t tick = 0; tick < ElasticTicks; ++tick)
    {
      place = (Eigen::AngleAxisd(0.05 / 20.0, axis) * place).normalized();
      this->Places.push_back(place);
      this->Depths.push_back(2.0 - 1.5 * std::cos(0.02 * static_cast<double>(tick)));
    }
  }

  void Run()
  {
    double patch = 0.0;
    for (std::size_t i = 0; i < ElasticTicks; ++i)
    {
      this->Ours[i] = ElasticForce::Of(this->Atlas, this->Model, this->Places[i], this->Depths[i],
                                       BallRadius, patch);
      patch = this->Ours[i].PatchRadius;
    }
  }

  void RunByGsl()
  {
    double patch = 0.0;
    for (std::size_t i = 0; i < ElasticTicks; ++i)
    {
      PatchCompliance place{{}, this->Atlas.LargestPatch()};
      for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
      {
        place.Coefficients[term] = this->Maps[term].Evaluate(this->Places[i]).Radius;
      }
      const double curvature = this->Maps.back().Evaluate(this->Places[i]).Radius;
      this->Theirs[i] = BallContact::Of(this->Depths[i], BallRadius, curvature, place, patch);
      patch = this->Theirs[i].PatchRadius;
    }
  }

  // Of the energies: the other side has no lateral force.
  std::string Compared() const
  {
    constexpr double Rounding = 1e-9;
    double worst = 0.0;
    for (std::size_t i = 0; i < ElasticTicks; ++i)
    {
      const double off = std::abs(this->Ours[i].Energy / this->Theirs[i].Energy - 1.0);
      worst = off <= worst ? worst : off;
    }
    std::ostringstream text;
    text << "energies differ by a part of " << worst;
    return worst <= Rounding ? std::string() : text.str();
  }

private:
  static RadialModel Organ()
  {
    test::Random random(12);
    return test::RandomOrgan(random, 12);
  }

  RadialModel Model;
  ComplianceAtlas Atlas;
  std::vector<GslHarmonics> Maps;
  std::vector<Vector3> Places;
  std::vector<double> Depths;
  std::vector<ElasticForce> Ours{ElasticTicks};
  std::vector<BallContact> Theirs{ElasticTicks};
};

PairedBenchmark TickBenchmark(int degree)
{
  const auto tick = std::make_shared<TickCase>(degree);
  return {NameOfDegree(degree),
          "GSL, eight maps by deriv_alt_array and sums, the same contact",
          [tick] { tick->Run(); },
          [tick] { tick->RunByGsl(); },
          [tick] { return tick->Compared(); },
          ElasticTicks};
}

ComplianceMaps LesionMaps(int degree)
{
  test::Random random(74);
  RadialModel organ = test::RandomOrgan(random, 4);
  const Vector3 towards = Vector3(1.0, -2.0, 0.5).normalized();
  ElasticSolid solid{TissueMap(0.02), 0.49, ElasticBed(1e-3)};
  solid.Tissue.AddInclusion(test::BallFraction(organ.PointWorld(towards) - 7.0 * towards, 5.0),
                            0.06);
  OrganSoftening softening;
  softening.ElementsAcross = 10;
  softening.Maps.Degree = degree;
  ComplianceMaps maps;
  OrganSoftening::Account account;
  const Status status = softening.Make(organ, solid, {}, maps, account);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return maps;
}
} // namespace

std::vector<PairedBenchmark> ElasticBenchmarks()
{
  std::vector<PairedBenchmark> pairs;
  for (const int degree : Degrees)
  {
    pairs.push_back(TickBenchmark(degree));
  }
  return pairs;
}

std::vector<ElasticMapRow> ElasticMapRows(const std::vector<Comparison>& comparisons)
{
  std::vector<ElasticMapRow> rows;
  for (const int degree : Degrees)
  {
    const auto measured = std::find_if(comparisons.begin(), comparisons.end(),
                                       [&](const Comparison& comparison)
                                       { return comparison.Name == NameOfDegree(degree); });
    if (measured != comparisons.end())
    {
      const ComplianceMaps maps = LesionMaps(degree);
      rows.push_back({degree, ComplianceAtlas(maps).Bytes(), maps.FitError.Rms,
                      maps.FitError.Largest, measured->Nanoseconds, measured->Ratio()});
    }
  }
  return rows;
}

std::string ToMarkdown(const std::vector<ElasticMapRow>& rows)
{
  std::ostringstream text;
  text << "| degree of the maps | kB | left out of the compliance: RMS | at most | a tick, µs | "
          "times faster than by GSL |\n|---|---|---|---|---|---|\n"
       << std::fixed;
  for (const ElasticMapRow& row : rows)
  {
    text << "| " << row.Degree << std::setprecision(0) << " | "
         << static_cast<double>(row.Bytes) / 1000.0 << std::setprecision(2) << " | "
         << 100.0 * row.LostRms << " % | " << 100.0 * row.LostLargest << " % | "
         << row.Nanoseconds / 1000.0 << std::setprecision(1) << " | " << row.Ratio << " |\n";
  }
  return text.str();
}
} // namespace palpate::bench
