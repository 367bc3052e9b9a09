#include "FilterRun.h"

#include "AlgorithmErrors.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

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
  bool IsCancelled = false;
};

void OnProgress(vtkObject* caller, unsigned long event, void* clientData, void* callData)
{
  auto* state = static_cast<RunState*>(clientData);
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
  RunState state{stage, from, to, progress};
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(&state);
  const AlgorithmErrors errors(filter);
  {
    const Observation progresses(filter, vtkCommand::ProgressEvent, command);
    filter->Update();
  }
  if (state.IsCancelled)
  {
    filter->Modified(); // otherwise VTK considers the unfinished output up to date
    throw Cancelled();
  }
  if (errors.Raised())
  {
    throw FilterError(errors.Message());
  }
}
} // namespace palpate
