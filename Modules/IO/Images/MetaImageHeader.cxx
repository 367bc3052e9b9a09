#include "MetaImageHeader.h"

#include "CNumericLocale.h"
#include "DecimalText.h"
#include "LengthUnit.h"
#include "MetaImageFields.h"
#include "PositiveNumber.h"
#include "Refusal.h"
#include "ZlibCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
// How the library reads one value.
struct ElementType
{
  double Bytes;
  double Lowest;
  double Highest;
};

template <typename T>
constexpr ElementType ElementTypeOf()
{
  return {sizeof(T), static_cast<double>(std::numeric_limits<T>::lowest()),
          static_cast<double>(std::numeric_limits<T>::max())};
}

// Returns the sizes of the three axes.
std::vector<double> CheckDimensions(const std::filesystem::path& file,
                                    const MetaImageFields& header)
{
  const std::vector<double> count = header.Numbers("NDims");
  std::vector<double> sizes = header.Numbers("DimSize");
  if (count.size() != 1 || count[0] < 1 || count[0] > 10 || sizes.size() != std::size_t(count[0]))
  {
    Refuse(file, "has a damaged header (NDims, DimSize)", "copy or export it again");
  }
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    if (!(sizes[axis] >= 1.0 && sizes[axis] <= 1e9) || sizes[axis] != std::floor(sizes[axis]))
    {
      Refuse(file,
             "has " + SignificantText(sizes[axis]) + " voxels along axis " +
                 std::to_string(axis + 1),
             "copy or export it again");
    }
    if (axis > 2 && sizes[axis] > 1.0)
    {
      Refuse(file, "has " + SignificantText(count[0]) + " dimensions",
             "extract one three-dimensional volume of it");
    }
  }
  if (sizes.size() < 3)
  {
    Refuse(file, "is two-dimensional", "use a volume of at least two slices");
  }
  sizes.resize(3);
  return sizes;
}

void CheckSpacings(const std::filesystem::path& file, const MetaImageFields& header)
{
  for (const char* key : {"ElementSpacing", "ElementSize"})
  {
    for (const double spacing : header.Numbers(key))
    {
      if (!IsPositive(spacing))
      {
        Refuse(file, "has a voxel spacing of " + SignificantText(spacing) + " mm",
               "correct its header: spacings must be positive");
      }
    }
  }
}

ElementType TypeOf(const std::filesystem::path& file, const MetaImageFields& header)
{
  static const std::map<std::string, ElementType> types{
      {"MET_CHAR", ElementTypeOf<std::int8_t>()},
      {"MET_UCHAR", ElementTypeOf<std::uint8_t>()},
      {"MET_SHORT", ElementTypeOf<std::int16_t>()},
      {"MET_USHORT", ElementTypeOf<std::uint16_t>()},
      {"MET_INT", ElementTypeOf<std::int32_t>()},
      {"MET_UINT", ElementTypeOf<std::uint32_t>()},
      {"MET_LONG", ElementTypeOf<std::int32_t>()},
      {"MET_ULONG", ElementTypeOf<std::uint32_t>()},
      {"MET_LONG_LONG", ElementTypeOf<std::int64_t>()},
      {"MET_ULONG_LONG", ElementTypeOf<std::uint64_t>()},
      {"MET_FLOAT", ElementTypeOf<float>()},
      {"MET_DOUBLE", ElementTypeOf<double>()}};
  const auto type = types.find(header.Text("ElementType"));
  if (type == types.end())
  {
    Refuse(file, "has no scalar ElementType in its header",
           "use one grey value or label per voxel");
  }
  return type->second;
}

// Location of the data, by the library's rules.
struct DataPlace
{
  std::filesystem::path File;
  bool IsLocal = false;
  double Length = 0.0;
};

DataPlace FindData(const std::filesystem::path& file, const MetaImageFields& header)
{
  const std::string name = header.Text("ElementDataFile");
  DataPlace place;
  place.IsLocal = name == "LOCAL" || name == "Local" || name == "local";
  if (name.empty() || name.rfind("LIST", 0) == 0 || name.find('%') != std::string::npos)
  {
    Refuse(file, "stores its slices in several files", "write it as one file");
  }
  const std::string own = file.string();
  const bool isPath = name[0] == '/' || name[0] == '~';
  place.File = place.IsLocal ? own
               : isPath      ? name
                             : own.substr(0, own.find_last_of("/\\") + 1) + name;
  std::error_code failure;
  place.Length = static_cast<double>(std::filesystem::file_size(place.File, failure));
  if (failure)
  {
    Refuse(file, "lacks its data file " + place.File.string(), "put it next to the header");
  }
  return place;
}

// Offset of the data in their file. The library skips HeaderSize bytes; if it is -1, the data are
// the file's last bytes.
double DataStart(const std::filesystem::path& file, const MetaImageFields& header,
                 const DataPlace& place, double dataBytes)
{
  const double own = place.IsLocal ? static_cast<double>(header.Bytes) : 0.0;
  const std::vector<double> stated = header.Numbers("HeaderSize");
  const double skipped = stated.empty() ? 0.0 : stated[0];
  const bool isPlain = !header.IsTrue("CompressedData", false) && header.IsTrue("BinaryData", true);
  if (skipped == 0.0)
  {
    return own;
  }
  if (skipped == -1.0 && isPlain)
  {
    return std::max(own, place.Length - dataBytes);
  }
  if (!isPlain || !(skipped >= std::max(own, 1.0) && skipped <= std::numeric_limits<int>::max()) ||
      skipped != std::floor(skipped))
  {
    Refuse(file, "has a damaged header (HeaderSize)", "copy or export it again");
  }
  return skipped;
}

// The library needs the length of data in the header's own file; otherwise it decodes from the
// file's first byte.
void CheckCompressedData(const DataPlace& place, const MetaImageFields& header, double start,
                         double dataBytes)
{
  const std::vector<double> stated = header.Numbers("CompressedDataSize");
  const bool isStated = !stated.empty() && stated[0] != 0.0;
  if (!isStated && place.IsLocal)
  {
    Refuse(place.File, "is compressed and has no CompressedDataSize in its header",
           "write it again, for example without compression");
  }
  const double available = place.Length - start;
  CheckInflatedSize(place.File, available, dataBytes);
  if (isStated && !(stated[0] >= 1.0 && stated[0] <= available))
  {
    Refuse(place.File,
           "is truncated: its header declares a CompressedDataSize of " +
               SignificantText(stated[0]) + " bytes but there are " + SignificantText(available),
           "copy or export it again");
  }
  const auto bytes = static_cast<double>(CheckedInflatedBytes(
      place.File, static_cast<std::uint64_t>(start), static_cast<std::uint64_t>(dataBytes),
      isStated ? static_cast<std::uint64_t>(stated[0]) : UINT64_MAX));
  if (bytes != dataBytes)
  {
    Refuse(place.File,
           std::string(bytes < dataBytes ? "is truncated" : "is damaged") +
               ": its header declares " + std::to_string(std::llround(dataBytes)) +
               " bytes of voxels but its compressed data hold " +
               std::to_string(std::llround(bytes)),
           "copy or export it again");
  }
}

// Reads the numbers as the library does, which does not report missing ones.
void CheckTextData(const std::filesystem::path& file, const MetaImageFields& header,
                   const DataPlace& place, double start, double voxels)
{
  const ElementType type = TypeOf(file, header);
  std::ifstream stream(place.File, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(start));
  double count = 0.0;
  for (double number = 0.0; count < voxels && stream >> number; ++count)
  {
    if (!(number >= type.Lowest && number <= type.Highest))
    {
      Refuse(file,
             "has a voxel of " + SignificantText(number) + ", which is not a " +
                 header.Text("ElementType"),
             "correct the ElementType in its header");
    }
    stream.get();
  }
  if (count < voxels)
  {
    Refuse(file,
           "is truncated: its header declares " + std::to_string(std::llround(voxels)) +
               " voxels but there are " + std::to_string(std::llround(count)),
           "copy or export it again");
  }
}

void CheckData(const std::filesystem::path& file, const MetaImageFields& header, double voxels)
{
  const DataPlace place = FindData(file, header);
  const double dataBytes = voxels * TypeOf(file, header).Bytes;
  const double start = DataStart(file, header, place, dataBytes);
  if (!header.IsTrue("BinaryData", true))
  {
    return CheckTextData(file, header, place, start, voxels);
  }
  if (header.IsTrue("CompressedData", false))
  {
    return CheckCompressedData(place, header, start, dataBytes);
  }
  const double available = std::max(0.0, place.Length - start);
  if (available < dataBytes)
  {
    Refuse(file,
           "is truncated: its header declares " + std::to_string(std::llround(dataBytes)) +
               " bytes of voxels but there are " + std::to_string(std::llround(available)),
           "copy or export it again");
  }
}

std::vector<std::string> OrientationNotes(const MetaImageFields& header)
{
  for (const char* key : {"TransformMatrix", "Rotation", "Orientation"})
  {
    if (header.Entries.count(key) > 0)
    {
      return {};
    }
  }
  return {"The file gives no TransformMatrix; its index axes were taken as L, P, S."};
}
// "?" stands for an unknown unit.
void TakeUnit(const std::string& unit, MetaImageFacts& facts)
{
  if (unit.empty() || unit == "?")
  {
    return;
  }
  const std::optional<double> millimeters = MillimetersPer(unit);
  facts.MillimetersPerUnit = millimeters.value_or(1.0);
  if (!millimeters)
  {
    facts.Notes.push_back("The file's unit, " + unit + ", is not known; mm were assumed.");
  }
  else if (*millimeters != 1.0)
  {
    facts.Notes.push_back("The file's unit, " + unit + ", was converted to mm.");
  }
}
} // namespace

MetaImageFacts CheckMetaImageHeader(const std::filesystem::path& file)
{
  CNumericLocale::RequireOfStreams(file);
  const MetaImageFields header = ReadMetaImageFields(file);
  MetaImageFacts facts;
  facts.Size = CheckDimensions(file, header);
  facts.VoxelBytes = TypeOf(file, header).Bytes;
  CheckSpacings(file, header);
  const std::vector<double> channels = header.Numbers("ElementNumberOfChannels");
  if (!channels.empty() && channels[0] != 1.0)
  {
    Refuse(file, "has " + SignificantText(channels[0]) + " values per voxel",
           "use one grey value or label per voxel");
  }
  CheckData(file, header, facts.Size[0] * facts.Size[1] * facts.Size[2]);
  facts.Notes = OrientationNotes(header);
  facts.IsOriented = facts.Notes.empty();
  TakeUnit(header.Text("DistanceUnits"), facts);
  return facts;
}
} // namespace palpate
