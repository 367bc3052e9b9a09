#pragma once

#include "Vector3.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::test
{
/// A DICOM structure set, written with DCMTK.
struct StructureSetSpec
{
  struct Contour
  {
    std::string Coordinates; ///< "x\\y\\z\\x...", mm, patient LPS
    std::string Kind = "CLOSED_PLANAR";
  };
  struct Structure
  {
    int Number = 1;
    std::string Name;
    std::vector<Contour> Contours;
    std::string Color; ///< "255\\0\\128"; omitted if empty
  };
  std::vector<Structure> Structures;
  std::string SeriesUid = "1.2.3"; ///< of the images, as in DicomSliceSpec
};
void WriteStructureSet(const std::filesystem::path& file, const StructureSetSpec& spec);

/// Points as a contour's coordinates.
std::string ContourText(const std::vector<Vector3>& points);
/// A rectangle in the plane z, from a corner to the opposite one.
std::string RectangleText(double left, double front, double right, double back, double z);
/// One structure, a box of these slices.
StructureSetSpec BoxOfContours(const std::vector<double>& heights);
} // namespace palpate::test
