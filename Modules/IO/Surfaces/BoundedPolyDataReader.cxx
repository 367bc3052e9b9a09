#include "BoundedPolyDataReader.h"

#include "BoundedXmlParser.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>

namespace palpate
{
namespace
{
// Bound on values per file byte: LZMA, the strongest of VTK's compressors, reaches some thousand
// to one.
constexpr double MostBytesFromByte = 8192.0;
constexpr double MostComponents = 1000.0;
constexpr std::array<const char*, 5> Counts{
    {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"}};

// Negative if the attribute is present but not a count.
double Count(vtkXMLDataElement* element, const char* attribute, double fallback)
{
  double count = 0.0;
  if (element->GetAttribute(attribute) == nullptr)
  {
    return fallback;
  }
  return element->GetScalarAttribute(attribute, count) != 0 && count >= 0.0 ? count : -1.0;
}

// The reader assumes that arrays hold numbers (or texts where allowed) and that names within a
// group are unique.
bool AreArraysSound(vtkXMLDataElement* group)
{
  static const std::set<std::string> Numbers{"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                             "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  std::set<std::string> names;
  for (int i = 0; i < group->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* array = group->GetNestedElement(i);
    const char* type = array->GetAttribute("type");
    const char* name = array->GetAttribute("Name");
    const bool isNumbers = std::strcmp(array->GetName(), "DataArray") == 0 && type != nullptr &&
                           Numbers.count(type) > 0;
    const bool isTexts = std::strcmp(array->GetName(), "Array") == 0 && type != nullptr &&
                         std::strcmp(type, "String") == 0 && name != nullptr;
    if ((!isNumbers && !isTexts) || !names.insert(name == nullptr ? "" : name).second)
    {
      return false;
    }
  }
  return true;
}

// Bytes of the arrays below an element, each with `tuples` tuples or its stated number; negative
// for invalid counts. A double, which no stated count overflows.
double ClaimedBytes(vtkXMLDataElement* element, double tuples)
{
  constexpr double LargestValue = 8.0;
  double sum = 0.0;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* nested = element->GetNestedElement(i);
    const double own = Count(nested, "NumberOfTuples", tuples);
    const double components = Count(nested, "NumberOfComponents", 1.0);
    const double length = Count(nested, "Length", 0.0); // of an information key
    const double below = ClaimedBytes(nested, tuples);
    if (own < 0.0 || components < 0.0 || components > MostComponents || length < 0.0 || below < 0.0)
    {
      return -1.0;
    }
    const std::string name = nested->GetName();
    const bool isArray = name == "DataArray" || name == "Array";
    sum += (isArray ? std::max(own, tuples) * components * LargestValue : 0.0) +
           length * LargestValue + below;
  }
  return sum;
}

bool AreGroupsSound(vtkXMLDataElement* piece)
{
  for (int i = 0; i < piece->GetNumberOfNestedElements(); ++i)
  {
    if (!AreArraysSound(piece->GetNestedElement(i)))
    {
      return false;
    }
  }
  return true;
}

double ClaimedBytesOfPiece(vtkXMLDataElement* piece)
{
  double most = 0.0;
  double sum = 0.0;
  for (const char* attribute : Counts)
  {
    const double count = Count(piece, attribute, 0.0);
    if (count < 0.0)
    {
      return -1.0;
    }
    most = std::max(most, count);
    sum += count;
  }
  // Cell arrays have as many tuples as there are cells, point arrays as there are points.
  const double bytes = ClaimedBytes(piece, sum);
  return bytes < 0.0 ? bytes : std::max(bytes, most);
}
} // namespace

vtkStandardNewMacro(BoundedPolyDataReader);

int BoundedPolyDataReader::Fail(const std::string& problem)
{
  this->Found = this->Found.empty() ? problem : this->Found;
  return 0;
}

void BoundedPolyDataReader::CreateXMLParser()
{
  this->Superclass::CreateXMLParser();
  this->XMLParser->Delete();
  this->XMLParser = BoundedXmlParser::New();
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(this->GetFileName(), failure);
  this->FileBytes = failure ? 0 : bytes;
}

int BoundedPolyDataReader::ReadPrimaryElement(vtkXMLDataElement* primary)
{
  if (static_cast<BoundedXmlParser*>(this->XMLParser)->IsTooDeep())
  {
    return this->Fail("its elements are nested too deeply");
  }
  double sum = 0.0;
  for (int i = 0; i < primary->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* nested = primary->GetNestedElement(i);
    const bool isPiece = std::strcmp(nested->GetName(), "Piece") == 0;
    if (!(isPiece ? AreGroupsSound(nested) : AreArraysSound(nested)))
    {
      return this->Fail(
          "one of its arrays is of a type that is not supported, or has a duplicate name");
    }
    const double bytes = isPiece ? ClaimedBytesOfPiece(nested) : ClaimedBytes(nested, 0.0);
    sum += bytes;
    if (bytes < 0.0 || !(sum <= MostBytesFromByte * static_cast<double>(this->FileBytes)))
    {
      return this->Fail("it states more values than it can hold");
    }
  }
  return this->Superclass::ReadPrimaryElement(primary);
}

int BoundedPolyDataReader::ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex,
                                           vtkAbstractArray* array, vtkIdType startIndex,
                                           vtkIdType count, FieldType type)
{
  auto* parser = static_cast<BoundedXmlParser*>(this->XMLParser);
  const bool hasRoom = array != nullptr && arrayIndex >= 0 && count >= 0 &&
                       array->GetNumberOfValues() - arrayIndex >= count;
  if (!hasRoom ||
      static_cast<double>(count) > MostBytesFromByte * static_cast<double>(this->FileBytes))
  {
    return this->Fail("one of its arrays does not have its stated length");
  }
  if (!parser->HasSoundBlocks(element, this->FileBytes))
  {
    return this->Fail("its compressed blocks are damaged");
  }
  if (this->Superclass::ReadArrayValues(element, arrayIndex, array, startIndex, count, type) == 0)
  {
    return 0;
  }
  return this->AreOffsetsSound(element, array, arrayIndex + count)
             ? 1
             : this->Fail("its cells have more corners than it can hold");
}

// The last offset becomes the length of the connectivity.
bool BoundedPolyDataReader::AreOffsetsSound(vtkXMLDataElement* element, vtkAbstractArray* array,
                                            vtkIdType end)
{
  const char* name = element->GetAttribute("Name");
  auto* offsets = vtkDataArray::SafeDownCast(array);
  if (name == nullptr || std::strcmp(name, "offsets") != 0 || offsets == nullptr)
  {
    return true;
  }
  double last = 0.0;
  for (vtkIdType i = 0; i < end && i < offsets->GetNumberOfTuples(); ++i)
  {
    const double offset = offsets->GetComponent(i, 0);
    if (!(offset >= last))
    {
      return false;
    }
    last = offset;
  }
  return last <= MostBytesFromByte * static_cast<double>(this->FileBytes);
}
} // namespace palpate
