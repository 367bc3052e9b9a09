#include "CohortMethods.h"

#include "CohortAlignment.h"
#include "CohortAsymmetry.h"
#include "CohortCorrespondence.h"
#include "CohortEffectPage.h"
#include "CohortQuality.h"
#include "CohortReparametrisation.h"
#include "DecimalText.h"
#include "RepeatedEffectFiles.h"
#include "SoftwareVersions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace palpate
{
namespace
{
// Of DescribeSettings: those that shape a model.
constexpr std::array<const char*, 11> ToldSettings{{"model", "method", "smoothing", "center",
                                                    "degree", "tolerance", "max-degree", "weights",
                                                    "penalty", "robust", "repair"}};

// Neither a path nor a sentence.
bool IsPlain(const std::string& text)
{
  constexpr std::size_t Longest = 48;
  const std::string marks = " .,+-";
  return text.size() <= Longest &&
         std::all_of(text.begin(), text.end(),
                     [&](char c) {
                       return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                              marks.find(c) != std::string::npos;
                     });
}

std::string SettingsText(const CohortGroup& group)
{
  std::string text;
  for (const auto& [name, value] : group.FitSettings)
  {
    const bool isTold =
        std::find(ToldSettings.begin(), ToldSettings.end(), name) != ToldSettings.end();
    if (isTold && IsPlain(value))
    {
      text += (text.empty() ? "" : ", ") + name + " " + value;
    }
  }
  return text.empty() ? text : " Settings of all fits: " + text + ".";
}

std::string ProgramsText(const CohortGroup& group)
{
  std::string text;
  for (const std::string& program : group.FitPrograms)
  {
    if (IsPlain(program))
    {
      text += (text.empty() ? " by " : ", ") + program;
    }
  }
  return text;
}

// How another program places parameters is unknown.
std::string CorrespondenceText(bool isRadial, const CohortGroup& group)
{
  const bool isOwn =
      !group.FitPrograms.empty() &&
      std::all_of(group.FitPrograms.begin(), group.FitPrograms.end(),
                  [](const std::string& program) { return program.rfind("palpate ", 0) == 0; });
  return isRadial ? "Equal directions correspond."
                  : std::string("Equal parameters correspond") +
                        (isOwn ? ": the map to the sphere balances the distortion of areas, and is "
                                 "turned by the polar factor of its harmonics of degree 1, so that "
                                 "a direction of the sphere looks to the same direction of the "
                                 "patient."
                               : ".");
}

std::string ModelText(const CohortGroup& group)
{
  const OrganModel& first = group.Models.front();
  const bool isRadial = std::holds_alternative<RadialModel>(first);
  return std::to_string(group.Models.size()) + " shapes were described by " +
         (isRadial ? "the radius about the centre as a function of the direction"
                   : "three coordinates as functions on a parameter sphere") +
         ", in real orthonormal spherical harmonics up to degree " +
         std::to_string(DegreeOf(first)) + " (" + std::to_string(CoefficientCountOf(first)) +
         " coefficients, those of lower degree padded with zeros), fitted" + ProgramsText(group) +
         "." + SettingsText(group) + " " + CorrespondenceText(isRadial, group);
}

std::string AlignmentMethods(const CohortGroup& group, const CohortOutput& output)
{
  const bool isScaled = output.Alignment != nullptr && output.Alignment->IsScaled;
  return "Centres were superimposed; axes are " + CohortAxesText(group, output) + "." +
         (isScaled ? "" : " Sizes were not normalised.");
}

std::string ModesText(const CohortGroup& group, const CohortOutput& output)
{
  std::string text =
      "Modes are the principal components of the coefficients (singular values of the centred "
      "matrix, variances over n - 1), which are those of the " +
      std::string(std::holds_alternative<RadialModel>(group.Models.front())
                      ? "radius over the directions"
                      : "position over the parameters") +
      "; " + std::to_string(group.Modes.Modes.cols()) +
      " are above rounding. The largest entry of each is positive.";
  if (output.Quality != nullptr)
  {
    text += " Compactness, generalisation (each case left out) and specificity (" +
            std::to_string(output.Quality->Random.Count) + " random shapes, seed " +
            std::to_string(output.Quality->Random.Seed) +
            ") are those of Davies, Twining and Taylor (2008). Unusual cases: Mahalanobis distance "
            "from all others in their first " +
            std::to_string(output.Quality->ModeCount) +
            " modes (95 % of the variance, a fifth of the cases at most), Hotelling\xE2\x80\x99s "
            "p, with F over its mean for left-out cases where that is too small, false-discovery "
            "rate.";
  }
  return text;
}

std::string CorrespondenceMethods(const CohortCorrespondence& correspondence)
{
  return "Correspondence was checked by the RMS distance at equal parameters from the mean of all "
         "others, weighted as in their geometric median; outliers are beyond the third quartile by "
         "1.5 times the quartiles\xE2\x80\x99 distance, of logarithms" +
         (std::isfinite(correspondence.Fence) ? " (" + FixedText(correspondence.Fence, 2) + " mm)"
                                              : std::string(" (not for fewer than eight cases)")) +
         ". Flipped cases are " + FixedText(FlippedRatio, 0) +
         " times closer in another orientation (45 to 180 degrees away, harmonics up to degree 6, "
         "best size).";
}

std::string VersionsText(const std::string& program)
{
  std::string text = "Software: " + program;
  for (const auto& [name, version] : SoftwareVersions())
  {
    text += name == "Palpate" ? std::string() : ", " + name + " " + version;
  }
  return text + ".";
}
} // namespace

std::string CohortAxesText(const CohortGroup& group, const CohortOutput& output)
{
  if (group.Axes == AlignmentAxes::Ellipsoid)
  {
    return "each body\xE2\x80\x99s principal ones, the longest as left, the shortest as up";
  }
  return "the patients\xE2\x80\x99 own (LPS)" +
         (output.Alignment == nullptr ? std::string()
                                      : "; from there " + AlignmentText(*output.Alignment));
}

std::vector<std::string> CohortMethods(const CohortGroup& group, const CohortOutput& output,
                                       const std::string& program)
{
  std::vector<std::string> paragraphs{ModelText(group), AlignmentMethods(group, output)};
  if (output.Reparametrisation != nullptr)
  {
    paragraphs.push_back(ReparametrisationText(*output.Reparametrisation));
  }
  paragraphs.push_back(ModesText(group, output));
  if (output.Correspondence != nullptr && !output.Correspondence->Cases.empty())
  {
    paragraphs.push_back(CorrespondenceMethods(*output.Correspondence));
  }
  if (output.Effects != nullptr)
  {
    paragraphs.push_back(CohortEffectMethods(*output.Effects));
  }
  if (output.Repeated != nullptr)
  {
    paragraphs.push_back(RepeatedEffectMethods(*output.Repeated));
  }
  if (output.Asymmetry != nullptr)
  {
    paragraphs.push_back(CohortAsymmetryMethods(*output.Asymmetry));
  }
  paragraphs.push_back(VersionsText(program));
  return paragraphs;
}
} // namespace palpate
