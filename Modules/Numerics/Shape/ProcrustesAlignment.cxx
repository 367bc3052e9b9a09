#include "ProcrustesAlignment.h"

#include "ParametricSurfaceMeasures.h"
#include "SphericalHarmonicMeasures.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Orientations closer than this to the chosen one are no others.
constexpr double SmallestOtherTurn = 0.25 * M_PI; // rad

// x to -x. A surface's parameters are mirrored too, so that it stays outside out.
SurfaceModel MirrorImage(const SurfaceModel& shape)
{
  const Matrix3 mirror = Vector3(-1.0, 1.0, 1.0).asDiagonal();
  if (std::holds_alternative<SphericalHarmonicModel>(shape))
  {
    return TurnShape(shape, {Matrix3::Identity(), mirror});
  }
  return TurnShape(shape, {mirror, mirror});
}

SurfaceModel Scaled(const SurfaceModel& shape, double factor)
{
  if (const auto* surface = std::get_if<ParametricSphericalSurface>(&shape))
  {
    return surface->Transformed(factor * Matrix3::Identity(), Vector3::Zero());
  }
  const auto& radial = std::get<SphericalHarmonicModel>(shape);
  std::vector<double> coefficients = radial.Coefficients();
  for (double& c : coefficients)
  {
    c *= factor;
  }
  return SphericalHarmonicModel(radial.Degree(), std::move(coefficients), Vector3::Zero());
}

std::array<std::vector<double>, 3> SeriesCoefficients(const SurfaceModel& shape)
{
  if (const auto* radial = std::get_if<SphericalHarmonicModel>(&shape))
  {
    return {radial->Coefficients(), {}, {}};
  }
  const auto& surface = std::get<ParametricSphericalSurface>(shape);
  return {surface.Coefficients(0), surface.Coefficients(1), surface.Coefficients(2)};
}

SurfaceModel MeanOf(const std::vector<SurfaceModel>& shapes)
{
  std::array<std::vector<double>, 3> mean = SeriesCoefficients(shapes.front());
  for (std::size_t i = 1; i < shapes.size(); ++i)
  {
    const std::array<std::vector<double>, 3> one = SeriesCoefficients(shapes[i]);
    for (std::size_t series = 0; series < 3; ++series)
    {
      for (std::size_t k = 0; k < mean[series].size(); ++k)
      {
        mean[series][k] += one[series][k];
      }
    }
  }
  for (std::vector<double>& series : mean)
  {
    for (double& c : series)
    {
      c /= static_cast<double>(shapes.size());
    }
  }
  const int degree = DegreeOf(shapes.front());
  if (std::holds_alternative<SphericalHarmonicModel>(shapes.front()))
  {
    return SphericalHarmonicModel(degree, std::move(mean[0]), Vector3::Zero());
  }
  return ParametricSphericalSurface(degree, mean);
}

// RMS over the sphere, mm.
double DistanceBetween(const SurfaceModel& a, const SurfaceModel& b)
{
  const std::array<std::vector<double>, 3> first = SeriesCoefficients(a);
  const std::array<std::vector<double>, 3> second = SeriesCoefficients(b);
  double sum = 0.0;
  for (std::size_t series = 0; series < 3; ++series)
  {
    for (std::size_t k = 0; k < first[series].size(); ++k)
    {
      sum += std::pow(first[series][k] - second[series][k], 2);
    }
  }
  return std::sqrt(sum / (4.0 * M_PI));
}

Status MeasureShape(const SurfaceModel& shape, BodyMoments& body)
{
  return std::visit([&](const auto& one) { return MeasureBody(one, body); }, shape);
}

Status CheckShapes(const std::vector<SurfaceModel>& shapes, const SurfaceModel* reference)
{
  if (shapes.empty())
  {
    return Status::Failure("there is no shape to align");
  }
  if (reference != nullptr && reference->index() != shapes.front().index())
  {
    return Status::Failure("radial and surface models cannot be aligned to each other");
  }
  if (reference != nullptr && DegreeOf(*reference) != DegreeOf(shapes.front()))
  {
    return Status::Failure("the reference has another degree than the shapes");
  }
  BodyMoments body;
  for (const SurfaceModel& shape : shapes)
  {
    if (Status status = MeasureShape(shape, body); !status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

void ScaleShapes(const SurfaceModel* reference, ProcrustesResult& result)
{
  double size = 0.0;
  for (const SurfaceModel& shape : result.Aligned)
  {
    size += RmsSizeOf(shape) / static_cast<double>(result.Aligned.size());
  }
  size = reference != nullptr ? RmsSizeOf(*reference) : size;
  for (std::size_t i = 0; i < result.Aligned.size(); ++i)
  {
    result.Cases[i].Scale = size / RmsSizeOf(result.Aligned[i]);
    result.Aligned[i] = Scaled(result.Aligned[i], result.Cases[i].Scale);
  }
}

// From where each shape is; of surfaces from the polar factor too, the first time.
void TurnToMean(const std::vector<SurfaceModel>& shapes, bool isFirst, ProcrustesResult& result)
{
  const ShapeSuperposition mean(result.Mean);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    SuperposedShape best = mean.Fit(shapes[i], result.Cases[i].Rotation);
    if (isFirst && std::holds_alternative<ParametricSphericalSurface>(shapes[i]))
    {
      const SuperposedShape other =
          mean.Fit(shapes[i], mean.StartFor(shapes[i], Matrix3::Identity()));
      best = other.Residual < best.Residual ? other : best;
    }
    result.Cases[i].Rotation = best.Rotation;
    result.Cases[i].Residual = best.Residual;
    result.Cases[i].ShapeResidual = best.ShapeResidual;
    result.Aligned[i] = TurnShape(shapes[i], best.Rotation);
  }
}

// Of the best orientation near a half turn of an aligned shape.
double FlippedResidual(const ShapeSuperposition& mean, const SurfaceModel& aligned,
                       const Matrix3& flip)
{
  const SphereRotation start = mean.StartFor(aligned, flip);
  const SuperposedShape found = mean.Fit(aligned, start);
  const bool isRadial = std::holds_alternative<SphericalHarmonicModel>(aligned);
  const double turn = AngleOf(isRadial ? found.Rotation.Parameters : found.Rotation.Body);
  return (turn < SmallestOtherTurn ? mean.At(aligned, start) : found).ShapeResidual;
}

void CompareWithFlips(ProcrustesResult& result)
{
  const ShapeSuperposition mean(result.Mean);
  BodyMoments body;
  // A mean of shapes may have no volume; then its flips are about the frame's axes.
  const bool hasAxes = MeasureShape(result.Mean, body).IsOk();
  const Matrix3 axes = hasAxes ? Matrix3(body.PrincipalAxes) : Matrix3(Matrix3::Identity());
  for (std::size_t i = 0; i < result.Aligned.size(); ++i)
  {
    ProcrustesCase& one = result.Cases[i];
    const SurfaceModel& aligned = result.Aligned[i];
    one.FlippedResidual = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const Matrix3 flip = Eigen::AngleAxisd(M_PI, axes.col(axis)).toRotationMatrix();
      const double residual = FlippedResidual(mean, aligned, flip);
      if (residual < one.FlippedResidual)
      {
        one.FlippedResidual = residual;
        one.FlipAxis = axis;
      }
    }
    one.MirroredResidual = mean.Fit(MirrorImage(aligned), {}).ShapeResidual;
  }
}

// 1 if both vanish but for rounding.
double ResidualRatio(double residual, double other)
{
  constexpr double Nothing = 1e-9; // mm
  return residual <= Nothing && other <= Nothing ? 1.0 : residual / other;
}
} // namespace

double ProcrustesCase::FlipRatio() const
{
  return ResidualRatio(this->ShapeResidual, this->FlippedResidual);
}

double ProcrustesCase::MirrorRatio() const
{
  return ResidualRatio(this->ShapeResidual, this->MirroredResidual);
}

bool ProcrustesCase::IsAmbiguous() const
{
  return this->FlipRatio() >= AmbiguousRatio;
}

bool ProcrustesCase::IsMirrored() const
{
  return this->MirrorRatio() > 1.0 / AmbiguousRatio;
}

Status AlignByProcrustes(const std::vector<SurfaceModel>& shapes, const SurfaceModel* reference,
                         const ProcrustesSettings& settings, ProcrustesResult& result)
{
  if (Status status = CheckShapes(shapes, reference); !status.IsOk())
  {
    return status;
  }
  result = {};
  result.Aligned = shapes;
  result.Cases.resize(shapes.size());
  if (settings.Scales)
  {
    ScaleShapes(reference, result);
  }
  const std::vector<SurfaceModel> scaled = result.Aligned;
  result.Mean = reference != nullptr ? *reference : MeanOf(scaled);
  while (result.Rounds < settings.MostRounds && !result.HasConverged)
  {
    TurnToMean(scaled, result.Rounds == 0, result);
    ++result.Rounds;
    const SurfaceModel mean = reference != nullptr ? *reference : MeanOf(result.Aligned);
    result.HasConverged = DistanceBetween(mean, result.Mean) <= settings.Tolerance;
    result.Mean = mean;
  }
  CompareWithFlips(result);
  return Status::Success();
}
} // namespace palpate
