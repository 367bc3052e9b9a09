#pragma once

#include "vtkXMLPolyDataReader.h"

#include <cstdint>
#include <string>

namespace palpate
{
/// VTK's reader of .vtp files with bounds on what a file can make it do: the counts that it states
/// are compared with its size before memory is asked for them, and every array is looked at before
/// values are put into it. What the reader itself does not find wrong may still be no surface (see
/// TrianglesOf).
class BoundedPolyDataReader : public vtkXMLPolyDataReader
{
public:
  vtkTypeMacro(BoundedPolyDataReader, vtkXMLPolyDataReader);
  static BoundedPolyDataReader* New();

  /// What the file claims wrongly; empty for nothing. Reading ends there.
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
