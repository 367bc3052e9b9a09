#include "ParametricFit.h"

#include "ParametricSolver.h"
#include "SurfaceSamples.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
using Sample = ParametricSphericalSurface::Sample;

// Area element of the surface over that of the parameter sphere, along the normal of the mesh.
double AreaElement(const Sample& sample, const Vector3& normal)
{
  return sample.First[0].cross(sample.First[1]).dot(normal);
}

// The tangent step (rad) of the parameter that brings the surface nearest to a point, by a damped
// Gauss-Newton step.
Vector3 StepTowards(const Vector3& point, const Sample& sample)
{
  constexpr double Damping = 1e-3; // of the squared stretch
  const Vector3 left = point - sample.Point;
  const Vector3& a = sample.First[0];
  const Vector3& b = sample.First[1];
  const double damping = Damping * (a.squaredNorm() + b.squaredNorm()) + 1e-300;
  const double aa = a.squaredNorm() + damping;
  const double bb = b.squaredNorm() + damping;
  const double ab = a.dot(b);
  const double determinant = aa * bb - ab * ab;
  const double alongA = (bb * a.dot(left) - ab * b.dot(left)) / determinant;
  const double alongB = (aa * b.dot(left) - ab * a.dot(left)) / determinant;
  return alongA * sample.Tangents[0] + alongB * sample.Tangents[1];
}

double Determinant(const std::vector<Vector3>& q, const std::array<int, 3>& t)
{
  return q[static_cast<std::size_t>(t[0])].dot(
      q[static_cast<std::size_t>(t[1])].cross(q[static_cast<std::size_t>(t[2])]));
}

// A third of the shortest wavelength of a degree, on the parameter sphere.
double LongestEdgeFor(int degree)
{
  return 2.0 * M_PI / (3.0 * std::max(degree, 1));
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
      const ParametricFitOptions& options)
      : Mesh(mesh), Options(options), Parameters(parameters), Solver(options.Degree, options.Ridge),
        MeshVolume(VolumeOf(mesh))
  {
  }

  bool Start()
  {
    this->Samples = SampleMesh(this->Mesh, this->Parameters, LongestEdgeFor(this->Options.Degree));
    return this->Solver.FitPoints(this->Samples);
  }

  bool Refit()
  {
    this->Slide();
    if (!this->Start())
    {
      return false;
    }
    this->VertexWeights.assign(this->Mesh.Points.size(), this->Options.TangentWeight);
    this->FitNormals();
    return true;
  }

  // After the last refit.
  void Complete()
  {
    constexpr int MostRepeats = 3;
    for (int repeat = 0; repeat < MostRepeats && this->StiffenFolds(); ++repeat)
    {
      this->FitNormals();
    }
    this->MatchVolume();
  }

  void Finish(ParametricFitResult& result)
  {
    result.Surface = this->Solver.Surface();
    this->Evaluate(this->Samples.Parameters);
    double squares = 0.0;
    result.Folded = 0;
    for (std::size_t i = 0; i < this->Samples.Points.size(); ++i)
    {
      const double off =
          this->Samples.Normals[i].dot(this->State[i].Point - this->Samples.Points[i]);
      squares += this->Samples.Weights[i] * off * off;
      result.Folded += i >= this->Parameters.size() || this->AreaElementAt(i) > 0.0 ? 0 : 1;
    }
    result.NormalRms = std::sqrt(squares);
    result.Parameters = this->Parameters;
  }

private:
  void Evaluate(const std::vector<Vector3>& parameters)
  {
    this->State.resize(parameters.size());
    this->Solver.Surface().EvaluateBatch(parameters.data(), parameters.size(), this->State.data());
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
    const ParametricSphericalSurface surface = this->Solver.Surface();
    const double offset = (this->MeshVolume - surface.Volume()) / surface.Area();
    for (std::size_t i = 0; i < this->Samples.Points.size(); ++i)
    {
      this->Samples.Points[i] += offset * this->Samples.Normals[i];
    }
    this->Solver.FitNormals(this->Samples, this->Options.Iterations);
  }

  // Moves each vertex towards the parameter of its nearest point.
  void Slide()
  {
    constexpr double LongestStep = 0.15; // rad
    this->Evaluate(this->Parameters);
    std::vector<Vector3> steps(this->Parameters.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      steps[i] = StepTowards(this->Mesh.Points[i], this->State[i]);
      const double length = steps[i].norm();
      steps[i] *= length > LongestStep ? LongestStep / length : 1.0;
    }
    this->ApplySteps(steps);
  }

  // Halves steps, and finally omits them, where a triangle would lose nine tenths of its area.
  void ApplySteps(std::vector<Vector3>& steps)
  {
    constexpr int MostRounds = 8;
    const std::vector<Vector3> before = this->Parameters;
    for (int round = 0; round <= MostRounds; ++round)
    {
      std::vector<Vector3>& q = this->Parameters;
      for (std::size_t i = 0; i < q.size(); ++i)
      {
        q[i] = (before[i] + steps[i]).normalized();
      }
      bool isFree = true;
      for (const std::array<int, 3>& t : this->Mesh.Triangles)
      {
        if (!(Determinant(q, t) >= 0.1 * Determinant(before, t)))
        {
          isFree = false;
          for (const int corner : t)
          {
            steps[static_cast<std::size_t>(corner)] *= round + 1 < MostRounds ? 0.5 : 0.0;
          }
        }
      }
      if (isFree)
      {
        return;
      }
    }
    this->Parameters = before;
  }

  // Stiffens the tangents around folds; returns false if there is none.
  bool StiffenFolds()
  {
    constexpr double Stiffer = 5.0;
    if (this->Options.LeastAreaRatio <= 0.0)
    {
      return false;
    }
    this->Evaluate(this->Parameters);
    std::vector<double> elements(this->Parameters.size());
    double mean = 0.0;
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      elements[i] = this->AreaElementAt(i);
      mean += this->Samples.Weights[i] * elements[i];
    }
    std::vector<char> near(elements.size());
    bool isFolded = false;
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      near[i] = elements[i] < this->Options.LeastAreaRatio * mean ? 1 : 0;
      isFolded = isFolded || near[i] != 0;
    }
    for (int ring = 0; isFolded && ring < 2; ++ring)
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
    for (std::size_t i = 0; i < near.size(); ++i)
    {
      double& weight = this->VertexWeights[i];
      weight = near[i] != 0 ? std::min(1.0, Stiffer * weight) : weight;
    }
    return isFolded;
  }

  const IndexedMesh& Mesh;
  const ParametricFitOptions& Options;
  std::vector<Vector3> Parameters; // of the vertices
  SurfaceSamples Samples;
  ParametricSolver Solver;
  double MeshVolume;                 // mm^3
  std::vector<Sample> State;         // of the surface at some of the parameters
  std::vector<double> VertexWeights; // of tangential residuals
};
} // namespace

Status FitParametricSurface(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
                            const ParametricFitOptions& options, ParametricFitResult& result,
                            const KernelProgress& progress)
{
  const auto isCancelled = [&](int done)
  { return progress && !progress(static_cast<double>(done) / (options.Refits + 1)); };
  Run run(mesh, parameters, options);
  bool isDetermined = run.Start();
  for (int round = 0; isDetermined && round < options.Refits; ++round)
  {
    if (isCancelled(round + 1))
    {
      return Status::Failure("cancelled");
    }
    isDetermined = run.Refit();
  }
  if (!isDetermined)
  {
    return Status::Failure("the parameters of the mesh do not determine a surface of degree " +
                           std::to_string(options.Degree));
  }
  if (options.Refits > 0)
  {
    run.Complete();
  }
  run.Finish(result);
  return Status::Success();
}
} // namespace palpate
