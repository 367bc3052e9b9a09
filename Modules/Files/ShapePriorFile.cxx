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
constexpr const char* RadialKind = "radial";
constexpr const char* SurfaceKind = "surface";

nlohmann::ordered_json HeadOf(const char* kind, const char* quantity, int degree, std::size_t cases)
{
  return {{"format", PriorFormat}, {"version", PriorVersion}, {"kind", kind},
          {"quantity", quantity},  {"frame", "patient LPS"},  {"degree", degree},
          {"cases", cases}};
}

template <typename Matrix>
nlohmann::ordered_json NumbersJson(const Matrix& matrix)
{
  return ShortNumbers(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

Eigen::VectorXd VectorIn(const std::vector<double>& numbers)
{
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

// Column by column.
Eigen::MatrixXd MatrixIn(const JsonNumbers& reader, const nlohmann::json& json, const char* key,
                         Eigen::Index rows)
{
  const std::vector<double> numbers = reader.Numbers(json, key);
  const auto count = static_cast<Eigen::Index>(numbers.size());
  reader.Require(rows > 0 && count % rows == 0, "has numbers that are not of its degree");
  return Eigen::Map<const Eigen::MatrixXd>(numbers.data(), rows, count / rows);
}

Eigen::MatrixXd TriangleIn(const JsonNumbers& reader, const nlohmann::json& json, const char* key,
                           Eigen::Index count)
{
  const std::vector<double> triangle = reader.Numbers(json, key);
  reader.Require(static_cast<Eigen::Index>(triangle.size()) == count * (count + 1) / 2,
                 "has numbers that are not of its degree");
  return SymmetricMatrix(triangle, count);
}

int DegreeIn(const JsonNumbers& reader, const nlohmann::json& json, int largest)
{
  const double degree = reader.Number(json, "degree");
  reader.Require(degree >= 1.0 && degree <= largest && degree == static_cast<int>(degree),
                 "has numbers that are not of its degree");
  return static_cast<int>(degree);
}

std::size_t CasesIn(const JsonNumbers& reader, const nlohmann::json& json)
{
  const double cases = reader.Number(json, "cases");
  reader.Require(cases >= 0.0 && cases < MostPriorCases, "has no number of cases");
  return static_cast<std::size_t>(cases);
}

ShapePrior RadialPriorIn(const JsonNumbers& reader, const nlohmann::json& json)
{
  const Eigen::Index degree = DegreeIn(reader, json, ShapePrior::LargestDegree);
  const std::size_t cases = CasesIn(reader, json);
  const std::vector<double> mean = reader.Numbers(json, "mean");
  const auto count = static_cast<Eigen::Index>(mean.size());
  reader.Require(count == (degree + 1) * (degree + 1), "has numbers that are not of its degree");
  ShapePrior prior;
  const Status status =
      ShapePrior::Of(VectorIn(mean), TriangleIn(reader, json, "covariance", count), cases, prior);
  reader.Require(status.IsOk(), status.Message());
  return prior;
}

nlohmann::ordered_json RelationJson(const OrganRelation& relation)
{
  return {{"organ", relation.Name},
          {"mean", NumbersJson(relation.Mean)},
          {"deviations", NumbersJson(relation.Deviations)},
          {"gain", NumbersJson(relation.Gain)},
          {"covariance", LowerTriangle(relation.Covariance)},
          {"offset", NumbersJson(relation.Offset)},
          {"wall_mean", NumbersJson(relation.WallMean)},
          {"wall_covariance", LowerTriangle(relation.WallCovariance)}};
}

OrganRelation RelationIn(const JsonNumbers& reader, const nlohmann::json& json, Eigen::Index asked)
{
  const nlohmann::json name = json.value("organ", nlohmann::json(""));
  reader.Require(name.is_string(), "has a relation to an organ whose name is none");
  OrganRelation relation;
  relation.Name = name;
  relation.Mean = VectorIn(reader.Numbers(json, "mean"));
  relation.Deviations = VectorIn(reader.Numbers(json, "deviations"));
  relation.Gain = MatrixIn(reader, json, "gain", asked);
  relation.Covariance = TriangleIn(reader, json, "covariance", asked);
  const std::vector<double> offset = reader.Numbers(json, "offset");
  reader.Require(offset.size() == 3, "has numbers that are not of its degree");
  relation.Offset = VectorIn(offset);
  relation.WallMean = VectorIn(reader.Numbers(json, "wall_mean"));
  relation.WallCovariance = TriangleIn(reader, json, "wall_covariance", OrganRelation::WallCount);
  return relation;
}

SurfacePrior SurfacePriorIn(const JsonNumbers& reader, const nlohmann::json& json)
{
  SurfacePrior prior;
  prior.Degree = DegreeIn(reader, json, SurfacePrior::LargestDegree);
  prior.CaseCount = CasesIn(reader, json);
  prior.Mean = VectorIn(reader.Numbers(json, "mean"));
  prior.Modes = MatrixIn(reader, json, "modes", prior.Mean.size());
  prior.Variances = VectorIn(reader.Numbers(json, "variances"));
  prior.Rest = VectorIn(reader.Numbers(json, "rest"));
  if (json.contains("relation"))
  {
    reader.Require(json["relation"].is_object(), "has a relation that is none");
    prior.Relation = RelationIn(reader, json["relation"], prior.Modes.cols() + 3);
  }
  const Status status = prior.Check();
  reader.Require(status.IsOk(), status.Message());
  return prior;
}
} // namespace

void WriteShapePrior(const ShapePrior& prior, const std::filesystem::path& file)
{
  nlohmann::ordered_json json =
      HeadOf(RadialKind, "ln(radius / mm)", prior.Degree(), prior.Cases());
  json["mean"] = NumbersJson(prior.Mean());
  json["covariance"] = LowerTriangle(prior.Covariance());
  WriteWholeFile(file, json.dump() + "\n");
}

void WriteShapePrior(const SurfacePrior& prior, const std::filesystem::path& file)
{
  nlohmann::ordered_json json = HeadOf(SurfaceKind, "mm", prior.Degree, prior.Cases());
  json["mean"] = NumbersJson(prior.Mean);
  json["modes"] = NumbersJson(prior.Modes);
  json["variances"] = NumbersJson(prior.Variances);
  json["rest"] = NumbersJson(prior.Rest);
  if (prior.Relation)
  {
    json["relation"] = RelationJson(*prior.Relation);
  }
  // A structure's name may be in another encoding.
  const auto handler = nlohmann::ordered_json::error_handler_t::replace;
  WriteWholeFile(file, json.dump(-1, ' ', false, handler) + "\n");
}

OrganPrior ReadOrganPrior(const std::filesystem::path& file)
{
  const nlohmann::json json = ReadJson(file, MostPriorBytes, PriorRemedy);
  const JsonNumbers reader(file, PriorRemedy);
  reader.RequireFormat(json, PriorFormat, PriorVersion, PriorKind);
  const nlohmann::json kind = json.value("kind", nlohmann::json(RadialKind));
  reader.Require(kind == RadialKind || kind == SurfaceKind, "is of another kind of prior");
  if (kind == SurfaceKind)
  {
    return std::make_shared<const SurfacePrior>(SurfacePriorIn(reader, json));
  }
  return std::make_shared<const ShapePrior>(RadialPriorIn(reader, json));
}
} // namespace palpate
