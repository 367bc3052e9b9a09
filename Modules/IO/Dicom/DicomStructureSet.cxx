#include "DicomStructureSet.h"

#include "ContourFill.h"
#include "ContourGrid.h"
#include "DecimalText.h"
#include "DicomContours.h"
#include "DicomDataset.h"
#include "DicomSeries.h"
#include "InputError.h"
#include "Refusal.h"
#include "RepeatedSlices.h"
#include "SegmentCompletion.h"
#include "SegmentLayers.h"
#include "StructureGaps.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* StructureSetClass = "1.2.840.10008.5.1.4.1.1.481.3";

// The series that the contours were drawn on, if it is next to the file.
std::optional<DicomSeries> FindImages(const std::filesystem::path& file,
                                      const std::vector<std::string>& uids)
{
  std::vector<DicomSeries> all;
  try
  {
    all = FindDicomSeries(file.has_parent_path() ? file.parent_path() : ".");
  }
  catch (const InputError&)
  {
    return std::nullopt; // no images, or damaged ones
  }
  for (DicomSeries& series : all)
  {
    if (std::find(uids.begin(), uids.end(), series.Uid) != uids.end() && series.Files.size() > 1)
    {
      return std::move(series);
    }
  }
  return std::nullopt;
}

// Contours can enclose much with few points: memory follows from their text and the images.
double MostBytes(const DicomContours& contours, const std::optional<DicomSeries>& images)
{
  constexpr double OfAnyFile = 8.0 * 1024.0 * 1024.0;
  constexpr double OfTextByte = 1024.0;
  constexpr double OfImageByte = 8.0;
  double imageBytes = 0.0;
  for (std::size_t i = 0; images && i < images->Files.size(); ++i)
  {
    std::error_code failure;
    const auto bytes = std::filesystem::file_size(images->Files[i], failure);
    imageBytes += failure ? 0.0 : static_cast<double>(bytes);
  }
  return std::max(
      {OfAnyFile, OfTextByte * static_cast<double>(contours.TextBytes), OfImageByte * imageBytes});
}

int SlicesBeyond(const DicomContours& contours, const ImageGrid& grid)
{
  int most = 0;
  for (const ContourStructure& structure : contours.Structures)
  {
    std::vector<double> planes;
    for (const ContourWorld& contour : structure.Contours)
    {
      planes.push_back(IndexOf(grid, contour[0])[2]);
    }
    most = std::max(most, SlicesBeyondPlanes(planes));
  }
  return most;
}

ImageGrid GridOfImages(const std::filesystem::path& file, const DicomSeries& images,
                       std::vector<std::string>& notes)
{
  SliceStack stack = StackSlices(file, WithoutRepeatedSlices(images, notes).Planes, {});
  notes.insert(notes.end(), stack.Notes.begin(), stack.Notes.end());
  CheckGrid(file, stack.Grid, notes); // contours are placed along perpendicular axes
  return stack.Grid;
}

ImageGrid GridFor(const std::filesystem::path& file, const DicomContours& contours,
                  const std::optional<DicomSeries>& images, std::vector<std::string>& notes)
{
  constexpr double Layers = 4.0; // that fit if structures overlap
  ImageGrid grid =
      images ? GridOfImages(file, *images, notes)
             : GridOfContours(file, contours, MostBytes(contours, images) / Layers, notes);
  notes.push_back(images ? "Contours were filled on the voxels of the images next to the file."
                         : "The images that the contours were drawn on were not found next to the "
                           "file; contours were filled on slices through them, with pixels of " +
                               SignificantText(grid.Spacing[0], 3) + " mm.");
  grid = GridAroundContours(file, contours, grid, SlicesBeyond(contours, grid));
  CheckGrid(file, grid, notes);
  return grid;
}

// In a plane of the grid's slices, up to a tenth of their distance.
SliceContour OnGrid(const std::filesystem::path& file, const ImageGrid& grid,
                    const ContourWorld& contour)
{
  SliceContour result;
  result.Slice = IndexOf(grid, contour[0])[2];
  for (const Vector3& point : contour)
  {
    const Vector3 index = IndexOf(grid, point);
    if (!(std::abs(index[2] - result.Slice) <= 0.1))
    {
      Refuse(file, "has a contour that is not parallel to the slices",
             "export it again, or without that structure");
    }
    result.Points.emplace_back(index[0], index[1]);
  }
  return result;
}

void AddStructures(const std::filesystem::path& file, const DicomContours& contours,
                   const ImageGrid& grid, double mostBytes, Segmentation& segmentation)
{
  const int count = static_cast<int>(contours.Structures.size());
  SegmentLayers layers(file, grid, count, mostBytes);
  ContourFill fill(file, grid.Size,
                   10'000'000 + 10 * static_cast<std::int64_t>(contours.TextBytes));
  for (int i = 0; i < count; ++i)
  {
    const ContourStructure& structure = contours.Structures[static_cast<std::size_t>(i)];
    std::vector<SliceContour> onGrid;
    for (const ContourWorld& contour : structure.Contours)
    {
      onGrid.push_back(OnGrid(file, grid, contour));
    }
    Segment segment;
    segment.Label = segment.Value = i + 1;
    segment.Name = structure.Name;
    segment.Color = structure.Color;
    const std::vector<VoxelRun> runs = fill.Runs(onGrid);
    segment.Layer = layers.Add(segment.Label, runs);
    if (std::string note = GapNote(segment, grid, runs); !note.empty())
    {
      segmentation.Notes.push_back(std::move(note));
    }
    segmentation.Segments.push_back(segment);
  }
  segmentation.Layers = layers.Images();
}
} // namespace

bool IsDicomStructureSet(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::UpToPixels);
  return DicomText(dataset.Root(), DCM_SOPClassUID) == StructureSetClass;
}

Segmentation ReadDicomStructureSet(const std::filesystem::path& file)
{
  const DicomContours contours = ReadDicomContours(file);
  Segmentation segmentation;
  segmentation.Source = file;
  const std::optional<DicomSeries> images = FindImages(file, contours.SeriesUids);
  const ImageGrid grid = GridFor(file, contours, images, segmentation.Notes);
  AddStructures(file, contours, grid, MostBytes(contours, images), segmentation);
  if (contours.OpenCount > 0)
  {
    segmentation.Notes.push_back(std::to_string(contours.OpenCount) +
                                 " points or open lines were left out.");
  }
  CompleteSegments(segmentation);
  return segmentation;
}
} // namespace palpate
