#pragma once

#include "SyntheticImages.h"
#include "VolumeFile.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Files of the formats whose voxels StoredVoxels reads, written byte by byte; by default 4 x 5 x 6
/// voxels of one byte.
namespace palpate::test
{
/// A number's bytes, the most significant first.
template <typename T>
std::string BigEndian(T value)
{
  const std::string bytes = BytesOf(std::vector<T>{value});
  return {bytes.rbegin(), bytes.rend()};
}

template <typename T>
std::string BigEndian(const std::vector<T>& values)
{
  std::string bytes;
  for (const T value : values)
  {
    bytes += BigEndian(value);
  }
  return bytes;
}

/// A FreeSurfer volume's header (.mgh).
struct MghSpec
{
  std::array<std::int32_t, 4> Sizes{{4, 5, 6, 1}}; ///< the last one counts volumes
  std::int32_t Version = 1;
  std::int32_t Type = 0; ///< 0 unsigned char, 1 int, 3 float, 4 short
  std::int16_t HasOrientation = 1;
  std::array<float, 3> Spacing{{2, 2, 2}};
  std::array<float, 9> Axes{{-1, 0, 0, 0, 0, -1, 0, -1, 0}}; ///< x, y, z; each in RAS
  std::array<float, 3> Center{{0, 0, 0}};                    ///< RAS
};
std::string MghBytes(const MghSpec& spec, const std::string& voxels);

struct GiplSpec
{
  std::array<std::uint16_t, 4> Sizes{{4, 5, 6, 1}}; ///< the last one counts volumes
  std::uint16_t Type = 8; ///< 8 unsigned char, 15 short, 64 float, 65 double
  std::array<float, 3> Spacing{{2, 2, 2}};
  std::array<double, 3> Origin{{10, 20, 30}};
  std::uint32_t Mark = 0x2ae389b8;
};
std::string GiplBytes(const GiplSpec& spec, const std::string& voxels);

/// The same fields in a NIfTI-2 header.
std::string Nifti2Bytes(const NiftiSpec& spec, const std::string& voxels);
/// The header of a NIfTI-1 pair, whose voxels start with the other file.
std::string NiftiPairHeader(const NiftiSpec& spec);
/// The header of an Analyze 7.5 pair.
std::string AnalyzeHeader(const NiftiSpec& spec);
/// The fields of such headers and the voxels, of `voxelBytes` each, in the other byte order.
std::string ReversedNifti1(std::string bytes, std::size_t voxelBytes);
std::string ReversedNifti2(std::string bytes, std::size_t voxelBytes);

/// The volume of a file of this name and content.
Volume ReadBytes(const std::string& name, const std::string& bytes,
                 const VolumeChoice& choice = {});
/// The message for it; "no error" if it is read.
std::string RefusalOf(const std::string& name, const std::string& bytes);
/// Expects that the file is refused however it is truncated, from one byte on.
void ExpectTruncationsAreRefused(const std::string& name, const std::string& bytes);
} // namespace palpate::test
