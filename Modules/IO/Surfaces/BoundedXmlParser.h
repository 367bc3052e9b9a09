#pragma once

#include "vtkXMLDataParser.h"

#include <cstdint>

namespace palpate
{
/// VTK's parser of its XML files with bounds: elements are nested at most 32 deep, since they are
/// freed by recursion, and compressed blocks are checked before they are read.
class BoundedXmlParser : public vtkXMLDataParser
{
public:
  vtkTypeMacro(BoundedXmlParser, vtkXMLDataParser);
  static BoundedXmlParser* New();

  /// True after elements nested too deeply, which are skipped.
  bool IsTooDeep() const { return this->TooDeep; }
  /// True if the compressed blocks of an array, if any, lie within `fileBytes` and do not exceed
  /// the possible compression.
  bool HasSoundBlocks(vtkXMLDataElement* array, std::uint64_t fileBytes);

protected:
  void StartElement(const char* name, const char** attributes) override;
  void EndElement(const char* name) override;

private:
  void SeekData(vtkXMLDataElement* array);
  std::uint64_t StatedBlockCount();

  unsigned int Depth = 0;
  bool TooDeep = false;
};
} // namespace palpate
