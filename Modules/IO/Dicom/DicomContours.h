#pragma once

#include "PalpateIOModule.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// A closed polygon in one plane: mm, patient LPS.
using ContourWorld = std::vector<Vector3>;

/// A structure of a DICOM structure set, with its contours in the file's order.
struct ContourStructure
{
  std::string Name;
  std::array<double, 3> Color{}; ///< red, green, blue in 0..1
  std::vector<ContourWorld> Contours;
};

struct DicomContours
{
  std::vector<ContourStructure> Structures; ///< in the file's order
  std::vector<std::string> SeriesUids;      ///< series on which the contours were drawn
  std::size_t TextBytes = 0;                ///< of the closed contours' coordinates in the file
  std::size_t OpenCount = 0; ///< contours that are points or open lines, which are left out
};

/// Reads the contours of a DICOM structure set. Throws InputError if there is no closed contour of
/// three points or a contour is damaged. Time and memory are bounded by the file.
/// Source: DICOM PS3.3, C.8.8.5 and C.8.8.6.
DicomContours ReadDicomContours(const std::filesystem::path& file);
} // namespace palpate
