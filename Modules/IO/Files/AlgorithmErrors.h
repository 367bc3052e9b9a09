#pragma once

#include "PalpateIOModule.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <string>

namespace palpate
{
/// Captures the errors and warnings of a VTK algorithm and its executive during its lifetime; they
/// are not printed.
class PALPATEIO_EXPORT AlgorithmErrors
{
public:
  explicit AlgorithmErrors(vtkAlgorithm* algorithm);
  AlgorithmErrors(const AlgorithmErrors&) = delete;
  AlgorithmErrors& operator=(const AlgorithmErrors&) = delete;
  ~AlgorithmErrors();

  bool Raised() const { return !this->First.empty(); }
  /// The first error, without VTK's file, line and address.
  const std::string& Message() const { return this->First; }

private:
  static void Take(vtkObject* caller, unsigned long event, void* self, void* text);

  vtkAlgorithm* Algorithm;
  vtkNew<vtkCallbackCommand> Observer;
  std::string First;
};
} // namespace palpate
