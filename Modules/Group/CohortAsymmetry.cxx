#include "CohortAsymmetry.h"

#include "CohortEffectPage.h"
#include "CohortEffects.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "FalseDiscovery.h"
#include "InputError.h"
#include "MappedMean.h"
#include "Progress.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "ShapeAsymmetry.h"
#include "ShapeVector.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <array>
#include <cctype>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
constexpr double AlignmentShare = 0.5; // of the progress

ShapeSides PairedSides(const CohortGroup& group, const std::vector<SidePair>& pairs)
{
  ShapeSides sides;
  for (const SidePair& pair : pairs)
  {
    sides.Left.push_back(group.Models[pair.Left]);
    sides.Right.push_back(group.Models[pair.Right]);
  }
  return sides;
}

SideDifference DifferenceOf(const CohortGroup& group, const SidePair& rows, double shape,
                            const OrganModel& left)
{
  const double leftVolume = group.Bodies[rows.Left].Volume;
  const double rightVolume = group.Bodies[rows.Right].Volume;
  return {rows, 200.0 * (leftVolume - rightVolume) / (leftVolume + rightVolume), shape,
          100.0 * shape / RmsSizeOf(left)};
}

bool IsLeft(const std::string& side)
{
  const int letter = side.empty() ? 0 : std::tolower(static_cast<unsigned char>(side.front()));
  if (letter != 'l' && letter != 'r')
  {
    throw InputError("the side \"" + side + "\" begins neither with l nor with r");
  }
  return letter == 'l';
}

const Covariate& SideColumn(const CovariateTable& table, const std::string& name)
{
  const Covariate* column = table.Find(name);
  if (column == nullptr)
  {
    throw InputError("the covariates have no column " + name);
  }
  return *column;
}

struct AnovaRow
{
  const char* Name;
  SideAnova::Effect Effect;
  bool IsTested; // it has F and p
};
std::array<AnovaRow, 3> AnovaRows(const SideAnova& anova)
{
  return {{{"individual", anova.Individual, false},
           {"side (directional)", anova.Side, true},
           {"individual x side (fluctuating)", anova.Interaction, false}}};
}
} // namespace

std::vector<SidePair> FindSidePairs(const CohortGroup& group, const CovariateTable& table,
                                    const std::string& individual, const std::string& side,
                                    std::vector<std::string>& notes)
{
  const Covariate& individuals = SideColumn(table, individual);
  const Covariate& sides = SideColumn(table, side);
  std::map<std::string, std::array<std::optional<std::size_t>, 2>> found;
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    if (individuals.IsMissing(row) || sides.IsMissing(row))
    {
      continue;
    }
    std::optional<std::size_t>& place =
        found[individuals.Texts()[row]][IsLeft(sides.Texts()[row]) ? 0 : 1];
    if (place)
    {
      throw InputError(individuals.Texts()[row] + " has two cases of one side");
    }
    place = row;
  }
  std::vector<SidePair> pairs;
  for (const auto& [name, rows] : found)
  {
    if (rows[0] && rows[1])
    {
      pairs.push_back({*rows[0], *rows[1]});
    }
  }
  if (pairs.empty())
  {
    throw InputError("no " + individual + " has cases of both sides");
  }
  if (2 * pairs.size() < group.Rows.size())
  {
    notes.push_back(std::to_string(group.Rows.size() - 2 * pairs.size()) +
                    " cases have no other side and are left out of the asymmetry");
  }
  return pairs;
}

void MirrorRightSides(CohortGroup& group, const std::vector<SidePair>& pairs)
{
  for (const SidePair& pair : pairs)
  {
    group.Models[pair.Right] = MirroredTowards(group.Models[pair.Right], group.Models[pair.Left]);
  }
  if (const Status status = FindShapeModes(CoefficientsOf(group), group.Modes); !status.IsOk())
  {
    throw InputError(status.Message());
  }
}

CohortAsymmetry FindCohortAsymmetry(const CohortGroup& group, const std::vector<SidePair>& pairs,
                                    const PermutationSettings& flips,
                                    const KernelProgress& progress)
{
  CohortAsymmetry result;
  result.IsPaired = !pairs.empty();
  result.Flips = flips;
  ShapeSides sides;
  if (result.IsPaired)
  {
    sides = PairedSides(group, pairs);
  }
  else if (!MakeMirroredSides(group.Models, group.Axes == AlignmentAxes::Procrustes,
                              PartOf(progress, 0.0, AlignmentShare), sides)
                .IsOk())
  {
    throw Cancelled();
  }
  ShapeAsymmetry shapes;
  const Status status = FindShapeAsymmetry(sides, result.IsPaired, EffectFrequency, flips,
                                           PartOf(progress, AlignmentShare, 1.0), shapes);
  if (!status.IsOk() && sides.Left.size() < ShapeAsymmetry::FewestIndividuals)
  {
    throw InputError(status.Message());
  }
  if (!status.IsOk())
  {
    throw Cancelled();
  }
  result.Anova = shapes.Anova;
  result.Surface = std::move(shapes.Surface);
  result.Points = std::move(shapes.Points);
  for (std::size_t i = 0; i < sides.Left.size(); ++i)
  {
    result.Individuals.push_back(DifferenceOf(group, result.IsPaired ? pairs[i] : SidePair{i, i},
                                              shapes.Individuals[i], sides.Left[i]));
  }
  result.Discovery = FalseDiscoveryRates(result.Points.P);
  return result;
}

std::string CohortAsymmetry::Text() const
{
  return "asymmetry of " + std::to_string(this->Individuals.size()) +
         (this->IsPaired ? " pairs: directional "
                         : " shapes against their mirror images: directional ") +
         FixedText(RmsOverPoints(this->Surface, this->Points.Mean), 2) + " mm (F " +
         SignificantText(this->Anova.SideF(), 3) + ", p " +
         SignificantText(this->Points.WholeP, 3) + "), least p at a point " +
         SignificantText(this->Points.FamilyP.minCoeff(), 3) + "; fluctuating " +
         FixedText(RmsOverPoints(this->Surface, this->Points.Deviation), 2) + " mm\n";
}

void WriteCohortAsymmetry(const CohortGroup& group, const CohortAsymmetry& asymmetry,
                          const std::filesystem::path& folder)
{
  std::string table =
      CsvLine({"case", "other_side", "volume_percent", "shape_mm", "shape_percent"});
  for (const SideDifference& one : asymmetry.Individuals)
  {
    table += CsvLine({group.Rows[one.Rows.Left].Case,
                      asymmetry.IsPaired ? group.Rows[one.Rows.Right].Case : "mirror image",
                      asymmetry.IsPaired ? ExactText(one.VolumePercent) : std::string(),
                      ExactText(one.ShapeMillimeters), ExactText(one.ShapePercent)});
  }
  std::string anova = CsvLine({"effect", "squares_mm2", "degrees", "mean_square", "f", "p"});
  for (const auto& [name, effect, isTested] : AnovaRows(asymmetry.Anova))
  {
    anova += CsvLine({name, ExactText(effect.Squares), ExactText(effect.Degrees),
                      ExactText(effect.Mean()),
                      isTested ? ExactText(asymmetry.Anova.SideF()) : std::string(),
                      isTested ? ExactText(asymmetry.Points.WholeP) : std::string()});
  }
  WriteWholeFile(folder / "asymmetry.csv", table);
  WriteWholeFile(folder / "asymmetry_anova.csv", anova);
  const auto surface = MeanSurface(asymmetry.Surface);
  AddPointMap(surface, "left minus right (mm)", asymmetry.Points.Mean);
  AddPointMap(surface, "sd (mm)", asymmetry.Points.Deviation);
  AddPointMap(surface, "t", asymmetry.Points.Statistic);
  AddPointMap(surface, "p", asymmetry.Points.P);
  AddPointMap(surface, "p family", asymmetry.Points.FamilyP);
  AddPointMap(surface, "q", asymmetry.Discovery);
  WriteSurface(folder / "asymmetry.vtp", surface);
}

void AddCohortAsymmetry(ReportPage& page, const CohortAsymmetry& asymmetry)
{
  page.Section("Asymmetry")
      .Text(asymmetry.Text() +
            (asymmetry.IsPaired
                 ? "Right sides are mirrored; in the images red is where the left side is larger, "
                   "blue where the right one is; "
                 : "In the images red is where the shape stands out farther than on its other "
                   "side, blue less far; ") +
            "what is pale is not significant (maximum, 0.05).");
  ReportTable table({"Effect", "squares, mm\xC2\xB2", "df", "mean square"});
  for (const auto& [name, effect, isTested] : AnovaRows(asymmetry.Anova))
  {
    table.Text(name)
        .Value(SignificantText(effect.Squares, 4))
        .Value(SignificantText(effect.Degrees, 6))
        .Value(SignificantText(effect.Mean(), 3));
  }
  page.Table(table);
  AddMapFigures(page, "Directional asymmetry", asymmetry.Points.Mean,
                asymmetry.Points.Mean.cwiseAbs().maxCoeff(), asymmetry.Points.FamilyP,
                asymmetry.Surface);
}

std::string CohortAsymmetryMethods(const CohortAsymmetry& asymmetry)
{
  return std::string(
             "Left and right were compared in an analysis of variance by individual and "
             "side, summed over the coefficients (Klingenberg, Barluenga and Meyer 2002); ") +
         (asymmetry.IsPaired ? "right sides were mirrored at the sagittal plane"
                             : "the other side of a shape is its mirror image at the sagittal "
                               "plane through its centre") +
         ". The mean difference was tested by exchanging sides of random individuals, " +
         std::to_string(asymmetry.Flips.Count) + " times, seed " +
         std::to_string(asymmetry.Flips.Seed) +
         ": as a whole, and at each point corrected for all by the largest t. Without repeated "
         "measurements fluctuating asymmetry contains their error.";
}
} // namespace palpate
