#pragma once

#include "vtkXMLDataParser.h"

#include <cstdint>

namespace palpate
{
/// VTK's parser of its XML files with bounds on what a file can make it do: elements are nested at
/// most 32 deep, since they are freed by recursion, and compressed blocks are looked at before they
/// are read.
class BoundedXmlParser : public vtkXMLDataParser
{
public:
  vtkTypeMacro(BoundedXmlParser, vtkXMLDataParser);
  static BoundedXmlParser* New();

  /// True once elements were nested too deeply. They are left out.
  bool IsTooDeep() const { return this->TooDeep; }
  /// True if the compressed blocks of an array, if it has any, lie within `fileBytes` and hold no
  /// more than such data can.
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
