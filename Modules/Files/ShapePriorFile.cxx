#include "ShapePriorFile.h"

#include "JsonNumbers.h"
#include "JsonText.h"
#include "Refusal.h"
#include "WholeFile.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr const char* PriorFormat = "palpate shape prior";
constexpr int PriorVersion = 1;
constexpr const char* PriorKind = "a prior of palpate cohort --prior";
constexpr const char* PriorRemedy = "write one with palpate cohort --prior";
constexpr std::uintmax_t MostPriorBytes = 16U << 20U;
constexpr double MostPriorCases = 1e6;
} // namespace

void WriteShapePrior(const ShapePrior& prior, const std::filesystem::path& file)
{
  const auto count = static_cast<std::size_t>(prior.Size());
  const nlohmann::ordered_json json{{"format", PriorFormat},
                                    {"version", PriorVersion},
                                    {"quantity", "ln(radius / mm)"},
                                    {"frame", "patient LPS"},
                                    {"degree", prior.Degree()},
                                    {"cases", prior.Cases()},
                                    {"mean", ShortNumbers(prior.Mean().data(), count)},
                                    {"covariance", LowerTriangle(prior.Covariance())}};
  WriteWholeFile(file, json.dump() + "\n");
}

ShapePrior ReadShapePrior(const std::filesystem::path& file)
{
  const nlohmann::json json = ReadJson(file, MostPriorBytes, PriorRemedy);
  const JsonNumbers reader(file, PriorRemedy);
  reader.RequireFormat(json, PriorFormat, PriorVersion, PriorKind);
  const double degree = reader.Number(json, "degree");
  const double cases = reader.Number(json, "cases");
  const std::vector<double> mean = reader.Numbers(json, "mean");
  const std::vector<double> triangle = reader.Numbers(json, "covariance");
  const auto count = static_cast<Eigen::Index>(mean.size());
  reader.Require(degree >= 1.0 && degree <= ShapePrior::LargestDegree &&
                     static_cast<double>(count) == (degree + 1.0) * (degree + 1.0) &&
                     triangle.size() == mean.size() * (mean.size() + 1) / 2,
                 "has numbers that are not of its degree");
  reader.Require(cases >= 0.0 && cases < MostPriorCases, "has no number of cases");
  ShapePrior prior;
  const Status status =
      ShapePrior::Of(Eigen::Map<const Eigen::VectorXd>(mean.data(), count),
                     SymmetricMatrix(triangle, count), static_cast<std::size_t>(cases), prior);
  reader.Require(status.IsOk(), status.Message());
  return prior;
}
} // namespace palpate
