#include "DentedSurface.h"

#include "ElasticForce.h"
#include "GaussLegendre.h"
#include "HertzPatch.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceCurvature.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
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

// Where the surface is pressed to at a point of a ball (mm, from its centre): against the normal of
// the place below it, and between two places against both.
Vector3 OutwardAt(const Vector3& from, double ballRadius, const std::vector<Vector3>& normals)
{
  constexpr double Width = 0.1; // of the ball's radius
  double lowest = from.dot(normals.front());
  for (const Vector3& normal : normals)
  {
    lowest = std::min(lowest, from.dot(normal));
  }
  Vector3 sum = Vector3::Zero();
  for (const Vector3& normal : normals)
  {
    sum += std::exp((lowest - from.dot(normal)) / (Width * ballRadius)) * normal;
  }
  return sum.norm() > 0.0 ? Vector3(sum.normalized()) : normals.front();
}

// Downwards, as the surface is pressed, so that no vertex comes out on the other side.
void KeepOut(const DentedSurface::Ball& ball, const std::vector<Vector3>& normals,
             std::vector<Vector3>& points)
{
  for (Vector3& point : points)
  {
    const Vector3 from = point - ball.CenterWorld;
    if (normals.empty() || !(from.norm() < ball.Radius))
    {
      continue;
    }
    const Vector3 normal = OutwardAt(from, ball.Radius, normals);
    const double along = from.dot(normal);
    const double aside = from.squaredNorm() - along * along;
    const double low = -std::sqrt(std::max(0.0, ball.Radius * ball.Radius - aside));
    point += (low - along) * normal;
  }
}
} // namespace

DentedSurface::DentedSurface(const RadialModel& model, const ComplianceMaps& maps,
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

HertzPatch DentedSurface::PatchAt(const Vector3& direction, double patchRadius) const
{
  const auto sample = this->Model.EvaluateSecondOrder(direction);
  const Vector3 normal = (sample.Radius * direction - sample.SurfaceGradient).normalized();
  return {sample.Radius * direction, normal, patchRadius, CurvatureAt(direction, sample).Mean};
}

DentedSurface::Ball DentedSurface::PressedAt(const Vector3& direction, double depth,
                                             double ballRadius) const
{
  const ElasticForce force =
      ElasticForce::Of(this->Atlas, this->Model, direction, depth, ballRadius);
  const HertzPatch patch = this->PatchAt(direction, force.PatchRadius);
  return {this->Model.CenterWorld() + patch.Point + (ballRadius - depth) * patch.Normal,
          ballRadius,
          {{direction, force.ForceWorld.dot(patch.Normal), force.PatchRadius}}};
}

std::vector<Vector3> DentedSurface::PointsWorld(const Ball& ball) const
{
  std::vector<Vector3> points = this->Rest;
  std::vector<Vector3> normals;
  for (const PressedPlace& place : ball.Places)
  {
    if (!(place.PatchRadius > 0.0) || !(place.Force > 0.0))
    {
      continue;
    }
    const HertzPatch patch = this->PatchAt(place.Direction, place.PatchRadius);
    const Eigen::MatrixX3d moved =
        this->Harmonics * (place.Force * this->LongWaves.Displacement(patch));
    const std::vector<double> dents = this->Dents(patch, place.Force);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i] += moved.row(static_cast<Eigen::Index>(i)).transpose() - dents[i] * patch.Normal;
    }
    normals.push_back(patch.Normal);
  }
  KeepOut(ball, normals, points);
  return points;
}
} // namespace palpate
