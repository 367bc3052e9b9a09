#include "AlgorithmErrors.h"

#include "vtkCommand.h"
#include "vtkExecutive.h"

namespace palpate
{
namespace
{
// VTK formats its errors as "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT\n\n".
std::string TextOf(const char* raised)
{
  std::string text = raised == nullptr ? "" : raised;
  const std::size_t start = text.find("): ");
  text = start == std::string::npos ? text : text.substr(start + 3);
  const std::size_t last = text.find_last_not_of(" \n\r.");
  return last == std::string::npos ? "it gives no reason" : text.substr(0, last + 1);
}
} // namespace

AlgorithmErrors::AlgorithmErrors(vtkAlgorithm* algorithm) : Algorithm(algorithm)
{
  this->Observer->SetCallback(&AlgorithmErrors::Take);
  this->Observer->SetClientData(this);
  for (vtkObject* source :
       {static_cast<vtkObject*>(algorithm), static_cast<vtkObject*>(algorithm->GetExecutive())})
  {
    source->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    source->AddObserver(vtkCommand::WarningEvent, this->Observer);
  }
}

AlgorithmErrors::~AlgorithmErrors()
{
  this->Algorithm->RemoveObserver(this->Observer);
  this->Algorithm->GetExecutive()->RemoveObserver(this->Observer);
}

void AlgorithmErrors::Take(vtkObject* caller, unsigned long event, void* self, void* text)
{
  auto* errors = static_cast<AlgorithmErrors*>(self);
  if (event == vtkCommand::ErrorEvent && errors->First.empty())
  {
    errors->First = TextOf(static_cast<const char*>(text));
  }
}
} // namespace palpate
