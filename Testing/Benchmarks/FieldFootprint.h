#pragma once

#include "BrickLayout.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Cost of a field of a head's bone, compared with the same volume as dense floats.
struct FieldFootprintRow
{
  int Nodes; ///< along each axis
  FieldInterpolation Interpolation;
  double BuildSeconds;      ///< from 16-bit samples, one thread
  double DenseBuildSeconds; ///< VTK: vtkImageCast, or vtkImageBSplineCoefficients for the cubic
  std::size_t Bytes;
  std::size_t DenseBytes;
  double StoredPart; ///< fraction of the bricks
};

/// Phantoms of 128^3 to 512^3 nodes, both interpolations. About a minute, and 2 GB. Throws
/// std::runtime_error if a field does not separate bone from air.
std::vector<FieldFootprintRow> FieldFootprints();

/// The rows as a table in Markdown.
std::string ToMarkdown(const std::vector<FieldFootprintRow>& rows);
} // namespace palpate::bench
