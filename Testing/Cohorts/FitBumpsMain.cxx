// PalpateFitBumps FOLDER OUT PLACE: displaces the surfaces of a cohort's masks (`palpate fit` wrote
// FOLDER) by bumps of 1 to 3 mm, cuts them on other slices and fits them: OUT/PLACE-1/CASE.json and
// so on; the place "flat" has no bump: OUT/flat/CASE.json. Keeps the models that are there.
#include "BumpedFit.h"
#include "CohortGroup.h"
#include "CohortTable.h"
#include "ModelFile.h"
#include "SegmentationFile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace palpate::test
{
namespace
{
const BumpPlace& PlaceNamed(const std::string& name)
{
  const auto& places = BumpPlaces();
  const auto found = std::find_if(places.begin(), places.end(),
                                  [&](const BumpPlace& place) { return place.Name == name; });
  if (found == places.end())
  {
    throw std::runtime_error("no place is named " + name);
  }
  return *found;
}

/// What the models of a folder get.
struct FolderOfBump
{
  std::filesystem::path Path;
  SurfaceBump Bump;
};

std::vector<FolderOfBump> FoldersOf(const std::string& place, const RadialModel& mean,
                                    const std::filesystem::path& out)
{
  if (place == "flat")
  {
    return {{out / place, {mean, Vector3::UnitZ(), 0.0, BumpExtent}}};
  }
  std::vector<FolderOfBump> folders;
  for (const int height : {1, 2, 3})
  {
    folders.push_back(
        {out / (place + "-" + std::to_string(height)),
         {mean, PlaceNamed(place).Direction, static_cast<double>(height), BumpExtent}});
  }
  return folders;
}

// Of a case, the same with and without a bump: evenly spread by the golden ratio.
double ShiftOfSlices(int row)
{
  constexpr double Golden = 0.6180339887498949;
  return std::fmod((row + 0.5) * Golden, 1.0) - 0.5;
}

void FitCase(const CohortRow& row, double shift, const std::vector<FolderOfBump>& folders)
{
  Segmentation segmentation;
  for (const FolderOfBump& folder : folders)
  {
    const std::filesystem::path file = folder.Path / (row.Case + ".json");
    if (std::filesystem::exists(file))
    {
      continue;
    }
    if (segmentation.Layers.empty())
    {
      segmentation = ReadSegmentation(row.Result.Input);
    }
    const Segment& segment = segmentation.Find(std::to_string(row.Result.Structure.Label));
    const auto layer = segmentation.Layers[static_cast<std::size_t>(segment.Layer)];
    std::filesystem::create_directories(folder.Path);
    const auto image = BumpedImage(layer, segment.Value, row.CenterWorld, folder.Bump, shift);
    WriteModel(file, {RadialFitOf(image, row.Degree), {}});
  }
}

int FitAll(const std::string& folder, const std::filesystem::path& out, const std::string& place)
{
  const CohortGroup group = MakeCohortGroup(CohortTable::Read(folder + "/cohort.csv"), folder, "",
                                            AlignmentAxes::Patient);
  const auto mean = std::get<RadialModel>(ShapeOf(group, -1, 0.0));
  const std::vector<FolderOfBump> folders = FoldersOf(place, mean, out);
  int lost = 0;
  int index = 0;
  for (const CohortRow& row : group.Rows)
  {
    try
    {
      FitCase(row, ShiftOfSlices(index++), folders);
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s: %s\n", row.Case.c_str(), error.what());
      ++lost;
    }
  }
  return lost == 0 ? 0 : 1;
}
} // namespace
} // namespace palpate::test

int main(int count, char** arguments)
{
  if (count != 4)
  {
    std::fprintf(stderr, "usage: PalpateFitBumps FOLDER OUT PLACE\n");
    return 2;
  }
  try
  {
    return palpate::test::FitAll(arguments[1], arguments[2], arguments[3]);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
