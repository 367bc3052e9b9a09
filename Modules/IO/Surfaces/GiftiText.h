#pragma once

#include <array>
#include <optional>
#include <string>

namespace palpate
{
/// A data array of a GIfTI file as it is written, before it is decoded.
struct GiftiArray
{
  std::string Type;                 ///< "NIFTI_TYPE_FLOAT32", ...
  std::string Encoding;             ///< "ASCII", "Base64Binary", "GZipBase64Binary", ...
  std::string Order;                ///< "RowMajorOrder" or "ColumnMajorOrder"
  std::string Endian;               ///< "LittleEndian" or "BigEndian"
  std::array<std::string, 2> Sizes; ///< rows and columns; empty for arrays of other shapes
  std::string Data;
  std::optional<std::string> ToScanner; ///< text of the 4 x 4 transform to the scanner's space
};

/// The two arrays that make a surface.
struct GiftiArrays
{
  std::optional<GiftiArray> Points;
  std::optional<GiftiArray> Triangles;
};

/// Finds them in a GIfTI file's text. Other arrays, names and texts are skipped. Throws InputError,
/// naming `fileName`, for a text that is not XML or not GIfTI, declares entities, or has two arrays
/// of points or of triangles.
GiftiArrays GiftiArraysOf(const std::string& text, const std::string& fileName);
} // namespace palpate
