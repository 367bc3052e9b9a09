#include "DicomWriting.h"

#include "AtomicFile.h"
#include "DecimalText.h"
#include "QuietStandardStreams.h"
#include "Refusal.h"

#include <algorithm>
#include <stdexcept>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate
{
namespace
{
void Require(const OFCondition& condition)
{
  if (condition.bad())
  {
    throw std::runtime_error(condition.text());
  }
}

std::string Decimal(double number, int decimals)
{
  constexpr std::size_t Longest = 16;
  std::string text = FixedText(number, decimals);
  while (text.size() > Longest && decimals > 0)
  {
    text = FixedText(number, --decimals);
  }
  if (text.find('.') != std::string::npos)
  {
    text.resize(text.find_last_not_of('0') + 1);
    text.resize(text.size() - (text.back() == '.' ? 1 : 0));
  }
  return text;
}
} // namespace

std::string DicomDecimals(const std::vector<double>& numbers, int decimals)
{
  std::string text;
  for (const double number : numbers)
  {
    text += (text.empty() ? "" : "\\") + Decimal(number, decimals);
  }
  return text;
}

std::string DicomLongString(const std::string& name)
{
  constexpr int Longest = 64;
  std::string text;
  int characters = 0;
  for (const char c : name)
  {
    const auto byte = static_cast<unsigned char>(c);
    characters += (byte & 0xC0U) == 0x80U ? 0 : 1;
    if (characters > Longest)
    {
      break;
    }
    text += byte < ' ' || c == '\\' ? ' ' : c;
  }
  return text;
}

void PutDicomText(DcmItem& item, const DcmTagKey& tag, const std::string& text)
{
  Require(item.putAndInsertString(tag, text.c_str()));
}

void PutDicomNumber(DcmItem& item, const DcmTagKey& tag, unsigned short number)
{
  Require(item.putAndInsertUint16(tag, number));
}

DcmItem& NewDicomItem(DcmItem& parent, const DcmTagKey& sequence)
{
  DcmItem* item = nullptr;
  Require(parent.findOrCreateSequenceItem(sequence, item, -2));
  return *item;
}

DcmItem& PutDicomTerm(DcmItem& parent, const DcmTagKey& sequence, const CodedTerm& term)
{
  DcmItem& item = NewDicomItem(parent, sequence);
  constexpr std::size_t Longest = 16;
  PutDicomText(item, term.Value.size() > Longest ? DCM_LongCodeValue : DCM_CodeValue, term.Value);
  PutDicomText(item, DCM_CodingSchemeDesignator, term.Scheme);
  PutDicomText(item, DCM_CodeMeaning, DicomLongString(term.Meaning));
  return item;
}

DcmItem& PutDicomReference(DcmItem& parent, const DcmTagKey& sequence, const std::string& sopClass,
                           const std::string& instance)
{
  DcmItem& item = NewDicomItem(parent, sequence);
  PutDicomText(item, DCM_ReferencedSOPClassUID, sopClass);
  PutDicomText(item, DCM_ReferencedSOPInstanceUID, instance);
  return item;
}

std::string NewDicomUid()
{
  char uid[65];
  return dcmGenerateUniqueIdentifier(uid);
}

void SaveDicom(const std::filesystem::path& path, DcmFileFormat& object, bool isExplicit)
{
  AtomicFile file(path);
  const QuietStandardStreams quiet;
  const OFCondition status =
      object.saveFile(file.TemporaryPath().c_str(),
                      isExplicit ? EXS_LittleEndianExplicit : EXS_LittleEndianImplicit);
  if (status.bad())
  {
    Refuse(path, std::string("cannot be written (") + status.text() + ")",
           "free disk space or choose another output");
  }
  file.Commit();
}
} // namespace palpate
