#include "FilterRun.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <vector>

namespace palpate
{
namespace
{
struct RunState
{
  std::string Stage;
  double From;
  double To;
  const ProgressFunction& Progress;
  std::string Error;
  bool IsCancelled = false;
};

// VTK's message is "ERROR: In file, line n\nvtkClass (0x...): text\n\n".
std::string Message(const char* message)
{
  std::string text = message != nullptr ? message : "";
  const std::size_t start = text.find("): ");
  if (start != std::string::npos)
  {
    text.erase(0, start + 3);
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
  {
    text.pop_back();
  }
  return text;
}

void OnEvent(vtkObject* caller, unsigned long event, void* clientData, void* callData)
{
  auto* state = static_cast<RunState*>(clientData);
  if (event == vtkCommand::ErrorEvent)
  {
    // The first error is the cause; the executive reports its consequences after it.
    if (state->Error.empty())
    {
      state->Error = Message(static_cast<const char*>(callData));
    }
    return;
  }
  auto* filter = vtkAlgorithm::SafeDownCast(caller);
  if (filter != nullptr && state->Progress &&
      !state->Progress(state->From + (state->To - state->From) * filter->GetProgress(),
                       state->Stage))
  {
    state->IsCancelled = true;
    filter->SetAbortExecute(1);
  }
}

// Observes an object during its own lifetime.
class Observation
{
public:
  Observation(vtkObject* object, unsigned long event, vtkCommand* command)
      : Object(object), Tag(object->AddObserver(event, command))
  {
  }
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;
  ~Observation() { this->Object->RemoveObserver(this->Tag); }

private:
  vtkObject* Object;
  unsigned long Tag;
};
} // namespace

void RunFilter(vtkAlgorithm* filter, const std::string& stage, double from, double to,
               const ProgressFunction& progress)
{
  RunState state{stage, from, to, progress, {}};
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnEvent);
  command->SetClientData(&state);
  {
    const Observation errors(filter, vtkCommand::ErrorEvent, command);
    const Observation executiveErrors(filter->GetExecutive(), vtkCommand::ErrorEvent, command);
    const Observation progresses(filter, vtkCommand::ProgressEvent, command);
    filter->Update();
  }
  if (state.IsCancelled)
  {
    filter->Modified(); // otherwise VTK considers the unfinished output up to date
    throw Cancelled();
  }
  if (!state.Error.empty())
  {
    throw FilterError(state.Error);
  }
}
} // namespace palpate
