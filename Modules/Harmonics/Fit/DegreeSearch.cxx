#include "DegreeSearch.h"

#include "DecimalText.h"

#include <algorithm>
#include <string>

namespace palpate
{
namespace
{
Status MissedTolerance(const DegreeSearch& search, int highest, double rms)
{
  const std::string degree = std::to_string(highest);
  return Status::Failure("no degree up to " + degree + " meets the tolerance of " +
                         SignificantAgainstLimit(search.Tolerance, search.Tolerance, 3) +
                         " mm; degree " + degree + " leaves " +
                         SignificantAgainstLimit(rms, search.Tolerance, 3) +
                         " mm; allow a larger tolerance or degree");
}
} // namespace

Status FindDegree(const RadialSamples& samples, RadialModelFitOptions options,
                  const DegreeSearch& search, int& found)
{
  const bool isBounded = search.Supported <= search.Maximum;
  const int highest = std::max(std::min(search.Maximum, search.Supported), search.Least);
  options.PenaltyKind = RadialModelFitOptions::Penalty::None;
  options.RobustKind = RadialModelFitOptions::Robust::None;
  // A moderate degree first, because the work grows with the degree's fourth power.
  options.Degree = std::min(std::max(12, search.Least), highest);
  while (true)
  {
    RadialModelFitResult result;
    if (Status status = FitRadialModel(samples, options, result); !status.IsOk())
    {
      return status;
    }
    const auto first =
        std::find_if(result.RmsByDegree.begin() + search.Least, result.RmsByDegree.end(),
                     [&search](double rms) { return rms <= search.Tolerance; });
    if (first != result.RmsByDegree.end() || (options.Degree == highest && isBounded))
    {
      found = first != result.RmsByDegree.end()
                  ? static_cast<int>(first - result.RmsByDegree.begin())
                  : highest;
      return Status::Success();
    }
    if (options.Degree == highest)
    {
      return MissedTolerance(search, highest, result.RmsByDegree.back());
    }
    options.Degree = std::min(highest, options.Degree * 3 / 2);
  }
}
} // namespace palpate
