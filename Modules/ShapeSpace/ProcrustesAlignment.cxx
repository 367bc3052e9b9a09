#include "ProcrustesAlignment.h"

#include "ModelMeasures.h"
#include "ShapeMirror.h"
#include "ShapeVector.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double RoundsShare = 0.7; // of the progress; the rest is flips

OrganModel Scaled(const OrganModel& shape, double factor)
{
  return ShapeFrom(factor * VectorOf(shape), shape);
}

// RMS over the sphere, mm.
double DistanceBetween(const OrganModel& a, const OrganModel& b)
{
  return RmsOverSphere(VectorOf(a) - VectorOf(b));
}

Status MeasureShape(const OrganModel& shape, BodyMoments& body)
{
  return std::visit([&](const auto& one) { return MeasureBody(one, body); }, shape);
}

Status CheckShapes(const std::vector<OrganModel>& shapes, const OrganModel* reference)
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
  for (const OrganModel& shape : shapes)
  {
    if (Status status = MeasureShape(shape, body); !status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

void ScaleShapes(const OrganModel* reference, ProcrustesResult& result)
{
  double size = 0.0;
  for (const OrganModel& shape : result.Aligned)
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
bool TurnToMean(const std::vector<OrganModel>& shapes, const KernelProgress& progress,
                ProcrustesResult& result)
{
  const bool isFirst = result.Rounds == 0;
  const auto count = static_cast<double>(shapes.size());
  const ShapeSuperposition mean(result.Mean);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const double rounds = result.Rounds + static_cast<double>(i) / count;
    if (progress && !progress(RoundsShare * (1.0 - std::exp2(-rounds))))
    {
      return false;
    }
    SuperposedShape best = mean.Fit(shapes[i], result.Cases[i].Rotation);
    if (isFirst && std::holds_alternative<SurfaceModel>(shapes[i]))
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
  return true;
}

// Of the best orientation near a half turn of an aligned shape.
double FlippedResidual(const ShapeSuperposition& mean, const OrganModel& aligned,
                       const Matrix3& flip)
{
  const SphereRotation start = mean.StartFor(aligned, flip);
  const SuperposedShape found = mean.Fit(aligned, start);
  const bool isRadial = std::holds_alternative<RadialModel>(aligned);
  const double turn = AngleOf(isRadial ? found.Rotation.Parameters : found.Rotation.Body);
  return (turn < SmallestOtherTurn ? mean.At(aligned, start) : found).ShapeResidual;
}

bool CompareWithFlips(const KernelProgress& progress, ProcrustesResult& result)
{
  const ShapeSuperposition mean(result.Mean);
  BodyMoments body;
  // A mean of shapes may have no volume; then its flips are about the frame's axes.
  const bool hasAxes = MeasureShape(result.Mean, body).IsOk();
  const Matrix3 axes = hasAxes ? Matrix3(body.PrincipalAxes) : Matrix3(Matrix3::Identity());
  for (std::size_t i = 0; i < result.Aligned.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(result.Aligned.size());
    if (progress && !progress(RoundsShare + (1.0 - RoundsShare) * done))
    {
      return false;
    }
    ProcrustesCase& one = result.Cases[i];
    const OrganModel& aligned = result.Aligned[i];
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
    one.MirroredResidual = mean.Fit(MirrorShape(aligned), {}).ShapeResidual;
  }
  return true;
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

Status AlignByProcrustes(const std::vector<OrganModel>& shapes, const OrganModel* reference,
                         const ProcrustesSettings& settings, ProcrustesResult& result,
                         const KernelProgress& progress)
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
  const std::vector<OrganModel> scaled = result.Aligned;
  result.Mean = reference != nullptr ? *reference : MeanShape(scaled);
  while (result.Rounds < settings.MostRounds && !result.HasConverged)
  {
    if (!TurnToMean(scaled, progress, result))
    {
      return Status::Failure("cancelled");
    }
    ++result.Rounds;
    const OrganModel mean = reference != nullptr ? *reference : MeanShape(result.Aligned);
    result.HasConverged = DistanceBetween(mean, result.Mean) <= settings.Tolerance;
    result.Mean = mean;
  }
  return CompareWithFlips(progress, result) ? Status::Success() : Status::Failure("cancelled");
}
} // namespace palpate
