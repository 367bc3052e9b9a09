#include "StoredImages.h"

#include "MessageOf.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cstring>

namespace palpate::test
{
namespace
{
template <typename T>
void Put(std::string& bytes, std::size_t offset, T value)
{
  std::memcpy(&bytes[offset], &value, sizeof(T));
}

template <typename Numbers>
std::string AllBigEndian(const Numbers& numbers)
{
  std::string bytes;
  for (const auto number : numbers)
  {
    bytes += BigEndian(number);
  }
  return bytes;
}

// Adjacent numbers of one width.
struct Fields
{
  std::size_t First, Bytes, Count;
};

std::string Reversed(std::string bytes, const std::vector<Fields>& table, std::size_t voxels,
                     std::size_t voxelBytes)
{
  std::vector<Fields> all = table;
  all.push_back(
      {voxels, voxelBytes, bytes.size() < voxels ? 0 : (bytes.size() - voxels) / voxelBytes});
  for (const Fields& fields : all)
  {
    for (std::size_t i = 0; i < fields.Count; ++i)
    {
      const auto start =
          bytes.begin() + static_cast<std::ptrdiff_t>(fields.First + i * fields.Bytes);
      std::reverse(start, start + static_cast<std::ptrdiff_t>(fields.Bytes));
    }
  }
  return bytes;
}
} // namespace

std::string MghBytes(const MghSpec& spec, const std::string& voxels)
{
  std::string bytes = BigEndian(spec.Version) + AllBigEndian(spec.Sizes) + BigEndian(spec.Type) +
                      BigEndian(std::int32_t{0}) + BigEndian(spec.HasOrientation) +
                      AllBigEndian(spec.Spacing) + AllBigEndian(spec.Axes) +
                      AllBigEndian(spec.Center);
  bytes.resize(284, '\0');
  return bytes + voxels;
}

std::string GiplBytes(const GiplSpec& spec, const std::string& voxels)
{
  std::string bytes = AllBigEndian(spec.Sizes) + BigEndian(spec.Type) + AllBigEndian(spec.Spacing);
  bytes.resize(204, '\0');
  bytes += AllBigEndian(spec.Origin);
  bytes.resize(252, '\0');
  return bytes + BigEndian(spec.Mark) + voxels;
}

std::string Nifti2Bytes(const NiftiSpec& spec, const std::string& voxels)
{
  std::string bytes(544, '\0');
  Put(bytes, 0, std::int32_t{540});
  bytes.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
  Put(bytes, 12, spec.Type);
  Put(bytes, 14, spec.Bits);
  for (std::size_t i = 0; i < 8; ++i)
  {
    Put(bytes, 16 + 8 * i, std::int64_t{spec.Dimensions[i]});
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    Put(bytes, 104 + 8 * i, double{spec.PixelDimensions[i]});
  }
  Put(bytes, 168, std::int64_t{544});
  Put(bytes, 176, double{spec.Slope});
  Put(bytes, 184, double{spec.Intercept});
  Put(bytes, 344, std::int32_t{spec.QFormCode});
  Put(bytes, 348, std::int32_t{spec.SFormCode});
  for (std::size_t i = 0; i < 6; ++i)
  {
    Put(bytes, 352 + 8 * i, double{spec.QForm[i]});
  }
  for (std::size_t i = 0; i < 12; ++i)
  {
    Put(bytes, 400 + 8 * i, double{spec.SForm[i]});
  }
  Put(bytes, 500, std::int32_t{2}); // millimetres
  return bytes + voxels;
}

std::string NiftiPairHeader(const NiftiSpec& spec)
{
  std::string bytes = NiftiBytes(spec, "").substr(0, 348);
  bytes.replace(344, 3, "ni1");
  Put(bytes, 108, 0.0F);
  return bytes;
}

std::string AnalyzeHeader(const NiftiSpec& spec)
{
  std::string bytes = NiftiBytes(spec, "").substr(0, 348);
  Put(bytes, 32, std::int32_t{16384});
  bytes[38] = 'r';
  // Other fields of Analyze are where NIfTI has its orientation, slope and mark.
  std::fill(bytes.begin() + 108, bytes.end(), '\0');
  return bytes;
}

std::string ReversedNifti1(std::string bytes, std::size_t voxelBytes)
{
  return Reversed(std::move(bytes),
                  {{0, 4, 1}, {40, 2, 8}, {70, 2, 2}, {76, 4, 11}, {252, 2, 2}, {256, 4, 18}}, 352,
                  voxelBytes);
}

std::string ReversedNifti2(std::string bytes, std::size_t voxelBytes)
{
  return Reversed(std::move(bytes),
                  {{0, 4, 1}, {12, 2, 2}, {16, 8, 22}, {344, 4, 2}, {352, 8, 18}, {500, 4, 1}}, 544,
                  voxelBytes);
}

Volume ReadBytes(const std::string& name, const std::string& bytes, const VolumeChoice& choice)
{
  const TemporaryFolder folder;
  WriteAll(folder / name, bytes);
  return ReadVolume(folder / name, choice);
}

std::string RefusalOf(const std::string& name, const std::string& bytes)
{
  return MessageOf([&] { ReadBytes(name, bytes); });
}

void ExpectTruncationsAreRefused(const std::string& name, const std::string& bytes)
{
  for (std::size_t length = 1; length < bytes.size(); ++length)
  {
    EXPECT_NE(RefusalOf(name, bytes.substr(0, length)), "no error") << name << " " << length;
  }
}
} // namespace palpate::test
