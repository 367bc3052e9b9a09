#include "ComparisonTable.h"

#include "CaseText.h"
#include "ComparisonNames.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "PatientSides.h"
#include "Units.h"
#include "WholeFile.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>

namespace palpate
{
namespace
{
std::string Cell(double number)
{
  return std::isfinite(number) ? SignificantText(number, 12) : std::string();
}

constexpr std::uintmax_t LargestComparisonTable = 64U << 20U;
constexpr const char* Compared = "compared";

std::string StatusWord(const PairComparison& pair)
{
  return pair.IsCompared() ? Compared : TextOf(pair.State).Word;
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
  head.insert(head.end(), {"time", "turn_deg", "shift_x_mm", "shift_y_mm", "shift_z_mm", "rest_mm",
                           "landmarks_mm", "unpaired", "key"});
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
  numbers.push_back(pair.Time.value_or(None));
  if (pair.Motion)
  {
    const Vector3& shift = pair.Motion->Shift;
    numbers.insert(numbers.end(), {pair.Motion->Turn * DegreesPerRadian, shift.x(), shift.y(),
                                   shift.z(), pair.Motion->Rest});
  }
  return numbers;
}

// Points in a cell: x, y and z with spaces, and semicolons between them.
std::string LandmarksCell(const PairComparison& pair)
{
  std::string cell;
  for (const Vector3& point : pair.Motion ? pair.Motion->Landmarks : std::vector<Vector3>())
  {
    cell += (cell.empty() ? "" : "; ") + Cell(point.x()) + " " + Cell(point.y()) + " " +
            Cell(point.z());
  }
  return cell;
}

std::vector<Vector3> LandmarksOf(const std::string& cell)
{
  std::vector<Vector3> points;
  std::istringstream numbers(cell);
  numbers.imbue(std::locale::classic());
  for (Vector3 point; numbers >> point[0] >> point[1] >> point[2];)
  {
    points.push_back(point);
    char separator = 0;
    numbers >> separator;
  }
  return points;
}

std::string Joined(const std::vector<std::string>& sentences)
{
  std::string text;
  for (const std::string& one : sentences)
  {
    text += (text.empty() ? "" : "; ") + one;
  }
  return text;
}

// What a row says of a pair.
class PairReader
{
public:
  explicit PairReader(const CsvRecord& record) : Record(record) {}

  PairComparison Pair(const std::vector<double>& tolerances) const
  {
    PairComparison pair;
    pair.Case = this->Text("case");
    pair.One.Structure.Label = ParseInteger(this->Text("label")).value_or(0);
    pair.One.Structure.Name = this->Text("name");
    pair.State = this->State();
    pair.Message = this->Text("message");
    pair.Key = this->Text("key");
    if (!this->Text("unpaired").empty())
    {
      pair.Unpaired = {this->Text("unpaired")};
    }
    if (pair.IsCompared())
    {
      this->TakeNumbers(tolerances, pair);
    }
    return pair;
  }

private:
  const std::string& Text(const std::string& column) const { return *this->Record.Find(column); }
  double Number(const std::string& column) const
  {
    return ParseNumber(this->Text(column)).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  FitResult::Outcome State() const
  {
    const std::string& word = this->Text("status");
    if (word == Compared)
    {
      return FitResult::Outcome::Fitted;
    }
    return word == TextOf(FitResult::Outcome::BadInput).Word ? FitResult::Outcome::BadInput
                                                             : FitResult::Outcome::Failed;
  }
  void TakeNumbers(const std::vector<double>& tolerances, PairComparison& pair) const
  {
    BodyComparison& found = pair.Numbers;
    if (const double dice = this->Number("dice"); std::isfinite(dice))
    {
      found.Overlap = BodyOverlap::OfDice(dice);
    }
    pair.One.Milliliters = this->Number("volume_ml");
    pair.Other.Milliliters = this->Number("reference_volume_ml");
    found.Both = {this->Number("mean_mm"), this->Number("rms_mm"), this->Number("p95_mm"),
                  this->Number("hausdorff_mm")};
    found.OneToOther.Unsigned.Percentile95 = this->Number("hausdorff95_mm");
    found.OneToOther.SignedMean = this->Number("signed_mean_mm");
    for (const double tolerance : tolerances)
    {
      found.Tolerances.push_back(
          {tolerance, this->Number("surface_dice_" + ToleranceText(tolerance) + "mm")});
    }
    SideBias bias;
    for (std::size_t side = 0; side < PatientSides().size(); ++side)
    {
      bias.Sides[side].Mean =
          this->Number(std::string("bias_") + PatientSides()[side].Name + "_mm");
    }
    found.Bias = bias;
    pair.Time = ParseNumber(this->Text("time"));
    if (!this->Text("turn_deg").empty())
    {
      pair.Motion = {this->Number("turn_deg") / DegreesPerRadian,
                     Vector3(this->Number("shift_x_mm"), this->Number("shift_y_mm"),
                             this->Number("shift_z_mm")),
                     this->Number("rest_mm"), LandmarksOf(this->Text("landmarks_mm"))};
    }
  }

  const CsvRecord& Record;
};
} // namespace

std::string ComparisonTable(const std::vector<PairComparison>& pairs,
                            const std::vector<double>& tolerances)
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
    row.resize(head.size() - 3);
    row.push_back(LandmarksCell(pair));
    row.push_back(Joined(pair.Unpaired));
    row.push_back(pair.Key);
    text += CsvLine(row);
  }
  return text;
}

std::vector<PairComparison> PairsInTable(std::string_view text,
                                         const std::vector<double>& tolerances)
{
  const std::vector<std::string> head = Head(tolerances);
  std::vector<PairComparison> pairs;
  ForEachCsvRecord(text,
                   [&](const CsvRecord& record)
                   {
                     if (record.Columns() == head)
                     {
                       pairs.push_back(PairReader(record).Pair(tolerances));
                     }
                   });
  return pairs;
}

void WriteComparisonTable(const std::vector<PairComparison>& pairs,
                          const std::vector<double>& tolerances, const std::filesystem::path& file)
{
  WriteWholeFile(file, ComparisonTable(pairs, tolerances));
}

std::vector<PairComparison> ReadComparisonTable(const std::filesystem::path& file,
                                                const std::vector<double>& tolerances)
{
  std::error_code ignored;
  return std::filesystem::exists(file, ignored)
             ? PairsInTable(ReadWholeFile(file, LargestComparisonTable), tolerances)
             : std::vector<PairComparison>();
}
} // namespace palpate
