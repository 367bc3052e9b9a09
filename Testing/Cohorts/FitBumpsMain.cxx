// PalpateFitBumps FOLDER OUT PLACE: displaces the surfaces of a cohort's masks (`palpate fit` wrote
// FOLDER) by bumps of 0 to 3 mm and fits them: OUT/PLACE-1/CASE.json and so on. Keeps the models
// that are there.
#include "BumpedFit.h"
#include "CohortGroup.h"
#include "CohortTable.h"
#include "ModelFile.h"
#include "SegmentationFile.h"

#include <algorithm>
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

void FitCase(const CohortRow& row, const SphericalHarmonicModel& mean, const BumpPlace& place,
             const std::filesystem::path& out)
{
  Segmentation segmentation;
  for (int height = 0; height <= 3; ++height)
  {
    const std::filesystem::path folder = out / (place.Name + "-" + std::to_string(height));
    const std::filesystem::path file = folder / (row.Case + ".json");
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
    const SurfaceBump bump(mean, place.Direction, height, BumpExtent);
    std::filesystem::create_directories(folder);
    WriteModel(
        file,
        {RadialFitOf(BumpedImage(layer, segment.Value, row.CenterWorld, bump), mean.Degree()), {}});
  }
}

int FitAll(const std::string& folder, const std::filesystem::path& out, const std::string& place)
{
  const CohortGroup group = MakeCohortGroup(CohortTable::Read(folder + "/cohort.csv"), folder, "",
                                            AlignmentAxes::Patient);
  const auto mean = std::get<SphericalHarmonicModel>(ShapeOf(group, -1, 0.0));
  int lost = 0;
  for (const CohortRow& row : group.Rows)
  {
    try
    {
      FitCase(row, mean, PlaceNamed(place), out);
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
