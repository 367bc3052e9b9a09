#include "TouchStandIns.h"

#include "DecimalText.h"
#include "DecimatedSurface.h"
#include "FacetContactModel.h"
#include "FieldContactModel.h"
#include "FilterRun.h"
#include "InputError.h"
#include "OnDemandHarmonicModel.h"

#include <algorithm>

namespace palpate
{
namespace
{
// A cut degree of less is another shape altogether, and costs no less.
constexpr int LeastDegree = 2;
constexpr int LeastFacets = 200;

std::string InsteadOf(const std::string& less, const std::string& more)
{
  return less + " instead of " + more;
}

std::string DegreeInsteadOf(int less, int more)
{
  return InsteadOf("degree " + std::to_string(less), std::to_string(more));
}

void AddDegree(int degree, TouchContact& contact)
{
  const SphericalHarmonicModel& model = *contact.Looks.Model;
  TouchStandIn coarser;
  // A surface that is cut may reach its centre; then there is no stand-in.
  const auto cut = std::make_shared<const SphericalHarmonicModel>(model.WithDegree(degree));
  if (HarmonicContactModel::Make(cut, contact.Mode, coarser.Model, contact.Precision).IsOk())
  {
    coarser.Says = DegreeInsteadOf(degree, model.Degree());
    contact.Coarser.push_back(std::move(coarser));
  }
}

void AddFacets(int facets, TouchContact& contact, const ProgressFunction& progress)
{
  if (facets < LeastFacets)
  {
    return;
  }
  try
  {
    const auto surface = DecimatedSurface(contact.Looks.Surface, facets, progress);
    TouchContact fewer = MakeFacetContact(surface, {});
    contact.Coarser.push_back(
        {std::move(fewer.Model),
         {},
         InsteadOf(fewer.Represented, std::to_string(contact.Looks.Surface->GetNumberOfCells()))});
  }
  // Without it the structure is felt as it is.
  catch (const FilterError&)
  {
  }
  catch (const InputError&)
  {
  }
}

std::size_t PointsOf(const ToolShape& tool, const ScalarField& field)
{
  return tool.Points().empty() ? static_cast<std::size_t>(FieldContactModel::PointCountFor(
                                     tool.Radius(), field.Grid().Spacing().minCoeff()))
                               : tool.Points().size();
}
} // namespace

std::vector<int> StandInDegrees(int degree)
{
  std::vector<int> degrees;
  for (const int lower : {degree / 2, degree / 4})
  {
    if (lower >= LeastDegree && lower < degree)
    {
      degrees.push_back(lower);
    }
  }
  return degrees;
}

std::vector<TouchStandIn> StandInsOnDemand(const std::shared_ptr<OnDemandHarmonics>& harmonics)
{
  std::vector<TouchStandIn> coarser;
  for (std::size_t rung = 1; rung < harmonics->RungCount(); ++rung)
  {
    coarser.push_back({std::make_shared<const OnDemandHarmonicModel>(harmonics, rung),
                       {},
                       DegreeInsteadOf(harmonics->DegreeOf(rung), harmonics->DegreeOf(0))});
  }
  return coarser;
}

void AddStandIns(TouchContact& contact, const ProgressFunction& progress)
{
  if (contact.Harmonics != nullptr)
  {
    return; // it brought its own
  }
  if (contact.Looks.Model != nullptr)
  {
    for (const int degree : StandInDegrees(contact.Looks.Model->Degree()))
    {
      AddDegree(degree, contact);
    }
  }
  else if (contact.Looks.Surface != nullptr)
  {
    const auto facets = static_cast<int>(contact.Looks.Surface->GetNumberOfCells());
    AddFacets(facets / 4, contact, progress);
    AddFacets(facets / 16, contact, progress);
  }
}

std::vector<TouchStandIn> StandInsFor(const TouchContact& contact, const ToolShape& tool)
{
  std::vector<TouchStandIn> coarser = contact.Coarser;
  if (contact.Looks.Field == nullptr || !tool.IsSphere() || !(tool.Radius() > 0.0))
  {
    return coarser;
  }
  constexpr int FaceNeighbours = 6;
  const std::size_t points = PointsOf(tool, *contact.Looks.Field);
  for (const int fewer : {ToolShape::NeighbourCount, FaceNeighbours})
  {
    if (static_cast<std::size_t>(fewer) < points)
    {
      coarser.push_back(
          {contact.Model, ToolShape::SpherePoints(tool.Radius(), fewer),
           InsteadOf("a tool of " + std::to_string(fewer) + " points", std::to_string(points))});
    }
  }
  return coarser;
}

std::string LevelText(const TouchScene& scene, int level, int structure, double rate)
{
  const auto& all = scene.Structures;
  const auto touched = structure >= 0
                           ? all.begin() + std::min<std::ptrdiff_t>(
                                               structure, static_cast<std::ptrdiff_t>(all.size()))
                           : all.end();
  const auto hasStandIns = [](const TouchStructure& one) { return !one.Coarser.empty(); };
  const auto told = touched != all.end() && hasStandIns(*touched)
                        ? touched
                        : std::find_if(all.begin(), all.end(), hasStandIns);
  if (level <= 0 || told == all.end())
  {
    return {};
  }
  const auto rung = std::min(static_cast<std::size_t>(level), told->Coarser.size()) - 1;
  constexpr double Milli = 1e3;
  return told->Name + " is felt by " + told->Coarser[rung].Says + ": ticks took longer than " +
         SignificantText(Milli / rate, 3) + " ms.";
}
} // namespace palpate
