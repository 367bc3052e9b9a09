#include "CorrectionFile.h"

#include "JsonNumbers.h"
#include "JsonText.h"
#include "WholeFile.h"

#include <cmath>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* CorrectionFormat = "palpate-corrections";
constexpr int CorrectionVersion = 1;
constexpr const char* CorrectionKind = "a list of palpate correct";
constexpr const char* CorrectionRemedy = "write one with palpate correct --output";
constexpr std::uintmax_t MostCorrectionBytes = 16U << 20U;
constexpr std::size_t MostSteps = 1100;
constexpr double LargestIndex = 1e6;

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
  nlohmann::ordered_json operator()(const BrushStroke& stroke) const
  {
    nlohmann::ordered_json path = nlohmann::ordered_json::array();
    for (const Vector3& point : *stroke.PointsWorld)
    {
      path.insert(path.end(), {point.x(), point.y(), point.z()});
    }
    nlohmann::ordered_json json{
        {"do", stroke.Erases ? "erase" : "paint"}, {"path_mm", path}, {"radius_mm", stroke.Radius}};
    if (stroke.SliceNormal)
    {
      json["slice_normal"] = PointJson(*stroke.SliceNormal);
    }
    return json;
  }
  nlohmann::ordered_json operator()(const VoxelEdit& edit) const
  {
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const IndexRun& run : *edit.Runs)
    {
      runs.insert(runs.end(), {run.First[0], run.First[1], run.First[2], run.Count});
    }
    return {{"do", edit.Erases ? "remove_voxels" : "add_voxels"}, {"runs", runs}};
  }
  nlohmann::ordered_json operator()(const SliceCopy& copy) const
  {
    return {{"do", "copy_slice"}, {"axis", copy.Axis}, {"slices", {copy.From, copy.To}}};
  }
  nlohmann::ordered_json operator()(const SliceFilling& filling) const
  {
    return {
        {"do", "fill_between"}, {"axis", filling.Axis}, {"slices", {filling.First, filling.Last}}};
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
    if (kind == "paint" || kind == "erase")
    {
      return this->ReadStroke(json, kind == "erase");
    }
    if (kind == "add_voxels" || kind == "remove_voxels")
    {
      return this->ReadVoxels(json, kind == "remove_voxels");
    }
    if (kind == "copy_slice" || kind == "fill_between")
    {
      return this->ReadSlices(json, kind == "copy_slice");
    }
    this->Numbers.Require(kind == "islands" || kind == "fill",
                          "has a step that is no pull, islands, fill, smooth, cut, paint, erase, "
                          "add_voxels, remove_voxels, copy_slice or fill_between");
    return kind == "islands" ? CorrectionStep(IslandRemoval{}) : CorrectionStep(CavityFilling{});
  }

private:
  Vector3 Triple(const nlohmann::json& json, const char* key) const
  {
    const std::vector<double> numbers = this->Numbers.Numbers(json, key);
    this->Numbers.Require(numbers.size() == 3, std::string("has a ") + key + " not of 3 numbers");
    return {numbers[0], numbers[1], numbers[2]};
  }
  BrushStroke ReadStroke(const nlohmann::json& json, bool erases) const
  {
    const std::vector<double> numbers = this->Numbers.Numbers(json, "path_mm");
    this->Numbers.Require(!numbers.empty() && numbers.size() % 3 == 0 &&
                              numbers.size() / 3 <= BrushStroke::MostPoints,
                          "has a path_mm that is not of 1 to 10,000 triples");
    BrushStroke::Path path;
    for (std::size_t n = 0; n < numbers.size(); n += 3)
    {
      path.emplace_back(numbers[n], numbers[n + 1], numbers[n + 2]);
    }
    BrushStroke stroke;
    stroke.PointsWorld = std::make_shared<const BrushStroke::Path>(std::move(path));
    stroke.Radius = this->Numbers.Number(json, "radius_mm");
    stroke.Erases = erases;
    if (json.contains("slice_normal"))
    {
      stroke.SliceNormal = this->Triple(json, "slice_normal");
    }
    return stroke;
  }
  int Index(double number, const char* key) const
  {
    this->Numbers.Require(number >= 0.0 && number <= LargestIndex && number == std::floor(number),
                          std::string("has a number in ") + key + " that is no index");
    return static_cast<int>(number);
  }
  VoxelEdit ReadVoxels(const nlohmann::json& json, bool erases) const
  {
    const std::vector<double> numbers = this->Numbers.Numbers(json, "runs");
    this->Numbers.Require(numbers.size() % 4 == 0, "has runs that are not of 4 numbers each");
    std::vector<IndexRun> runs;
    for (std::size_t n = 0; n < numbers.size(); n += 4)
    {
      const auto at = [&](std::size_t m) { return this->Index(numbers[n + m], "runs"); };
      runs.push_back({{at(0), at(1), at(2)}, at(3)});
    }
    return {std::make_shared<const std::vector<IndexRun>>(std::move(runs)), erases};
  }
  CorrectionStep ReadSlices(const nlohmann::json& json, bool isCopy) const
  {
    const int axis = this->Index(this->Numbers.Number(json, "axis"), "axis");
    const std::vector<double> numbers = this->Numbers.Numbers(json, "slices");
    this->Numbers.Require(numbers.size() == 2, "has slices that are not two");
    const int first = this->Index(numbers[0], "slices");
    const int second = this->Index(numbers[1], "slices");
    return isCopy ? CorrectionStep(SliceCopy{axis, first, second})
                  : CorrectionStep(SliceFilling{axis, first, second});
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
