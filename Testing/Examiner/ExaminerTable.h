#pragma once

#include "ElasticPhantom.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate::test
{
/// What searches of one phantom found.
struct ExaminerRow
{
  std::optional<HiddenNodule> Nodule;
  /// Of the force right above the nodule at the hand's depth, without noise: in parts of the force
  /// without it, and in just noticeable differences. 0 if there is none.
  double Increase = 0.0;
  double Contrast = 0.0;
  int Searches = 0;
  int Found = 0;     ///< a report within the nodule's radius and FoundMargin of it
  int Elsewhere = 0; ///< a report of another place, or of any place if there is no nodule
};

/// Between the reported place and the surface's point above the nodule, beyond its radius, mm.
constexpr double FoundMargin = 5.0;

/// Searches a phantom as often as is said. `plain` is the phantom without a nodule; the i-th search
/// has the same errors in every phantom.
ExaminerRow SearchPhantom(const ElasticPhantom& phantom, const ElasticPhantom& plain, int searches,
                          std::uint64_t seed = 1);

/// No nodule and nodules of 4 to 16 mm, 2 to 8 mm deep, 1.4 to 10 times as stiff as the tissue;
/// some minutes. `report` receives the number done and the total. Throws std::runtime_error if a
/// phantom cannot be made.
std::vector<ExaminerRow> MeasureExaminer(int searches, const std::function<void(int, int)>& report);

/// The rows, and all settings that they depend on.
std::string ToJson(const std::vector<ExaminerRow>& rows);
} // namespace palpate::test
