#include "SurfaceModelFit.h"

#include "CrossingRemedy.h"
#include "DirectionSlide.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceModelSolver.h"
#include "SurfaceSamples.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using Sample = SurfaceModel::Sample;

// Area element of the surface over that of the parameter sphere, along the normal of the mesh.
double AreaElement(const Sample& sample, const Vector3& normal)
{
  return sample.First[0].cross(sample.First[1]).dot(normal);
}

// The tangent step (rad) of the parameter that brings the surface nearest to a point, by a damped
// Gauss-Newton step. Damping keeps parameters apart where the surface is stretched in one direction
// only: with a hundredth of it, half as many surfaces more cross themselves.
Vector3 StepTowards(const Vector3& point, const Sample& sample)
{
  constexpr double Damping = 0.1; // of the squared stretch
  const Vector3 left = point - sample.Point;
  const Vector3& a = sample.First[0];
  const Vector3& b = sample.First[1];
  const double damping = Damping * (a.squaredNorm() + b.squaredNorm()) + 1e-300;
  const double aa = a.squaredNorm() + damping;
  const double bb = b.squaredNorm() + damping;
  const double ab = a.dot(b);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0.0)) // a point, of degree 0
  {
    return Vector3::Zero();
  }
  const double alongA = (bb * a.dot(left) - ab * b.dot(left)) / determinant;
  const double alongB = (aa * b.dot(left) - ab * a.dot(left)) / determinant;
  return alongA * sample.Tangents[0] + alongB * sample.Tangents[1];
}

// C of X(u) ~ c0 + C u, see SphericalPlacement.
Matrix3 DegreeOneOf(const SurfaceModel& surface)
{
  const double factor = std::sqrt(3.0 / (4.0 * M_PI));
  const std::array<int, 3> orders{1, -1, 0}; // x, y and z
  Matrix3 matrix;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const int order = orders[static_cast<std::size_t>(column)];
      matrix(row, column) =
          factor * surface.Coefficients(row)[SphericalHarmonicBasis::Index(1, order)];
    }
  }
  return matrix;
}

double VolumeOf(const IndexedMesh& mesh)
{
  const Vector3& origin = mesh.Points.front();
  double sixfold = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const auto corner = [&](int i) -> Vector3
    { return mesh.Points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])] - origin; };
    sixfold += corner(0).dot(corner(1).cross(corner(2)));
  }
  return sixfold / 6.0;
}

// One run over a mesh.
class Run
{
public:
  Run(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
      const SurfaceModelFitOptions& options)
      : Mesh(mesh), Target(mesh), Options(options), Parameters(parameters),
        Solver(options.Degree, options.Ridge), MeshVolume(VolumeOf(mesh))
  {
  }

  Status Start()
  {
    this->Samples =
        SampleMesh(this->Target, this->Parameters, SampleSpacingFor(this->Options.Degree));
    return this->Solver.FitPoints(this->Samples)
               ? Status::Success()
               : Status::Failure(
                     "the parameters of the mesh do not determine a surface of degree " +
                     std::to_string(this->Options.Degree));
  }

  // Turns the parameter sphere.
  Status Place(SurfaceModelFitResult& result)
  {
    Status status = this->FindPlacement(result);
    if (!status.IsOk())
    {
      return status;
    }
    for (Vector3& parameter : this->Parameters)
    {
      parameter = (result.Placement.Rotation * parameter).normalized();
    }
    return this->Start();
  }

  Status Refit()
  {
    Status status = this->Slide();
    if (status.IsOk())
    {
      status = this->Start();
    }
    if (!status.IsOk())
    {
      return status;
    }
    this->VertexWeights.assign(this->Mesh.Points.size(), this->Options.TangentWeight);
    this->FitNormals();
    return status;
  }

  // After the last refit.
  void Complete()
  {
    constexpr int MostRepeats = 3;
    constexpr int MostRepeatsOfFolds = 2;
    const Narrow narrow{this->Options.LeastAreaRatio, 1.0, this->Parameters.size()};
    const Narrow folds{0.0, 4.0, 4};
    const bool isGuarded = this->Options.LeastAreaRatio > 0.0;
    for (int repeat = 0; isGuarded && repeat < MostRepeats && this->Stiffen(narrow); ++repeat)
    {
      this->FitNormals();
    }
    for (int repeat = 0; isGuarded && repeat < MostRepeatsOfFolds && this->Stiffen(folds); ++repeat)
    {
      this->FitNormals();
    }
    this->MatchVolume();
  }

  // Keeps the fit with the fewest, if that is worth the distance to which the vertices were moved.
  // Where a round fails, the fits before are good. Returns false if cancelled.
  bool RemoveCrossings(const KernelProgress& progress)
  {
    // Of the RMS distance, relative to half the shortest wavelength.
    constexpr double LargestRise = 0.04;            // of a fit without crossings
    constexpr double LargestRiseIfCrossed = 0.0075; // of one with less than half of them
    CrossingRemedy remedy;
    const double before = this->NormalRms(this->Fitted);
    if (before > this->Options.LargestRms || !this->FindRemedy(this->Fitted.Surface, remedy) ||
        remedy.Crossings == 0)
    {
      return true;
    }
    std::int64_t fewest = (remedy.Crossings + 1) / 2;
    int degreeOfPleats = this->Options.Degree;
    for (int round = 1; round <= this->Options.MostSeparations && remedy.Crossings > 0; ++round)
    {
      if (progress && !progress(1.0 - 0.2 / (1.0 + round)))
      {
        return false;
      }
      const bool hadPleats = remedy.HasPleats();
      const std::int64_t last = remedy.Crossings;
      if (!this->Apply(remedy, degreeOfPleats).IsOk())
      {
        return true;
      }
      this->FitNormals();
      this->MatchVolume();
      const Fit fit{this->Solver.Surface(), this->Parameters};
      const double rise = (this->NormalRms(fit) - before) / HalfWavelengthOf(fit.Surface);
      if (!(rise <= LargestRise) || !this->FindRemedy(fit.Surface, remedy))
      {
        return true;
      }
      degreeOfPleats -= hadPleats && 2 * remedy.Crossings >= last ? 1 : 0;
      if (remedy.Crossings < fewest && (remedy.Crossings == 0 || rise <= LargestRiseIfCrossed))
      {
        fewest = remedy.Crossings;
        this->Fitted = fit;
      }
    }
    return true;
  }

  void Keep() { this->Fitted = {this->Solver.Surface(), this->Parameters}; }

  void Finish(SurfaceModelFitResult& result)
  {
    result.Surface = this->Fitted.Surface;
    result.Parameters = this->Fitted.Parameters;
    this->Samples =
        SampleMesh(this->Mesh, result.Parameters, SampleSpacingFor(this->Options.Degree));
    this->Evaluate(result.Surface, this->Samples.Parameters);
    result.NormalRms = NormalRms(this->Samples, this->State);
    result.Folded = 0;
    for (std::size_t i = 0; i < result.Parameters.size(); ++i)
    {
      result.Folded += this->AreaElementAt(i) > 0.0 ? 0 : 1;
    }
  }

private:
  // With the parameters that the vertices had.
  struct Fit
  {
    SurfaceModel Surface{0, {{{0.0}, {0.0}, {0.0}}}};
    std::vector<Vector3> Parameters;
  };

  Status FindPlacement(SurfaceModelFitResult& result) const
  {
    const Matrix3 degreeOne = DegreeOneOf(this->Solver.Surface());
    if (this->Options.Placing == SurfaceModelFitOptions::PlacementKind::Frame)
    {
      return PlaceByPolarFactor(degreeOne, result.Placement);
    }
    EllipsoidPlacement ellipsoid;
    Status status = PlaceByEllipsoid(degreeOne, ellipsoid);
    result.Placement = ellipsoid.Placement;
    result.IsAmbiguous = ellipsoid.IsLongestPairAmbiguous || ellipsoid.IsShortestPairAmbiguous;
    return status;
  }

  void Evaluate(const SurfaceModel& surface, const std::vector<Vector3>& parameters)
  {
    this->State.resize(parameters.size());
    surface.EvaluateBatch(parameters.data(), parameters.size(), this->State.data());
  }

  static double NormalRms(const SurfaceSamples& samples, const std::vector<Sample>& surface)
  {
    double squares = 0.0;
    for (std::size_t i = 0; i < samples.Points.size(); ++i)
    {
      const double off = samples.Normals[i].dot(surface[i].Point - samples.Points[i]);
      squares += samples.Weights[i] * off * off;
    }
    return std::sqrt(squares);
  }

  // Of the mesh that was given.
  double NormalRms(const Fit& fit) const
  {
    const SurfaceSamples samples =
        SampleMesh(this->Mesh, fit.Parameters, SampleSpacingFor(this->Options.Degree));
    std::vector<Sample> surface(samples.Parameters.size());
    fit.Surface.EvaluateBatch(samples.Parameters.data(), samples.Parameters.size(), surface.data());
    return NormalRms(samples, surface);
  }

  double AreaElementAt(std::size_t i) const
  {
    return AreaElement(this->State[i], this->Samples.Normals[i]);
  }

  // Weights of samples inside of a triangle are the largest of its corners.
  void FitNormals()
  {
    std::vector<double> weights = this->VertexWeights;
    for (const int triangle : this->Samples.Triangles)
    {
      double largest = 0.0;
      for (const int corner : this->Mesh.Triangles[static_cast<std::size_t>(triangle)])
      {
        largest = std::max(largest, this->VertexWeights[static_cast<std::size_t>(corner)]);
      }
      weights.push_back(largest);
    }
    this->Solver.SetTangentWeights(this->Samples, std::move(weights));
    this->Solver.FitNormals(this->Samples, this->Options.Iterations);
  }

  // A smooth surface through the middle of noise encloses too much or too little where it is
  // curved: the points are moved along their normals by what the volume lacks.
  void MatchVolume()
  {
    const SurfaceModel surface = this->Solver.Surface();
    const double offset = (this->MeshVolume - surface.Volume()) / surface.Area();
    for (std::size_t i = 0; i < this->Samples.Points.size(); ++i)
    {
      this->Samples.Points[i] += offset * this->Samples.Normals[i];
    }
    this->Solver.FitNormals(this->Samples, this->Options.Iterations);
  }

  Status SlideBy(const std::vector<Vector3>& steps)
  {
    constexpr double LongestStep = 0.15; // rad
    constexpr double LeastShare = 0.5;   // of a triangle's area on the sphere
    DirectionSlide slide;
    return SlideDirections(this->Mesh.Triangles, steps, LongestStep, LeastShare, this->Parameters,
                           slide);
  }

  // Moves each vertex towards the parameter of its nearest point.
  Status Slide()
  {
    this->Evaluate(this->Solver.Surface(), this->Parameters);
    std::vector<Vector3> steps(this->Parameters.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      steps[i] = StepTowards(this->Target.Points[i], this->State[i]);
    }
    return this->SlideBy(steps);
  }

  bool FindRemedy(const SurfaceModel& surface, CrossingRemedy& remedy) const
  {
    return FindCrossingRemedy(surface, this->Samples, this->Parameters.size(), remedy).IsOk();
  }

  // Pleats become as smooth as the surface is at a lower degree.
  Status Apply(const CrossingRemedy& remedy, int degreeOfPleats)
  {
    constexpr double LargestWeight = 16.0;
    constexpr int Evenings = 2;
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      this->Target.Points[i] += remedy.Shifts[i] * this->Samples.Normals[i];
    }
    this->Stiffen(remedy.IsPleated, LargestWeight);
    Status status = Status::Success();
    if (remedy.HasPleats())
    {
      if (degreeOfPleats < this->Options.Degree)
      {
        this->MoveToDegree(remedy.IsPleated, degreeOfPleats);
      }
      status = this->Slide();
      for (int evening = 0; evening < Evenings && status.IsOk(); ++evening)
      {
        status = this->Even(remedy.IsPleated);
      }
    }
    return status.IsOk() ? this->Start() : status;
  }

  // Moves these vertices onto the surface truncated to a degree.
  void MoveToDegree(const std::vector<char>& isChosen, int degree)
  {
    constexpr int LowestDegree = 2;
    this->Evaluate(this->Solver.Surface().WithDegree(std::max(degree, LowestDegree)),
                   this->Parameters);
    for (std::size_t i = 0; i < isChosen.size(); ++i)
    {
      this->Target.Points[i] = isChosen[i] != 0 ? this->State[i].Point : this->Target.Points[i];
    }
  }

  // Moves these vertices' parameters half of the way to the means of their neighbours'.
  Status Even(const std::vector<char>& isChosen)
  {
    constexpr double Share = 0.5;
    std::vector<Vector3> sums(isChosen.size(), Vector3::Zero());
    std::vector<int> counts(isChosen.size());
    for (const std::array<int, 3>& t : this->Mesh.Triangles)
    {
      Vector3 sum = Vector3::Zero();
      for (const int corner : t)
      {
        sum += this->Parameters[static_cast<std::size_t>(corner)];
      }
      for (const int corner : t)
      {
        const auto i = static_cast<std::size_t>(corner);
        sums[i] += sum - this->Parameters[i];
        counts[i] += 2;
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] = isChosen[i] != 0 && counts[i] > 0
                    ? Vector3(Share * (sums[i] / counts[i] - this->Parameters[i]))
                    : Vector3(Vector3::Zero());
    }
    return this->SlideBy(sums);
  }

  // Vertices whose tangents are to be stiffened. A few folds can be ironed out by more weight than
  // the normals have; many are the two sides of a cut, which no weight keeps apart.
  struct Narrow
  {
    double AreaRatio; // to the mean area element; at most
    double LargestWeight;
    std::size_t MostVertices;
  };

  void Stiffen(const std::vector<char>& isChosen, double largestWeight)
  {
    constexpr double Stiffer = 5.0;
    for (std::size_t i = 0; i < isChosen.size(); ++i)
    {
      double& weight = this->VertexWeights[i];
      weight =
          isChosen[i] != 0 ? std::max(weight, std::min(largestWeight, Stiffer * weight)) : weight;
    }
  }

  // Stiffens the tangents around them; returns false if there is none, or too many.
  bool Stiffen(const Narrow& narrow)
  {
    this->Evaluate(this->Solver.Surface(), this->Parameters);
    std::vector<double> elements(this->Parameters.size());
    double mean = 0.0;
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      elements[i] = this->AreaElementAt(i);
      mean += this->Samples.Weights[i] * elements[i];
    }
    std::vector<char> near(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      near[i] = elements[i] <= narrow.AreaRatio * mean ? 1 : 0;
    }
    const auto count = static_cast<std::size_t>(std::count(near.begin(), near.end(), 1));
    if (count == 0 || count > narrow.MostVertices)
    {
      return false;
    }
    for (int ring = 0; ring < 2; ++ring)
    {
      std::vector<char> wider = near;
      for (const std::array<int, 3>& t : this->Mesh.Triangles)
      {
        const bool touches = std::any_of(t.begin(), t.end(),
                                         [&near](int corner)
                                         { return near[static_cast<std::size_t>(corner)] != 0; });
        for (const int corner : t)
        {
          wider[static_cast<std::size_t>(corner)] |= touches ? 1 : 0;
        }
      }
      near = wider;
    }
    this->Stiffen(near, narrow.LargestWeight);
    return true;
  }

  const IndexedMesh& Mesh;
  IndexedMesh Target; // the same with vertices moved where fits of it cross themselves
  const SurfaceModelFitOptions& Options;
  std::vector<Vector3> Parameters; // of the vertices
  Fit Fitted;
  SurfaceSamples Samples;
  SurfaceModelSolver Solver;
  double MeshVolume;                 // mm^3
  std::vector<Sample> State;         // of the surface at some of the parameters
  std::vector<double> VertexWeights; // of tangential residuals
};
} // namespace

Status FitSurfaceModel(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
                       const SurfaceModelFitOptions& options, SurfaceModelFitResult& result,
                       const KernelProgress& progress)
{
  Run run(mesh, parameters, options);
  Status status = run.Start();
  if (status.IsOk() && options.Degree > 0)
  {
    status = run.Place(result);
  }
  for (int round = 0; status.IsOk() && round < options.Refits; ++round)
  {
    if (progress && !progress((round + 1.0) / (options.Refits + 1.0)))
    {
      return Status::Failure("cancelled");
    }
    status = run.Refit();
  }
  if (!status.IsOk())
  {
    return status;
  }
  if (options.Refits > 0)
  {
    run.Complete();
  }
  run.Keep();
  if (std::min(options.Refits, options.MostSeparations) > 0 && !run.RemoveCrossings(progress))
  {
    return Status::Failure("cancelled");
  }
  run.Finish(result);
  return status;
}
} // namespace palpate
