#include "SofteningSettings.h"

#include "DecimalText.h"
#include "RadialSpectrum.h"
#include "Units.h"

#include <algorithm>

namespace palpate
{
namespace
{
bool IsModulus(double kilopascal)
{
  return kilopascal >= TissueMap::LeastModulus / MegapascalsPerKilopascal &&
         kilopascal <= TissueMap::MostModulus / MegapascalsPerKilopascal;
}
} // namespace

Status SofteningSettings::Check() const
{
  const auto isWithin = [](double value, double least, double most)
  { return value >= least && value <= most; };
  const auto range = [](double least, double most)
  { return " is not a number from " + SignificantText(least) + " to " + SignificantText(most); };
  const bool areModuli =
      IsModulus(this->TissueKilopascal) &&
      std::all_of(this->Inclusions.begin(), this->Inclusions.end(),
                  [](const Inclusion& one) { return IsModulus(one.Kilopascal); });
  if (!areModuli)
  {
    return Status::Failure("A modulus is not a number from 0.001 kPa to 1 GPa.");
  }
  if (!isWithin(this->PoissonRatio, 0.0, ElasticSolid::MostPoissonRatio))
  {
    return Status::Failure("Poisson's ratio" + range(0.0, ElasticSolid::MostPoissonRatio) + ".");
  }
  if (!isWithin(this->Exaggeration, 1.0, TissueMap::MostExaggeration))
  {
    return Status::Failure("The exaggeration" + range(1.0, TissueMap::MostExaggeration) + ".");
  }
  const bool areSupports =
      isWithin(this->BedPerMillimeter, LeastSupport, MostSupport) &&
      std::all_of(this->Neighbours.begin(), this->Neighbours.end(),
                  [&](const Neighbour& one)
                  { return isWithin(one.KilopascalPerMillimeter, LeastSupport, MostSupport); });
  if (!areSupports)
  {
    return Status::Failure("The stiffness of the support" + range(LeastSupport, MostSupport) +
                           " kPa per mm.");
  }
  if (!isWithin(this->FreeDegrees, LeastFreeDegrees, MostFreeDegrees))
  {
    return Status::Failure("The angle of the free side" + range(LeastFreeDegrees, MostFreeDegrees) +
                           " degrees.");
  }
  const int elements = this->Numbers.ElementsAcross;
  if (elements < FewestElements || elements > MostElements || elements % 2 != 0)
  {
    return Status::Failure("The number of elements across is not an even number from " +
                           std::to_string(FewestElements) + " to " + std::to_string(MostElements) +
                           ".");
  }
  return Status::Success();
}

Status SofteningSettings::CheckSupportOf(const RadialModel& organ) const
{
  const double most =
      MostRelativeSupport * this->TissueKilopascal / RadialSpectrum(organ).MeanRadius();
  return this->Elastography != nullptr || this->BedPerMillimeter <= most
             ? Status::Success()
             : Status::Failure("A support of " + SignificantText(this->BedPerMillimeter) +
                               " kPa per mm is too stiff for this organ of " +
                               SignificantText(this->TissueKilopascal) + " kPa: at most " +
                               SignificantText(most, 3) +
                               " kPa per mm, beyond which it is as good as rigid.");
}

std::string ExaggerationText(double exaggeration)
{
  return ", contrasts exaggerated to the power " + SignificantText(exaggeration);
}

std::vector<std::pair<std::string, std::string>> DescribeSettings(const SofteningSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> lines{
      {"tissue_kpa", SignificantText(settings.TissueKilopascal)},
      {"poisson_ratio", SignificantText(settings.PoissonRatio)},
      {"bed_kpa_per_mm", SignificantText(settings.BedPerMillimeter)},
      {"elements_across", std::to_string(settings.Numbers.ElementsAcross)},
      {"compliance_degree", std::to_string(settings.Numbers.Degree)}};
  if (settings.Exaggeration != 1.0)
  {
    lines.emplace_back("exaggeration", SignificantText(settings.Exaggeration));
  }
  std::string inclusions;
  for (const SofteningSettings::Inclusion& inclusion : settings.Inclusions)
  {
    inclusions += (inclusions.empty() ? "" : ", ") + inclusion.Read->Source.filename().string() +
                  " " + SignificantText(inclusion.Kilopascal) + " kPa";
  }
  std::string neighbours;
  for (const SofteningSettings::Neighbour& one : settings.Neighbours)
  {
    neighbours += (neighbours.empty() ? "" : ", ") + one.Read->Source.filename().string() + " " +
                  SignificantText(one.KilopascalPerMillimeter) + " kPa/mm";
  }
  for (const auto& [key, files] :
       {std::pair("inclusion", inclusions), std::pair("neighbour", neighbours)})
  {
    if (!files.empty())
    {
      lines.emplace_back(key, files);
    }
  }
  return lines;
}
} // namespace palpate
