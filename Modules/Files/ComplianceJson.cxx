#include "ComplianceJson.h"

#include "JsonNumbers.h"
#include "Refusal.h"
#include "SphericalHarmonicBasis.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

[[noreturn]] void RefuseEntry(const std::string& fileName, const std::string& key)
{
  Refuse(fileName,
         "is not a model that Palpate can read: the entry \"" + key +
             "\" of its elasticity is missing or is not what it has to be",
         "write it again with palpate soften");
}

const Json& Entry(const Json& parent, const char* key, const std::string& fileName)
{
  if (!parent.is_object() || !parent.contains(key))
  {
    RefuseEntry(fileName, key);
  }
  return parent[key];
}

double Number(const Json& parent, const char* key, const std::string& fileName)
{
  const Json& entry = Entry(parent, key, fileName);
  if (!entry.is_number() || !std::isfinite(entry.get<double>()))
  {
    RefuseEntry(fileName, key);
  }
  return entry.get<double>();
}

std::vector<double> Numbers(const Json& entry, std::size_t count, const std::string& key,
                            const std::string& fileName)
{
  if (!entry.is_array() || entry.size() != count)
  {
    RefuseEntry(fileName, key);
  }
  std::vector<double> values;
  values.reserve(count);
  for (const Json& value : entry)
  {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
    {
      RefuseEntry(fileName, key);
    }
    values.push_back(value.get<double>());
  }
  return values;
}

constexpr const char* ComplianceKey = "compliance_mm2_per_n";
constexpr const char* CurvatureKey = "mean_curvature_per_mm";
constexpr const char* WavesKey = "long_waves";
constexpr const char* RootsKey = "roots";
constexpr const char* RowsKey = "rows";

// A text for each row below the diagonal: numbers in arrays would take a line each.
Json WavesAsJson(const PackedCompliance& waves)
{
  Json entry;
  entry["degree"] = waves.Degree;
  entry[RootsKey] = waves.Roots;
  Json& rows = entry[RowsKey] = Json::array();
  std::size_t next = 0;
  for (std::size_t row = 1; row < waves.Roots.size(); ++row)
  {
    std::string text;
    for (std::size_t column = 0; column < row; ++column)
    {
      text += (column > 0 ? " " : "") + std::to_string(waves.Relative[next++]);
    }
    rows.push_back(std::move(text));
  }
  return entry;
}

// Appends whole numbers with one space between them; false for any other text.
bool AppendRow(const std::string& text, std::vector<std::int16_t>& numbers)
{
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true)
  {
    std::int16_t number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error != std::errc())
    {
      return false;
    }
    numbers.push_back(number);
    if (after == end)
    {
      return true;
    }
    if (*after != ' ')
    {
      return false;
    }
    at = after + 1;
  }
}

int Degree(const Json& parent, int most, const std::string& fileName)
{
  const Json& degree = Entry(parent, "degree", fileName);
  if (!degree.is_number_unsigned() ||
      degree.get<std::uint64_t>() > static_cast<std::uint64_t>(most))
  {
    RefuseEntry(fileName, "degree");
  }
  return degree.get<int>();
}

PackedCompliance WavesFromJson(const Json& entry, const std::string& fileName)
{
  PackedCompliance waves;
  waves.Degree = Degree(entry, ReducedCompliance::MostDegree, fileName);
  const std::size_t count = 3 * SphericalHarmonicBasis::CoefficientCount(waves.Degree);
  waves.Roots = Numbers(Entry(entry, RootsKey, fileName), count, RootsKey, fileName);
  const Json& rows = Entry(entry, RowsKey, fileName);
  if (!rows.is_array() || rows.size() != count - 1)
  {
    RefuseEntry(fileName, RowsKey);
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    if (!rows[row].is_string() ||
        !AppendRow(rows[row].get_ref<const std::string&>(), waves.Relative) ||
        waves.Relative.size() != (row + 1) * (row + 2) / 2)
    {
      RefuseEntry(fileName, RowsKey);
    }
  }
  return waves;
}
} // namespace

Json ComplianceAsJson(const ComplianceMaps& maps, const std::string& fileName)
{
  RequireInput(maps.Check(), fileName);
  Json entry;
  entry["degree"] = maps.Degree;
  entry["largest_patch_mm"] = maps.LargestPatch;
  entry["poisson_ratio"] = maps.PoissonRatio;
  entry[ComplianceKey] = Json::array();
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    entry[ComplianceKey].push_back(maps.Coefficients[term]);
  }
  entry[CurvatureKey] = maps.Coefficients[PatchCompliance::Terms];
  if (!maps.LongWaves.IsEmpty())
  {
    entry[WavesKey] = WavesAsJson(maps.LongWaves);
  }
  Json& error = entry["fit_error"];
  error["rms"] = maps.FitError.Rms;
  error["largest"] = maps.FitError.Largest;
  error["patch_mm"] = maps.FitError.PatchRadius;
  error["direction"] = PointJson(maps.FitError.Worst);
  return entry;
}

ComplianceMaps ComplianceFromJson(const Json& entry, const std::string& fileName)
{
  ComplianceMaps maps;
  maps.Degree = Degree(entry, ComplianceMaps::MostDegree, fileName);
  maps.LargestPatch = Number(entry, "largest_patch_mm", fileName);
  maps.PoissonRatio = Number(entry, "poisson_ratio", fileName);
  const std::size_t count = SphericalHarmonicBasis::CoefficientCount(maps.Degree);
  const Json& terms = Entry(entry, ComplianceKey, fileName);
  if (!terms.is_array() || terms.size() != PatchCompliance::Terms)
  {
    RefuseEntry(fileName, ComplianceKey);
  }
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    maps.Coefficients[term] = Numbers(terms[term], count, ComplianceKey, fileName);
  }
  maps.Coefficients[PatchCompliance::Terms] =
      Numbers(Entry(entry, CurvatureKey, fileName), count, CurvatureKey, fileName);
  if (entry.contains(WavesKey))
  {
    maps.LongWaves = WavesFromJson(entry[WavesKey], fileName);
  }
  const Json& error = Entry(entry, "fit_error", fileName);
  maps.FitError.Rms = Number(error, "rms", fileName);
  maps.FitError.Largest = Number(error, "largest", fileName);
  maps.FitError.PatchRadius = Number(error, "patch_mm", fileName);
  const std::vector<double> direction =
      Numbers(Entry(error, "direction", fileName), 3, "direction", fileName);
  maps.FitError.Worst = Vector3(direction[0], direction[1], direction[2]);
  RequireInput(maps.Check(), fileName);
  return maps;
}
} // namespace palpate
