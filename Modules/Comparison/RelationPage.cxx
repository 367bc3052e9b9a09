#include "RelationPage.h"

#include "ArrayColors.h"
#include "ComparisonNames.h"
#include "DecimalText.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "SixViews.h"
#include "SoftwareRenderer.h"
#include "StructureColor.h"
#include "TextTable.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::size_t MostPairsOfPage = 500;
constexpr std::size_t MostPairsOfText = 40;
constexpr std::size_t MostOrgansWithMaps = 6;

double FeatureOf(const RelatedOrgan& organ, const char* key)
{
  return ValueOf(organ.Features, key);
}

// Its voxels', or of a surface or a model what it encloses.
double MillilitersOf(const RelatedOrgan& organ)
{
  return std::isfinite(organ.Milliliters) ? organ.Milliliters
                                          : 1e-3 * FeatureOf(organ, "volume_mesh");
}

// mm^2, without where the image cuts it.
double AreaOf(const RelatedOrgan& organ)
{
  return FeatureOf(organ, "surface_area") - organ.CutArea;
}

SoftwareRenderer RendererOfAll(const OrganRelations& relations)
{
  TriangleMesh all;
  std::vector<SoftwareRenderer::Color> colors;
  for (std::size_t n = 0; n < relations.Organs.size(); ++n)
  {
    const RelatedOrgan& organ = relations.Organs[n];
    if (!organ.IsMeasured())
    {
      continue;
    }
    const bool isDefault = organ.Structure.Color == Segment().Color;
    const auto color = StructureColor(isDefault ? std::array<double, 3>{} : organ.Structure.Color,
                                      static_cast<int>(n) + 1);
    const IndexedMesh& mesh = organ.Body->Samples();
    const auto first = static_cast<int>(all.PointsWorld.size());
    all.PointsWorld.insert(all.PointsWorld.end(), mesh.Points.begin(), mesh.Points.end());
    for (const auto& [a, b, c] : mesh.Triangles)
    {
      all.Triangles.push_back({first + a, first + b, first + c});
    }
    const auto byte = [&](std::size_t k)
    { return static_cast<std::uint8_t>(std::lround(255.0 * color[k])); };
    colors.resize(all.PointsWorld.size(), {byte(0), byte(1), byte(2)});
  }
  SoftwareRenderer renderer(PolyDataOf(all));
  renderer.SetPointColors(std::move(colors));
  return renderer;
}

ReportTable OrganRows(const OrganRelations& relations)
{
  ReportTable table({"Organ", "Volume, ml", "Area, cm²", "Length, mm", "Width", "Depth",
                     "Thickness: median, mm", "5 %", "95 %", "Sphericity", "Convex", "Cut"});
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (organ.IsMeasured())
    {
      table.Text(organ.Name)
          .Number(MillilitersOf(organ), 2)
          .Number(0.01 * AreaOf(organ), 1)
          .Number(FeatureOf(organ, "major_axis_length"), 1)
          .Number(FeatureOf(organ, "minor_axis_length"), 1)
          .Number(FeatureOf(organ, "least_axis_length"), 1)
          .Number(organ.Thick.Median, 1)
          .Number(organ.Thick.Percentile5, 1)
          .Number(organ.Thick.Percentile95, 1)
          .Number(FeatureOf(organ, "sphericity"), 3)
          .Number(FeatureOf(organ, "volume_density_convex_hull"), 3)
          .Text(organ.IsCut ? "by the border" : "");
    }
  }
  return table;
}

// Those with a calibre.
std::vector<const RelatedOrgan*> TubesOf(const OrganRelations& relations)
{
  std::vector<const RelatedOrgan*> tubes;
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (!organ.Tube.Sections.empty())
    {
      tubes.push_back(&organ);
    }
  }
  return tubes;
}

ReportTable TubeRows(const std::vector<const RelatedOrgan*>& tubes)
{
  ReportTable table({"Tube", "Length, mm", "Diameter: least, mm", "median", "largest",
                     "Least at, mm", "Largest at, mm"});
  for (const RelatedOrgan* organ : tubes)
  {
    const Calibre& tube = organ->Tube;
    table.Text(organ->Name)
        .Number(tube.Length, 1)
        .Number(tube.At(0.0).Diameter(), 2)
        .Number(tube.At(0.5).Diameter(), 2)
        .Number(tube.At(1.0).Diameter(), 2)
        .Number(tube.At(0.0).Along, 1)
        .Number(tube.At(1.0).Along, 1);
  }
  return table;
}

ReportTable PairRows(const OrganRelations& relations, const std::vector<std::size_t>& near)
{
  ReportTable table({"First", "Second", "Lies", "Distance, mm", "Wall, mm", "Contact, mm²",
                     "Shared, mm³", "Second is", "Angle of axes, °"},
                    true);
  for (std::size_t n = 0; n < std::min(near.size(), MostPairsOfPage); ++n)
  {
    const OrganPair& pair = relations.Pairs[near[n]];
    const BodyRelation& found = pair.Relation;
    table.Text(relations.Organs[pair.One].Name)
        .Text(relations.Organs[pair.Other].Name)
        .Text(RelationWord(found.Is))
        .Number(found.Distance(), 2)
        .Number(found.Wall.Distance, 2)
        .Number(0.5 * (found.One.ContactArea + found.Other.ContactArea), 1)
        .Number(found.SharedVolume, 1)
        .Text(OffsetSideOf(found.Offset).Name)
        .Number(found.AxesAngle, 0);
  }
  return table;
}

void AddThicknessMap(ReportPage& page, const RelatedOrgan& organ)
{
  const double most = std::max(1e-3, organ.Thick.Percentile95);
  const vtkSmartPointer<vtkLookupTable> colors = MakeArrayColors(0.0, most);
  SoftwareRenderer renderer(MappedOrgan(organ));
  renderer.SetPointColors(SoftwareRenderer::ColorsOf(colors, organ.ThicknessMap));
  page.Section(organ.Name + ", by its thickness");
  AddSixViews(page, renderer);
  AddColorBar(page, colors, "", "mm", "thick");
}

std::vector<std::string> RelationRemarks(const OrganRelations& relations)
{
  std::vector<std::string> remarks = relations.Notes;
  for (const RelatedOrgan& organ : relations.Organs)
  {
    for (const std::string& note : organ.Notes)
    {
      remarks.push_back(organ.Name + " " + note);
    }
  }
  return remarks;
}

std::vector<std::string> RefusedOrgans(const OrganRelations& relations)
{
  std::vector<std::string> refused;
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (!organ.IsMeasured())
    {
      refused.push_back(organ.Name + ": " + organ.Message);
    }
  }
  return refused;
}

std::string RelationDefinitions(const OrganRelations& relations)
{
  const std::string surface =
      relations.Measures.Mesh == MaskMesh::Ibsi
          ? "A mask’s surface lies half way between the centres of its voxels and others, and its "
            "axes are those of its voxels’ centres, as the Image Biomarker Standardisation "
            "Initiative defines them. "
          : "A mask’s surface is an estimate of the shape that its voxels were drawn from, with "
            "their volume. ";
  return surface +
         "Distances are the least between the surfaces; 0 if one organ lies in the other, and then "
         "the wall is the distance of the surfaces. Contact is the area of one surface within " +
         ToleranceText(relations.Settings.Contact) +
         " mm of the other one, the mean of both. Length, width and depth are four standard "
         "deviations along the principal axes. Thickness is " +
         (relations.Measures.Thickness == ThicknessRule::Rays
              ? "the length of the inward normal up to the opposite side"
              : "the diameter of the largest ball that touches the surface at a point from "
                "inside") +
         "; percentiles are over the area. Where the border of an image cuts an organ " +
         (relations.Measures.KeepCuts ? "counts as its surface"
                                      : "is not its surface: it has no contact and no thickness") +
         ". Convex is the volume over that of the convex hull. A tube’s diameters are of circles "
         "with the area of its sections, perpendicular to its axis.";
}
} // namespace

vtkSmartPointer<vtkPolyData> MappedOrgan(const RelatedOrgan& organ)
{
  const IndexedMesh& surface = organ.Body->Samples();
  TriangleMesh mesh;
  mesh.PointsWorld = surface.Points;
  mesh.Triangles = surface.Triangles;
  mesh.Values = {{"Thickness", organ.ThicknessMap},
                 {"Distance", organ.DistanceMap},
                 {"Neighbour", organ.NeighbourMap}};
  return PolyDataOf(mesh);
}

std::string RelationPage(const OrganRelations& relations)
{
  const std::vector<std::size_t> near = relations.NearPairs();
  const auto measured = std::count_if(relations.Organs.begin(), relations.Organs.end(),
                                      [](const RelatedOrgan& one) { return one.IsMeasured(); });
  const std::string reach = ToleranceText(relations.Settings.Reach());
  ReportPage page;
  page.Header("relations of organs", CountText(measured, "organ", "organs"),
              CountText(static_cast<std::int64_t>(near.size()), "pair", "pairs") + " within " +
                  reach + " mm of each other, of " + std::to_string(relations.Pairs.size()))
      .Section("Notes")
      .Notes(RelationRemarks(relations))
      .Section("Not measured")
      .Notes(RefusedOrgans(relations))
      .Section("All organs");
  AddSixViews(page, RendererOfAll(relations));
  page.Section("Shapes").Table(OrganRows(relations));
  if (const auto tubes = TubesOf(relations); !tubes.empty())
  {
    page.Section("Calibre of tubes").Table(TubeRows(tubes));
  }
  if (!near.empty())
  {
    page.Section("Pairs within " + reach + " mm").Table(PairRows(relations, near));
  }
  if (near.size() > MostPairsOfPage)
  {
    page.SoftText("The nearest " + std::to_string(MostPairsOfPage) +
                  "; all pairs are in pairs.csv.");
  }
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (organ.IsMeasured() && static_cast<std::size_t>(measured) <= MostOrgansWithMaps)
    {
      AddThicknessMap(page, organ);
    }
  }
  page.Section("Definitions").Text(RelationDefinitions(relations));
  return page.Whole("Relations of organs", "Lengths are millimetres in the patient’s frame (L, P, "
                                           "S). For research; not a medical device.");
}

std::string RelationText(const OrganRelations& relations)
{
  TextTable organs;
  organs.AlignRight({1, 2, 3, 4, 5, 6});
  organs.AddRow({"organ", "ml", "cm2", "length mm", "width", "depth", "thickness"});
  for (const RelatedOrgan& organ : relations.Organs)
  {
    if (organ.IsMeasured())
    {
      organs.AddRow(
          {organ.Name, FixedText(MillilitersOf(organ), 2), FixedText(0.01 * AreaOf(organ), 1),
           FixedText(FeatureOf(organ, "major_axis_length"), 1),
           FixedText(FeatureOf(organ, "minor_axis_length"), 1),
           FixedText(FeatureOf(organ, "least_axis_length"), 1), FixedText(organ.Thick.Median, 1)});
    }
  }
  TextTable pairs;
  pairs.AlignRight({3, 4, 5});
  pairs.AddRow({"pair", "", "lies", "mm", "wall mm", "contact mm2", "second is"});
  const std::vector<std::size_t> near = relations.NearPairs();
  for (std::size_t n = 0; n < std::min(near.size(), MostPairsOfText); ++n)
  {
    const OrganPair& pair = relations.Pairs[near[n]];
    const BodyRelation& found = pair.Relation;
    pairs.AddRow({relations.Organs[pair.One].Name, relations.Organs[pair.Other].Name,
                  RelationWord(found.Is), FixedText(found.Distance(), 2),
                  FixedText(found.Wall.Distance, 2),
                  FixedText(0.5 * (found.One.ContactArea + found.Other.ContactArea), 1),
                  OffsetSideOf(found.Offset).Name});
  }
  TextTable calibres;
  calibres.AlignRight({1, 2, 3, 4});
  calibres.AddRow({"tube", "length mm", "least mm", "median mm", "largest mm"});
  const std::vector<const RelatedOrgan*> tubes = TubesOf(relations);
  for (const RelatedOrgan* organ : tubes)
  {
    const Calibre& tube = organ->Tube;
    calibres.AddRow({organ->Name, FixedText(tube.Length, 1), FixedText(tube.At(0.0).Diameter(), 2),
                     FixedText(tube.At(0.5).Diameter(), 2), FixedText(tube.At(1.0).Diameter(), 2)});
  }
  const std::string rest =
      near.size() > MostPairsOfText
          ? "and " + std::to_string(near.size() - MostPairsOfText) +
                " more pairs within the largest margin; --output and --json have all\n"
          : "";
  return organs.Text() + (tubes.empty() ? "" : "\n" + calibres.Text()) +
         (near.empty() ? "" : "\n" + pairs.Text() + rest);
}
} // namespace palpate
