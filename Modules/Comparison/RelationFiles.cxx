#include "RelationFiles.h"

#include "OutputFolder.h"
#include "OutputNames.h"
#include "RelationJson.h"
#include "RelationPage.h"
#include "RelationTable.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
// Of an organ's surface, without its ending; different for each.
std::vector<std::string> SurfaceNames(const std::vector<RelatedOrgan>& organs)
{
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const RelatedOrgan& organ : organs)
  {
    names.push_back(PlainName(organ.Name));
    for (int n = 2; !taken.insert(FoldedName(names.back())).second; ++n)
    {
      names.back() = PlainName(organ.Name) + "_" + std::to_string(n);
    }
  }
  return names;
}

void AddPairMaps(const RelatedOrgan& organ, const std::vector<std::string>& names,
                 vtkPolyData* surface)
{
  for (const RelatedOrgan::PairMap& map : organ.PairMaps)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(("DistanceTo_" + names[map.Other]).c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(map.Distances.size()));
    std::copy(map.Distances.begin(), map.Distances.end(), array->GetPointer(0));
    surface->GetPointData()->AddArray(array);
  }
}

void WriteSurfaces(const OrganRelations& relations, const std::filesystem::path& folder)
{
  const std::vector<std::string> names = SurfaceNames(relations.Organs);
  MakeOutputFolder(folder);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    const RelatedOrgan& organ = relations.Organs[n];
    if (organ.IsMeasured())
    {
      const vtkSmartPointer<vtkPolyData> surface = MappedOrgan(organ);
      AddPairMaps(organ, names, surface);
      WriteSurface(folder / (names[n] + ".vtp"), surface);
    }
  }
}
// The axis, with what is measured along it as arrays.
vtkSmartPointer<vtkPolyData> AxisOf(const Calibre& tube)
{
  const auto count = static_cast<vtkIdType>(tube.Sections.size());
  const auto axis = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(count));
  constexpr const char* Names[] = {"Along", "Area", "Diameter", "LeastDiameter", "LargestDiameter"};
  std::array<vtkNew<vtkDoubleArray>, 5> arrays;
  for (std::size_t n = 0; n < arrays.size(); ++n)
  {
    arrays[n]->SetName(Names[n]);
    axis->GetPointData()->AddArray(arrays[n]);
  }
  for (const CalibreSection& section : tube.Sections)
  {
    lines->InsertCellPoint(points->InsertNextPoint(section.Center.data()));
    const double values[] = {section.Along, section.Area, section.Diameter(), section.Least,
                             section.Largest};
    for (std::size_t n = 0; n < arrays.size(); ++n)
    {
      arrays[n]->InsertNextValue(values[n]);
    }
  }
  axis->SetPoints(points);
  axis->SetLines(lines);
  return axis;
}

void WriteCalibres(const OrganRelations& relations, const std::filesystem::path& folder)
{
  const std::vector<std::string> names = SurfaceNames(relations.Organs);
  MakeOutputFolder(folder);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    const Calibre& tube = relations.Organs[n].Tube;
    if (!tube.Sections.empty())
    {
      WriteWholeFile(folder / (names[n] + ".csv"), CalibreTable(tube));
      WriteLines(folder / (names[n] + ".vtp"), AxisOf(tube));
    }
  }
}
} // namespace

void WriteRelationFiles(const OrganRelations& relations, const std::filesystem::path& folder)
{
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteWholeFile(stage / "organs.csv", OrganTable(relations));
                   WriteWholeFile(stage / "pairs.csv", OrganPairTable(relations));
                   WriteWholeFile(stage / "relations.json", RelationJson(relations, {}) + "\n");
                   WriteWholeFile(stage / "report.html", RelationPage(relations));
                 });
  WriteSurfaces(relations, folder / "surfaces");
  if (relations.Measures.Calibre)
  {
    WriteCalibres(relations, folder / "calibre");
  }
}
} // namespace palpate
