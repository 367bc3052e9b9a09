#pragma once

#include "vtkXMLPolyDataReader.h"

#include <cstdint>
#include <string>

namespace palpate
{
/// VTK's reader of .vtp files with bounds on memory and time: stated counts are compared with the
/// file's size before memory is allocated, and every array is checked before it is filled. The
/// output may still not be a valid surface (see TrianglesOf).
class BoundedPolyDataReader : public vtkXMLPolyDataReader
{
public:
  vtkTypeMacro(BoundedPolyDataReader, vtkXMLPolyDataReader);
  static BoundedPolyDataReader* New();

  /// The first problem found, where reading ends; empty if there is none.
  const std::string& Problem() const { return this->Found; }

protected:
  void CreateXMLParser() override;
  int ReadPrimaryElement(vtkXMLDataElement* primary) override;
  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array,
                      vtkIdType startIndex, vtkIdType count, FieldType type) override;

private:
  int Fail(const std::string& problem);
  bool AreOffsetsSound(vtkXMLDataElement* element, vtkAbstractArray* array, vtkIdType end);

  std::string Found;
  std::uint64_t FileBytes = 0;
};
} // namespace palpate
