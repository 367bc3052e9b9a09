#include "ChordDescent.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Along the great circle of a tangent.
Vector3 Along(const Vector3& parameter, const Vector3& tangent)
{
  const double angle = tangent.norm();
  const double share = angle > 1e-8 ? std::sin(angle) / angle : 1.0;
  return (std::cos(angle) * parameter + share * tangent).normalized();
}

Eigen::Matrix<double, 3, 2> SlopesOf(const SurfaceModel::SecondOrderSample& sample)
{
  Eigen::Matrix<double, 3, 2> slopes;
  slopes << sample.First[0], sample.First[1];
  return slopes;
}

bool IsPositive(const Eigen::Matrix2d& block)
{
  return block.trace() > 0.0 && block.determinant() > 1e-14 * block.trace() * block.trace();
}
} // namespace

ChordDescent::ChordDescent(const SurfaceModel& surface, std::vector<Vector3> parameters)
    : Surface(surface), Nodes(std::move(parameters)), Samples(this->At(this->Nodes))
{
}

std::vector<ChordDescent::Sample> ChordDescent::At(const std::vector<Vector3>& nodes) const
{
  std::vector<Sample> samples(nodes.size());
  this->Surface.EvaluateSecondOrderBatch(nodes.data(), nodes.size(), samples.data());
  return samples;
}

double ChordDescent::SumOf(const std::vector<Sample>& samples) noexcept
{
  double sum = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k)
  {
    sum += (samples[k].Point - samples[k - 1].Point).squaredNorm();
  }
  return sum;
}

std::vector<Vector3> ChordDescent::Points() const
{
  std::vector<Vector3> points;
  for (const Sample& sample : this->Samples)
  {
    points.push_back(sample.Point);
  }
  return points;
}

double ChordDescent::Length() const noexcept
{
  double length = 0.0;
  for (std::size_t k = 1; k < this->Samples.size(); ++k)
  {
    length += (this->Samples[k].Point - this->Samples[k - 1].Point).norm();
  }
  return length;
}

ChordDescent::Step ChordDescent::Slope(std::size_t node) const noexcept
{
  const Vector3 bend = 2.0 * this->Samples[node].Point - this->Samples[node - 1].Point -
                       this->Samples[node + 1].Point;
  return SlopesOf(this->Samples[node]).transpose() * bend;
}

ChordDescent::Block ChordDescent::Diagonal(std::size_t node, bool isNewton) const noexcept
{
  const Sample& sample = this->Samples[node];
  const auto slopes = SlopesOf(sample);
  Block block = 2.0 * slopes.transpose() * slopes;
  if (isNewton)
  {
    const Vector3 bend =
        2.0 * sample.Point - this->Samples[node - 1].Point - this->Samples[node + 1].Point;
    const double mixed = bend.dot(sample.Second[1]);
    block(0, 0) += bend.dot(sample.Second[0]);
    block(0, 1) += mixed;
    block(1, 0) += mixed;
    block(1, 1) += bend.dot(sample.Second[2]);
    return block;
  }
  constexpr double Damping = 1e-9; // parameters where the surface has no tangent plane stay
  block.diagonal().array() += Damping * block.trace() + 1e-300;
  return block;
}

// By elimination from node to node, of blocks; false where the matrix is not positive definite.
bool ChordDescent::Solve(bool isNewton, std::vector<Step>& steps) const
{
  const std::size_t last = this->Nodes.size() - 1;
  std::vector<Block> inverses(last);
  std::vector<Block> links(last); // between a node and the next one
  steps.assign(last + 1, Step::Zero());
  for (std::size_t k = 1; k < last; ++k)
  {
    Block block = this->Diagonal(k, isNewton);
    Step right = -this->Slope(k);
    if (k > 1)
    {
      block -= links[k - 1].transpose() * inverses[k - 1] * links[k - 1];
      right -= links[k - 1].transpose() * inverses[k - 1] * steps[k - 1];
    }
    if (!IsPositive(block))
    {
      return false;
    }
    inverses[k] = block.inverse();
    links[k] = -SlopesOf(this->Samples[k]).transpose() * SlopesOf(this->Samples[k + 1]);
    steps[k] = right;
  }
  for (std::size_t k = last - 1; k >= 1; --k)
  {
    steps[k] = inverses[k] *
               (steps[k] - (k + 1 < last ? Step(links[k] * steps[k + 1]) : Step(Step::Zero())));
  }
  return true;
}

// The step, or the first of its halves that makes the sum smaller.
bool ChordDescent::Improve(const std::vector<Step>& steps, double& gain)
{
  constexpr double LargestTurn = 0.3; // rad: beyond, the surface is another one
  constexpr int Halves = 20;
  double largest = 0.0;
  for (const Step& step : steps)
  {
    largest = std::max(largest, step.norm());
  }
  const double before = SumOf(this->Samples);
  double scale = largest > LargestTurn ? LargestTurn / largest : 1.0;
  for (int i = 0; i < Halves; ++i, scale *= 0.5)
  {
    std::vector<Vector3> moved = this->Nodes;
    for (std::size_t k = 1; k + 1 < moved.size(); ++k)
    {
      moved[k] = Along(moved[k], scale * (steps[k][0] * this->Samples[k].Tangents[0] +
                                          steps[k][1] * this->Samples[k].Tangents[1]));
    }
    std::vector<Sample> samples = this->At(moved);
    const double after = SumOf(samples);
    if (after < before)
    {
      gain = (before - after) / before;
      this->Nodes = std::move(moved);
      this->Samples = std::move(samples);
      return true;
    }
  }
  return false;
}

bool ChordDescent::Run(int mostSteps)
{
  constexpr double LeastGain = 1e-15;
  std::vector<Step> steps;
  for (int i = 0; i<mostSteps&& this->Nodes.size()> 2; ++i)
  {
    double gain = 0.0;
    const bool isSolved = this->Solve(true, steps) || this->Solve(false, steps);
    if (!isSolved || !this->Improve(steps, gain) || gain < LeastGain)
    {
      return isSolved;
    }
  }
  return this->Nodes.size() <= 2;
}
} // namespace palpate
