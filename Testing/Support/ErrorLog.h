#pragma once

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <string>

namespace palpate::test
{
/// Collects the error events of a filter and of its executive, which would otherwise go to the
/// error stream. Must live as long as the filter.
class ErrorLog
{
public:
  explicit ErrorLog(vtkAlgorithm* filter)
  {
    this->Command->SetClientData(&this->Text);
    this->Command->SetCallback(
        [](vtkObject*, unsigned long, void* text, void* message)
        { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    filter->AddObserver(vtkCommand::ErrorEvent, this->Command);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }

  bool IsEmpty() const { return this->Text.empty(); }
  bool Contains(const std::string& part) const
  {
    return this->Text.find(part) != std::string::npos;
  }

private:
  std::string Text;
  vtkNew<vtkCallbackCommand> Command;
};
} // namespace palpate::test
