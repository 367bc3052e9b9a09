#include "CorrectionFile.h"

#include "JsonNumbers.h"
#include "JsonText.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
constexpr const char* CorrectionFormat = "palpate-corrections";
constexpr int CorrectionVersion = 1;
constexpr const char* CorrectionKind = "a list of palpate correct";
constexpr const char* CorrectionRemedy = "write one with palpate correct --output";
constexpr std::uintmax_t MostCorrectionBytes = 1U << 20U;
constexpr std::size_t MostSteps = 1100;

struct StepJson
{
  nlohmann::ordered_json operator()(const SurfacePull& pull) const
  {
    nlohmann::ordered_json json{{"do", "pull"}, {"place_mm", PointJson(pull.PlaceWorld)}};
    if (pull.TargetWorld)
    {
      json["target_mm"] = PointJson(*pull.TargetWorld);
    }
    else
    {
      json["displacement_mm"] = pull.Displacement;
    }
    json["width_mm"] = pull.Width;
    if (pull.SecondWidth > 0.0)
    {
      json["second_width_mm"] = pull.SecondWidth;
    }
    return json;
  }
  nlohmann::ordered_json operator()(const IslandRemoval&) const { return {{"do", "islands"}}; }
  nlohmann::ordered_json operator()(const CavityFilling&) const { return {{"do", "fill"}}; }
  nlohmann::ordered_json operator()(const SurfaceSmoothing& smoothing) const
  {
    return {{"do", "smooth"}, {"deviation_mm", smoothing.Deviation}};
  }
  nlohmann::ordered_json operator()(const PlaneCut& cut) const
  {
    return {
        {"do", "cut"}, {"point_mm", PointJson(cut.PointWorld)}, {"normal", PointJson(cut.Normal)}};
  }
};

class StepReader
{
public:
  explicit StepReader(const std::filesystem::path& file) : Numbers(file, CorrectionRemedy) {}

  const JsonNumbers& Reader() const { return this->Numbers; }
  CorrectionStep Read(const nlohmann::json& json) const
  {
    this->Numbers.Require(json.is_object() && json.contains("do") && json.at("do").is_string(),
                          "has a step without \"do\"");
    const std::string kind = json.at("do");
    if (kind == "pull")
    {
      return this->ReadPull(json);
    }
    if (kind == "smooth")
    {
      return SurfaceSmoothing{this->Numbers.Number(json, "deviation_mm")};
    }
    if (kind == "cut")
    {
      return PlaneCut{this->Triple(json, "point_mm"), this->Triple(json, "normal")};
    }
    this->Numbers.Require(kind == "islands" || kind == "fill",
                          "has a step that is no pull, islands, fill, smooth or cut");
    return kind == "islands" ? CorrectionStep(IslandRemoval{}) : CorrectionStep(CavityFilling{});
  }

private:
  Vector3 Triple(const nlohmann::json& json, const char* key) const
  {
    const std::vector<double> numbers = this->Numbers.Numbers(json, key);
    this->Numbers.Require(numbers.size() == 3, std::string("has a ") + key + " not of 3 numbers");
    return {numbers[0], numbers[1], numbers[2]};
  }
  SurfacePull ReadPull(const nlohmann::json& json) const
  {
    SurfacePull pull;
    pull.PlaceWorld = this->Triple(json, "place_mm");
    pull.Width = this->Numbers.Number(json, "width_mm");
    if (json.contains("target_mm"))
    {
      pull.TargetWorld = this->Triple(json, "target_mm");
    }
    else
    {
      pull.Displacement = this->Numbers.Number(json, "displacement_mm");
    }
    if (json.contains("second_width_mm"))
    {
      pull.SecondWidth = this->Numbers.Number(json, "second_width_mm");
    }
    return pull;
  }

  JsonNumbers Numbers;
};
} // namespace

nlohmann::ordered_json CorrectionJson(const std::vector<CorrectionStep>& steps)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CorrectionStep& step : steps)
  {
    list.push_back(std::visit(StepJson(), step));
  }
  return list;
}

void WriteCorrections(const std::vector<CorrectionStep>& steps, const std::filesystem::path& file)
{
  const nlohmann::ordered_json json{{"format", CorrectionFormat},
                                    {"version", CorrectionVersion},
                                    {"frame", "patient LPS"},
                                    {"steps", CorrectionJson(steps)}};
  WriteWholeFile(file, json.dump(2) + "\n");
}

std::vector<CorrectionStep> ReadCorrections(const std::filesystem::path& file)
{
  const nlohmann::json json = ReadJson(file, MostCorrectionBytes, CorrectionRemedy);
  const JsonNumbers numbers(file, CorrectionRemedy);
  numbers.RequireFormat(json, CorrectionFormat, CorrectionVersion, CorrectionKind);
  return CorrectionsOf(numbers.List(json, "steps"), file);
}

std::vector<CorrectionStep> CorrectionsOf(const nlohmann::json& list,
                                          const std::filesystem::path& file)
{
  const StepReader reader(file);
  reader.Reader().Require(list.is_array(), "has steps that are not a list");
  reader.Reader().Require(list.size() <= MostSteps, "has more than 1,100 steps");
  std::vector<CorrectionStep> steps;
  for (const nlohmann::json& step : list)
  {
    steps.push_back(reader.Read(step));
  }
  return steps;
}
} // namespace palpate
