#pragma once

#include "vtkSmartPointer.h"

namespace palpate
{
/// A shallow copy for a pipeline, which modifies its input's information; other threads may be
/// reading that of the shared data.
template <typename Data>
vtkSmartPointer<Data> OwnCopy(Data* shared)
{
  auto copy = vtkSmartPointer<Data>::New();
  copy->ShallowCopy(shared);
  return copy;
}
} // namespace palpate
