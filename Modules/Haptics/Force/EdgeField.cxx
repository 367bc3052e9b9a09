#include "EdgeField.h"

#include "FieldBuilder.h"
#include "FieldSampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// The steepest place has the largest force, whatever the energy: more than any edge needs.
constexpr double AmpleEnergy = 1e6; // N mm
constexpr double Crest = 0.95;      // of the gradients above the median
// An edge is that much steeper than the median place; that of noise alone is twice as steep.
constexpr double Prominence = 3.0;
constexpr double Rounding = 1e-6; // 1/mm, of the largest value

struct Gradients
{
  std::vector<float> Lengths;
  double LargestValue = 0.0;
};

Gradients GradientsOf(const std::shared_ptr<const ScalarField>& image)
{
  const FieldSampler sampler(image);
  const FieldGrid& grid = image->Grid();
  Gradients made;
  for (int k = 0; k < grid.Size()[2]; ++k)
  {
    for (int j = 0; j < grid.Size()[1]; ++j)
    {
      for (int i = 0; i < grid.Size()[0]; ++i)
      {
        const auto at = sampler.ValueAndGradientIndex(0, Vector3(i, j, k));
        made.Lengths.push_back(static_cast<float>(grid.GradientWorld(at.Gradient).norm()));
        made.LargestValue = std::max(made.LargestValue, std::abs(at.Value));
      }
    }
  }
  return made;
}
} // namespace

Status MakeEdgeForce(const std::shared_ptr<const ScalarField>& image, const EdgeSettings& settings,
                     std::shared_ptr<const GuidingGradient>& made)
{
  const Gradients found = GradientsOf(image);
  std::vector<float> sorted = found.Lengths;
  std::sort(sorted.begin(), sorted.end());
  const float median = sorted[sorted.size() / 2];
  const auto above = std::upper_bound(sorted.begin(), sorted.end(), median);
  const double rest = static_cast<double>(sorted.end() - above);
  const float crest = rest > 0.0 ? above[static_cast<std::ptrdiff_t>(Crest * rest)] : median;
  if (!(crest > Prominence * median && crest > Rounding * found.LargestValue))
  {
    return Status::Failure("The image has no edges here.");
  }
  FieldBuilder builder(image->Grid());
  builder.AddChannel(SamplesOfGrid(found.Lengths.data(), image->Grid()));
  builder.KeepAll();
  builder.SetInterpolation(FieldInterpolation::TricubicBSpline);
  std::shared_ptr<const ScalarField> edges;
  Status status = builder.Build(edges);
  const GuidingSettings guiding{median, crest, AmpleEnergy, settings.LargestForce, settings.Fade};
  return status.IsOk() ? GuidingGradient::Make(edges, 0, guiding, made) : status;
}
} // namespace palpate
