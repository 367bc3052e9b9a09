#include "DicomElements.h"

#include <algorithm>
#include <set>

namespace palpate::test
{
namespace
{
constexpr std::size_t Preamble = 132;
constexpr std::uint32_t ItemEnd = 0xFFFEE00D;
constexpr std::uint32_t SequenceEnd = 0xFFFEE0DD;
constexpr std::uint32_t Undefined = 0xFFFFFFFF;

std::uint32_t Word(const std::string& bytes, std::size_t place, std::size_t size)
{
  std::uint32_t value = 0;
  for (std::size_t byte = size; byte-- > 0;)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[place + byte]);
  }
  return value;
}

void PutWord(std::string& bytes, std::size_t place, std::size_t size, std::uint32_t value)
{
  for (std::size_t byte = 0; byte < size; ++byte)
  {
    bytes[place + byte] = static_cast<char>(value >> 8 * byte & 255);
  }
}

std::uint32_t TagAt(const std::string& bytes, std::size_t place)
{
  return Word(bytes, place, 2) << 16 | Word(bytes, place + 2, 2);
}

bool HasLongLength(const std::string& vr)
{
  static const std::set<std::string> Long{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                          "SV", "UC", "UN", "UR", "UT", "UV"};
  return Long.count(vr) > 0;
}

class Walk
{
public:
  explicit Walk(const std::string& bytes) : Bytes(bytes) {}

  // Parses elements from `place` to `end` or to a delimiter; returns where it stopped.
  std::size_t Level(std::size_t place, std::size_t end, int parent, int depth)
  {
    constexpr int Deepest = 20; // level that is parsed; files may nest deeper
    while (place + 8 <= end && depth < Deepest)
    {
      DicomElement element;
      element.First = place;
      element.Parent = parent;
      element.Tag = TagAt(this->Bytes, place);
      if (element.Tag == ItemEnd || element.Tag == SequenceEnd || !this->ReadHead(element, end))
      {
        return place;
      }
      place = this->Add(element, end, depth);
    }
    return place;
  }

  std::vector<DicomElement> Elements;

private:
  bool ReadHead(DicomElement& element, std::size_t end) const
  {
    element.LengthPlace = element.First + 4;
    if (element.Tag >> 16 != 0xFFFE)
    {
      element.Vr = this->Bytes.substr(element.First + 4, 2);
      const bool isLong = HasLongLength(element.Vr);
      element.LengthPlace += isLong ? 4 : 2;
      element.LengthBytes = isLong ? 4 : 2;
    }
    element.Value = element.LengthPlace + element.LengthBytes;
    if (element.Value > end)
    {
      return false;
    }
    const std::uint32_t length = Word(this->Bytes, element.LengthPlace, element.LengthBytes);
    element.HasUndefinedLength = element.LengthBytes == 4 && length == Undefined;
    element.Count = element.HasUndefinedLength ? end - element.Value : length;
    return element.Count <= end - element.Value;
  }

  std::size_t Add(const DicomElement& element, std::size_t end, int depth)
  {
    const auto number = static_cast<int>(this->Elements.size());
    this->Elements.push_back(element);
    std::size_t last = element.Value + element.Count;
    const bool isFragment = element.Tag == DicomElement::Item && element.Parent >= 0 &&
                            this->At(element.Parent).Tag == DicomElement::PixelData;
    if (element.HasUndefinedLength || element.Vr == "SQ" ||
        (element.Tag == DicomElement::Item && !isFragment))
    {
      const std::size_t stopped = this->Level(element.Value, last, number, depth + 1);
      if (element.HasUndefinedLength)
      {
        this->At(number).Count = stopped - element.Value;
        last = std::min(stopped + 8, end);
      }
    }
    this->At(number).End = last;
    return last;
  }

  DicomElement& At(int number) { return this->Elements[static_cast<std::size_t>(number)]; }

  const std::string& Bytes;
};

void Grow(std::string& bytes, const std::vector<DicomElement>& elements, int element,
          std::size_t removed, std::size_t added)
{
  for (; element >= 0; element = elements[static_cast<std::size_t>(element)].Parent)
  {
    const DicomElement& outer = elements[static_cast<std::size_t>(element)];
    if (!outer.HasUndefinedLength)
    {
      PutWord(bytes, outer.LengthPlace, outer.LengthBytes,
              static_cast<std::uint32_t>(outer.Count - removed + added));
    }
  }
}
} // namespace

std::vector<DicomElement> DicomElementsOf(const std::string& bytes)
{
  Walk walk(bytes);
  walk.Level(Preamble, bytes.size(), -1, 0);
  return std::move(walk.Elements);
}

void ReplaceInValue(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t first, std::size_t count,
                    const std::string& by)
{
  // Length fields precede the values, so their offsets are still valid.
  Grow(bytes, elements, static_cast<int>(element), count, by.size());
  bytes.replace(elements[element].Value + first, count, by);
}

void ReplaceElement(std::string& bytes, const std::vector<DicomElement>& elements,
                    std::size_t element, std::size_t count, const std::string& by)
{
  Grow(bytes, elements, elements[element].Parent, count, by.size());
  bytes.replace(elements[element].First, count, by);
}
} // namespace palpate::test
