#include "DentedSurface.h"

#include "GaussLegendre.h"
#include "HertzPatch.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceCurvature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// The waves of a half-space that harmonics up to a degree carry, under a Hertz bump of unit force
// on unit modulus E*, with the square of the window.
class LongPart
{
public:
  LongPart(const HertzPatch& patch, int degree)
  {
    constexpr std::size_t Nodes = 48;
    static const GaussLegendre gauss(Nodes);
    const double distance = patch.Point.norm();
    const double radius = distance / (0.5 * (1.0 + patch.Normal.dot(patch.Point) / distance));
    const double end = (degree + 1.0) / radius;
    for (std::size_t i = 0; i < Nodes; ++i)
    {
      const double k = 0.5 * end * (1.0 + gauss.Nodes[i]);
      const double window = ReducedCompliance::Window(std::max(0.0, k * radius - 0.5), degree);
      this->Waves.push_back(k);
      this->Weights.push_back(0.5 * end * gauss.Weights[i] / Pi * window * window *
                              HertzPatch::Spectrum(k * patch.Radius));
    }
  }

  // At a distance from the patch's axis.
  double DentAt(double distance) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Waves.size(); ++i)
    {
      sum += this->Weights[i] * ::j0(this->Waves[i] * distance);
    }
    return sum;
  }

  // Mean over the patch.
  double MeanDent(double patchRadius) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Waves.size(); ++i)
    {
      sum += this->Weights[i] * HertzPatch::Spectrum(this->Waves[i] * patchRadius);
    }
    return sum;
  }

private:
  std::vector<double> Waves; // 1/mm
  std::vector<double> Weights;
};

// All waves: Johnson (3.41) and (3.42).
double HertzDentAt(double distance, double radius)
{
  const double a = radius;
  const double pressure = 1.5 / (Pi * a * a);
  if (distance <= a)
  {
    return pressure * Pi / (4.0 * a) * (2.0 * a * a - distance * distance);
  }
  const double part = a / distance;
  return pressure / (2.0 * a) *
         ((2.0 * a * a - distance * distance) * std::asin(part) +
          distance * a * std::sqrt(1.0 - part * part));
}

double MeanHertzDent(double radius)
{
  return 0.6 / radius;
}
} // namespace

DentedSurface::DentedSurface(const SphericalHarmonicModel& model, const ComplianceMaps& maps,
                             const std::vector<Vector3>& directions)
    : Model(model), Atlas(maps), LongWaves(maps.LongWaves.Unpacked())
{
  const SphericalHarmonicBasis basis(this->LongWaves.Degree());
  const auto count = static_cast<Eigen::Index>(directions.size());
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(basis.Size()), count);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    basis.Evaluate(directions[i], columns.col(static_cast<Eigen::Index>(i)).data());
    this->Rest.push_back(model.CenterWorld() + model.Radius(directions[i]) * directions[i]);
  }
  this->Harmonics = columns.transpose();
}

std::vector<double> DentedSurface::Dents(const HertzPatch& patch, double force) const
{
  const LongPart waves(patch, this->LongWaves.Degree());
  const double local = MeanHertzDent(patch.Radius) - waves.MeanDent(patch.Radius);
  const double compliance =
      this->Atlas.At(patch.Point.normalized()).Compliance.At(patch.Radius).Compliance -
      this->LongWaves.Compliance(patch);
  const double softness = std::max(0.0, compliance / local); // 1/E*
  // The rest fades within some of the shortest waves; its profile is drawn from a table.
  constexpr int Steps = 160;
  const double reach = 3.0 * patch.Radius + 0.5 * patch.Point.norm();
  std::vector<double> profile;
  for (int step = 0; step <= Steps; ++step)
  {
    const double distance = reach * step / Steps;
    profile.push_back(force * softness *
                      (HertzDentAt(distance, patch.Radius) - waves.DentAt(distance)));
  }
  const Vector3 center = this->Model.CenterWorld() + patch.Point;
  std::vector<double> dents(this->Rest.size(), 0.0);
  for (std::size_t i = 0; i < dents.size(); ++i)
  {
    const double place = (this->Rest[i] - center).norm() / reach * Steps;
    if (place < Steps)
    {
      const auto before = static_cast<std::size_t>(place);
      const double part = place - static_cast<double>(before);
      dents[i] = (1.0 - part) * profile[before] + part * profile[before + 1];
    }
  }
  return dents;
}

void DentedSurface::KeepOut(const Ball& ball, const HertzPatch& patch,
                            std::vector<Vector3>& points) const
{
  const Vector3 center =
      this->Model.CenterWorld() + patch.Point + (ball.Radius - ball.Depth) * patch.Normal;
  for (Vector3& point : points)
  {
    const Vector3 from = point - center;
    const double distance = from.norm();
    if (distance < ball.Radius)
    {
      // Downwards, as the surface is pressed, so that no vertex comes out on the other side.
      const double along = from.dot(patch.Normal);
      const double aside = from.squaredNorm() - along * along;
      const double low = -std::sqrt(std::max(0.0, ball.Radius * ball.Radius - aside));
      point += (low - along) * patch.Normal;
    }
  }
}

std::vector<Vector3> DentedSurface::PointsWorld(const Ball& ball) const
{
  const ElasticForce force =
      ElasticForce::Of(this->Atlas, this->Model, ball.Direction, ball.Depth, ball.Radius);
  std::vector<Vector3> points = this->Rest;
  if (!(force.PatchRadius > 0.0))
  {
    return points;
  }
  const auto sample = this->Model.EvaluateSecondOrder(ball.Direction);
  const Vector3 normal = (sample.Radius * ball.Direction - sample.SurfaceGradient).normalized();
  const HertzPatch patch{sample.Radius * ball.Direction, normal, force.PatchRadius,
                         CurvatureAt(ball.Direction, sample).Mean};
  const double push = force.ForceWorld.dot(normal);
  const Eigen::MatrixX3d moved = this->Harmonics * (push * this->LongWaves.Displacement(patch));
  const std::vector<double> dents = this->Dents(patch, push);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] += moved.row(static_cast<Eigen::Index>(i)).transpose() - dents[i] * normal;
  }
  this->KeepOut(ball, patch, points);
  return points;
}
} // namespace palpate
