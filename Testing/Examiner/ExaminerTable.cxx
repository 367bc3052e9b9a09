#include "ExaminerTable.h"

#include "ForcePerception.h"
#include "PalpatingHand.h"
#include "PalpationSearch.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace palpate::test
{
namespace
{
constexpr int ElementsAcross = 12;
constexpr int Degree = 12;

ElasticPhantom MakePhantom(const std::optional<HiddenNodule>& nodule)
{
  ElasticPhantom phantom;
  const Status status = ElasticPhantom::Make(nodule, ElementsAcross, Degree, phantom);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return phantom;
}

std::vector<HiddenNodule> AllNodules()
{
  std::vector<HiddenNodule> nodules;
  for (const double diameter : {4.0, 8.0, 12.0, 16.0})
  {
    for (const double depth : {2.0, 5.0, 8.0})
    {
      for (const double ratio : {1.4, 2.5, 5.0, 10.0})
      {
        nodules.push_back({diameter, depth, ratio});
      }
    }
  }
  return nodules;
}

bool IsAtNodule(const ElasticPhantom& phantom, const FreePlace& place)
{
  const Vector3 off = phantom.PointWorld(place) - phantom.PointWorld(ElasticPhantom::NodulePlace);
  return phantom.Nodule() && off.norm() <= 0.5 * phantom.Nodule()->Diameter + FoundMargin;
}
} // namespace

ExaminerRow SearchPhantom(const ElasticPhantom& phantom, const ElasticPhantom& plain, int searches,
                          std::uint64_t seed)
{
  const double force = phantom.Force(ElasticPhantom::NodulePlace, PalpatingHand::Depth);
  const double without = plain.Force(ElasticPhantom::NodulePlace, PalpatingHand::Depth);
  ExaminerRow row;
  row.Nodule = phantom.Nodule();
  row.Increase = force / without - 1.0;
  row.Contrast = ForcePerception::Contrast(force, without);
  row.Searches = searches;
  const PalpationSearch examiner;
  for (int i = 0; i < searches; ++i)
  {
    // Of the hand and of the raster, different in every search.
    const std::uint64_t own = 2 * (seed * 1'000'000 + static_cast<std::uint64_t>(i));
    PalpatingHand hand(phantom, own);
    const auto finding =
        examiner.Search([&hand](const FreePlace& place) { return hand.Press(place); }, own + 1);
    if (finding)
    {
      ++(IsAtNodule(phantom, finding->Place) ? row.Found : row.Elsewhere);
    }
  }
  return row;
}

std::vector<ExaminerRow> MeasureExaminer(int searches, const std::function<void(int, int)>& report)
{
  const std::vector<HiddenNodule> nodules = AllNodules();
  const int all = static_cast<int>(nodules.size()) + 1;
  const ElasticPhantom plain = MakePhantom(std::nullopt);
  std::vector<ExaminerRow> rows{SearchPhantom(plain, plain, searches)};
  report(1, all);
  for (const HiddenNodule& nodule : nodules)
  {
    rows.push_back(SearchPhantom(MakePhantom(nodule), plain, searches));
    report(static_cast<int>(rows.size()), all);
  }
  return rows;
}

std::string ToJson(const std::vector<ExaminerRow>& rows)
{
  const PalpationSearch::Technique way;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ExaminerRow& row : rows)
  {
    nlohmann::ordered_json entry;
    if (row.Nodule)
    {
      entry = {{"diameter_mm", row.Nodule->Diameter},
               {"depth_mm", row.Nodule->Depth},
               {"ratio", row.Nodule->Ratio}};
    }
    entry.update({{"increase", row.Increase},
                  {"contrast_jnd", row.Contrast},
                  {"searches", row.Searches},
                  {"found", row.Found},
                  {"elsewhere", row.Elsewhere}});
    list.push_back(entry);
  }
  return nlohmann::ordered_json{{"organ",
                                 {{"semi_axes_mm",
                                   {ElasticPhantom::SemiAxes.x(), ElasticPhantom::SemiAxes.y(),
                                    ElasticPhantom::SemiAxes.z()}},
                                  {"tissue_kpa", 1e3 * ElasticPhantom::Tissue},
                                  {"poisson", ElasticPhantom::Poisson},
                                  {"bed_kpa_per_mm", 1e3 * ElasticPhantom::Bed},
                                  {"free_angle_rad", ElasticPhantom::FreeAngle},
                                  {"elements_across", ElementsAcross},
                                  {"degree", Degree}}},
                                {"hand",
                                 {{"ball_mm", ElasticPhantom::Ball},
                                  {"depth_mm", PalpatingHand::Depth},
                                  {"depth_deviation_mm", PalpatingHand::DepthDeviation},
                                  {"place_deviation_mm", PalpatingHand::PlaceDeviation},
                                  {"percept_deviation_jnd", PalpatingHand::PerceptDeviation}}},
                                {"perception",
                                 {{"weber_fraction", ForcePerception::WeberFraction},
                                  {"smallest_weber_force_n", ForcePerception::SmallestWeberForce}}},
                                {"technique",
                                 {{"spacing_mm", way.Spacing},
                                  {"reach_mm", way.Reach},
                                  {"sweeps", way.Sweeps},
                                  {"suspects", way.Suspects},
                                  {"returns", way.Returns},
                                  {"threshold_jnd", way.Threshold},
                                  {"found_margin_mm", FoundMargin}}},
                                {"rows", list}}
      .dump(1);
}
} // namespace palpate::test
