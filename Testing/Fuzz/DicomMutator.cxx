#include "DicomMutator.h"

#include "BinaryFields.h"
#include "DicomElements.h"
#include "TextMutator.h"

#include <algorithm>
#include <map>

namespace palpate::test
{
namespace
{
using Elements = std::vector<DicomElement>;

std::string Even(std::string value)
{
  value.resize((value.size() + 1) / 2 * 2, ' ');
  return value;
}

std::string OddUid(Random& random)
{
  static const std::string Uids[] = {
      "1.2.840.10008.1.2",           "1.2.840.10008.1.2.1",       "1.2.840.10008.1.2.2",
      "1.2.840.10008.1.2.1.99",      "1.2.840.10008.1.2.5",       "1.2.840.10008.1.2.4.50",
      "1.2.840.10008.1.2.4.51",      "1.2.840.10008.1.2.4.57",    "1.2.840.10008.1.2.4.70",
      "1.2.840.10008.1.2.4.80",      "1.2.840.10008.1.2.4.81",    "1.2.840.10008.1.2.4.90",
      "1.2.840.10008.1.2.4.91",      "1.2.840.10008.5.1.4.1.1.4", "1.2.840.10008.5.1.4.1.1.66.4",
      "1.2.840.10008.5.1.4.1.1.66.7"};
  return Choose(Uids, random);
}

std::string OddNumbers(const std::string& present, Random& random)
{
  std::string numbers = OddNumberText(random);
  if (present.find('\\') != std::string::npos && Below(random, 4) != 0)
  {
    // Replace one of several.
    const std::size_t place = Below(random, present.size());
    const std::size_t first = present.rfind('\\', place) + 1;
    const std::size_t end = std::min(present.find('\\', first), present.size());
    numbers = present.substr(0, first) + numbers + present.substr(end);
  }
  return numbers;
}

std::string OddWord(Random& random)
{
  static const std::string Words[] = {"",
                                      "BINARY",
                                      "FRACTIONAL",
                                      "LABELMAP",
                                      "SEG",
                                      "MR",
                                      "MONOCHROME1",
                                      "MONOCHROME2",
                                      "RGB",
                                      "ISO_IR 192",
                                      "ISO 2022 IR 87",
                                      "\\\\\\",
                                      "PALETTE COLOR",
                                      std::string(3000, 'a'),
                                      "\xFF\xFE"};
  return Choose(Words, random);
}

// Bytes of one value of a binary representation; 0 for text.
std::size_t WordSize(const std::string& vr)
{
  static const std::map<std::string, std::size_t> Sizes{
      {"US", 2}, {"SS", 2}, {"OW", 2}, {"UL", 4}, {"SL", 4}, {"FL", 4}, {"AT", 2},
      {"FD", 8}, {"OB", 1}, {"UN", 1}, {"OF", 4}, {"OD", 8}, {"UV", 8}, {"SV", 8}};
  const auto found = Sizes.find(vr);
  return found == Sizes.end() ? 0 : found->second;
}

class DicomChange
{
public:
  DicomChange(std::string& bytes, Random& random)
      : Bytes(bytes), Numbers(random), Found(DicomElementsOf(bytes)),
        Index(Below(random, Found.size()))
  {
  }

  void Make()
  {
    if (this->Found.empty())
    {
      MutateBytes(this->Bytes, this->Numbers);
      return;
    }
    static constexpr void (DicomChange::*Paths[])() = {
        &DicomChange::ChangeValue, &DicomChange::ChangeValue,  &DicomChange::ChangeValue,
        &DicomChange::ChangeValue, &DicomChange::ChangeLength, &DicomChange::ChangeTag,
        &DicomChange::ChangeVr,    &DicomChange::Remove,       &DicomChange::Repeat,
        &DicomChange::CopyOther,   &DicomChange::Nest};
    (this->*Choose(Paths, this->Numbers))();
  }

private:
  const DicomElement& Here() const { return this->Found[this->Index]; }
  std::string TextOf(const DicomElement& element) const
  {
    return this->Bytes.substr(element.First, element.End - element.First);
  }

  void ChangeValue()
  {
    const DicomElement& here = this->Here();
    const std::size_t size = WordSize(here.Vr);
    if (here.Vr == "SQ" || here.Vr.empty() || here.HasUndefinedLength)
    {
      this->Repeat();
      return;
    }
    if (size > 0 && here.Count >= size && Below(this->Numbers, 4) != 0)
    {
      const bool isReal = here.Vr[0] == 'F';
      ChangeField(this->Bytes,
                  {here.Value + size * Below(this->Numbers, here.Count / size), size,
                   isReal ? BinaryField::Type::Real : BinaryField::Type::Integer},
                  ByteOrder::Little, this->Numbers);
      return;
    }
    const std::string present = this->Bytes.substr(here.Value, here.Count);
    std::string odd = OddWord(this->Numbers);
    if (here.Vr == "UI" && Below(this->Numbers, 4) != 0)
    {
      odd = OddUid(this->Numbers);
    }
    else if ((here.Vr == "DS" || here.Vr == "IS") && Below(this->Numbers, 8) != 0)
    {
      odd = OddNumbers(present, this->Numbers);
    }
    else if (size > 0)
    {
      odd = present + present;
    }
    ReplaceInValue(this->Bytes, this->Found, this->Index, 0, here.Count, Even(odd));
  }
  void ChangeLength()
  {
    ChangeField(this->Bytes, {this->Here().LengthPlace, this->Here().LengthBytes},
                ByteOrder::Little, this->Numbers);
  }
  void ChangeTag()
  {
    const std::size_t first = this->Here().First;
    if (Below(this->Numbers, 2) == 0)
    {
      this->Bytes.replace(first, 4, this->Bytes, Choose(this->Found, this->Numbers).First, 4);
      return;
    }
    ChangeField(this->Bytes, {first + 2 * Below(this->Numbers, 2), 2}, ByteOrder::Little,
                this->Numbers);
  }
  void ChangeVr()
  {
    static const std::string Vrs[] = {"AE", "AT", "CS", "DS", "FD", "FL", "IS", "LO", "LT", "OB",
                                      "OW", "PN", "SL", "SQ", "SS", "UI", "UL", "UN", "US", "UT"};
    if (!this->Here().Vr.empty())
    {
      this->Bytes.replace(this->Here().First + 4, 2, Choose(Vrs, this->Numbers));
    }
  }
  void Remove()
  {
    const DicomElement& here = this->Here();
    ReplaceElement(this->Bytes, this->Found, this->Index, here.End - here.First, "");
  }
  void Repeat()
  {
    static constexpr std::size_t Counts[] = {1, 2, 10, 1000};
    constexpr std::size_t Longest = 100000;
    const std::string text = this->TextOf(this->Here());
    std::string repeated;
    for (std::size_t n = Choose(Counts, this->Numbers); n > 0 && repeated.size() < Longest; --n)
    {
      repeated += text;
    }
    ReplaceElement(this->Bytes, this->Found, this->Index, 0, repeated);
  }
  void CopyOther()
  {
    const DicomElement& here = this->Here();
    const std::string other = this->TextOf(Choose(this->Found, this->Numbers));
    ReplaceElement(this->Bytes, this->Found, this->Index, here.End - here.First, other);
  }
  // Wraps the element in nested sequences of undefined length.
  void Nest()
  {
    const DicomElement& here = this->Here();
    const std::string tag = this->Bytes.substr(Choose(this->Found, this->Numbers).First, 4);
    const std::string endless(4, '\xFF');
    const std::string open =
        tag + std::string("SQ\0\0", 4) + endless + std::string("\xFE\xFF\x00\xE0", 4) + endless;
    const std::string close("\xFE\xFF\x0D\xE0\0\0\0\0\xFE\xFF\xDD\xE0\0\0\0\0", 16);
    ReplaceElement(this->Bytes, this->Found, this->Index, here.End - here.First,
                   Nested(OddDepth(this->Numbers), open, this->TextOf(here),
                          Below(this->Numbers, 2) == 0 ? close : ""));
  }

  std::string& Bytes;
  Random& Numbers;
  Elements Found;
  std::size_t Index;
};

// Offsets of the markers of a JPEG, JPEG-LS or JPEG 2000 stream.
std::vector<std::size_t> MarksOf(const std::string& stream)
{
  std::vector<std::size_t> marks;
  for (std::size_t i = 0; i + 1 < stream.size(); ++i)
  {
    const auto code = static_cast<unsigned char>(stream[i + 1]);
    if (stream[i] == '\xFF' && (code >= 0xC0 || (code >= 0x4F && code <= 0x93)) && code != 0xFF)
    {
      marks.push_back(i);
    }
  }
  return marks;
}

void MutateSegments(std::string& stream, Random& random)
{
  const std::vector<std::size_t> marks = MarksOf(stream);
  const std::size_t which = Below(random, marks.size());
  const std::size_t first = marks[which];
  const std::size_t end = which + 1 < marks.size() ? marks[which + 1] : stream.size();
  switch (Below(random, 8))
  {
  case 0: // the length
    ChangeField(stream, {first + 2, 2}, ByteOrder::Big, random);
    break;
  case 1: // the marker
    stream[first + 1] = stream[Choose(marks, random) + 1];
    break;
  case 2:
    stream.erase(first, end - first);
    break;
  case 3:
    stream.insert(first, stream.substr(first, end - first));
    break;
  default: // a parameter of one, two or four bytes
    static constexpr std::size_t Sizes[] = {1, 2, 4};
    ChangeField(
        stream,
        {first + 4 + Below(random, std::min<std::size_t>(end - first, 48)), Choose(Sizes, random)},
        ByteOrder::Big, random);
  }
}

void MutateStream(std::string& stream, Random& random)
{
  const bool hasMarks = stream.size() > 2 && stream[0] == '\xFF' && !MarksOf(stream).empty();
  if (Below(random, 4) == 0)
  {
    MutateBytes(stream, random);
  }
  else if (hasMarks)
  {
    MutateSegments(stream, random);
  }
  else
  {
    // Run-length coding: number of segments and their offsets.
    static constexpr std::size_t Header = 16;
    ChangeField(stream, {4 * Below(random, Header)}, ByteOrder::Little, random);
  }
}
} // namespace

void MutateDicom(std::string& bytes, Random& random)
{
  for (std::size_t changes = 1 + Below(random, 3); changes > 0; --changes)
  {
    DicomChange(bytes, random).Make();
  }
}

void MutateFrames(std::string& bytes, Random& random)
{
  const Elements elements = DicomElementsOf(bytes);
  std::vector<std::size_t> fragments;
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    const int parent = elements[i].Parent;
    if (elements[i].Tag == DicomElement::Item && parent >= 0 &&
        elements[static_cast<std::size_t>(parent)].Tag == DicomElement::PixelData)
    {
      fragments.push_back(i);
    }
  }
  if (fragments.empty())
  {
    MutateDicom(bytes, random);
    return;
  }
  const std::size_t fragment = Choose(fragments, random);
  const DicomElement& element = elements[fragment];
  std::string stream = bytes.substr(element.Value, element.Count);
  for (std::size_t changes = 1 + Below(random, 2); changes > 0; --changes)
  {
    MutateStream(stream, random);
  }
  stream.resize((stream.size() + 1) / 2 * 2, 0);
  ReplaceInValue(bytes, elements, fragment, 0, element.Count, stream);
}
} // namespace palpate::test
