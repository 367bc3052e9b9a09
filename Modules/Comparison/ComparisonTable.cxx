#include "ComparisonTable.h"

#include "CaseText.h"
#include "ComparisonNames.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "PatientSides.h"
#include "WholeFile.h"

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
std::string Cell(double number)
{
  return std::isfinite(number) ? SignificantText(number, 8) : std::string();
}

std::string StatusWord(const PairComparison& pair)
{
  return pair.IsCompared() ? "compared" : TextOf(pair.State).Word;
}

std::vector<std::string> Head(const std::vector<double>& tolerances)
{
  std::vector<std::string> head{"case",
                                "label",
                                "name",
                                "status",
                                "message",
                                "dice",
                                "jaccard",
                                "volume_ml",
                                "reference_volume_ml",
                                "volume_difference_ml",
                                "volume_difference_percent",
                                "mean_mm",
                                "rms_mm",
                                "p95_mm",
                                "hausdorff95_mm",
                                "hausdorff_mm",
                                "signed_mean_mm"};
  for (const double tolerance : tolerances)
  {
    head.push_back("surface_dice_" + ToleranceText(tolerance) + "mm");
  }
  for (const PatientSide& side : PatientSides())
  {
    head.push_back(std::string("bias_") + side.Name + "_mm");
  }
  return head;
}

std::vector<double> NumbersOf(const PairComparison& pair)
{
  constexpr double None = std::numeric_limits<double>::quiet_NaN();
  const BodyComparison& found = pair.Numbers;
  std::vector<double> numbers{found.Overlap ? found.Overlap->Dice() : None,
                              found.Overlap ? found.Overlap->Jaccard() : None,
                              pair.One.Milliliters,
                              pair.Other.Milliliters,
                              pair.VolumeDifference(),
                              pair.VolumeDifferencePercent(),
                              found.Both.Mean,
                              found.Both.Rms,
                              found.Both.Percentile95,
                              found.Hausdorff95(),
                              found.Both.Largest,
                              found.OneToOther.SignedMean};
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    numbers.push_back(tolerance.SurfaceDice);
  }
  for (std::size_t side = 0; side < 6; ++side)
  {
    numbers.push_back(found.Bias ? found.Bias->Sides[side].Mean : None);
  }
  return numbers;
}
} // namespace

void WriteComparisonTable(const std::vector<PairComparison>& pairs,
                          const std::vector<double>& tolerances, const std::filesystem::path& file)
{
  const std::vector<std::string> head = Head(tolerances);
  std::string text = CsvLine(head);
  for (const PairComparison& pair : pairs)
  {
    const Segment& structure = pair.One.Structure;
    std::vector<std::string> row{
        pair.Case, structure.Label == 0 ? "" : std::to_string(structure.Label),
        structure.Label == 0 ? "" : structure.Name, StatusWord(pair), pair.Message};
    if (pair.IsCompared())
    {
      for (const double number : NumbersOf(pair))
      {
        row.push_back(Cell(number));
      }
    }
    row.resize(head.size());
    text += CsvLine(row);
  }
  WriteWholeFile(file, text);
}
} // namespace palpate
