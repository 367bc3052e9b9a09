#include "CommandRegistry.h"

#include "CheckCommand.h"
#include "CohortCommand.h"
#include "CompareCommand.h"
#include "CompleteCommand.h"
#include "CompletionCommand.h"
#include "ConvertCommand.h"
#include "CorrectCommand.h"
#include "DevicesCommand.h"
#include "EvaluateCommand.h"
#include "FitCommand.h"
#include "InfoCommand.h"
#ifdef PALPATE_HAS_NETWORK
#include "LinkCommand.h"
#endif
#include "ManualCommand.h"
#include "MeasureCommand.h"
#include "MeshCommand.h"
#include "PhantomCommand.h"
#include "RegisterCommand.h"
#include "RelateCommand.h"
#include "RenderCommand.h"
#include "SceneCommand.h"
#include "SoftenCommand.h"
#include "StudyCommand.h"
#include "TaskCommand.h"
#include "TouchCommand.h"
#include "TradeoffCommand.h"

namespace palpate::cli
{
std::vector<std::unique_ptr<Command>> MakeCommands()
{
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(std::make_unique<InfoCommand>());
  commands.push_back(std::make_unique<FitCommand>());
  commands.push_back(std::make_unique<CohortCommand>());
  commands.push_back(std::make_unique<CompareCommand>());
  commands.push_back(std::make_unique<RelateCommand>());
  commands.push_back(std::make_unique<MeasureCommand>());
  commands.push_back(std::make_unique<RegisterCommand>());
  commands.push_back(std::make_unique<CompleteCommand>());
  commands.push_back(std::make_unique<CorrectCommand>());
  commands.push_back(std::make_unique<CheckCommand>());
  commands.push_back(std::make_unique<MeshCommand>());
  commands.push_back(std::make_unique<EvaluateCommand>());
  commands.push_back(std::make_unique<ConvertCommand>());
  commands.push_back(std::make_unique<PhantomCommand>());
  commands.push_back(std::make_unique<RenderCommand>());
  commands.push_back(std::make_unique<SoftenCommand>());
  commands.push_back(std::make_unique<TouchCommand>());
  commands.push_back(std::make_unique<SceneCommand>());
  commands.push_back(std::make_unique<TradeoffCommand>());
  commands.push_back(std::make_unique<StudyCommand>());
  commands.push_back(std::make_unique<TaskCommand>());
  commands.push_back(std::make_unique<DevicesCommand>());
#ifdef PALPATE_HAS_NETWORK
  commands.push_back(std::make_unique<LinkCommand>());
#endif
  commands.push_back(std::make_unique<CompletionCommand>());
  commands.push_back(std::make_unique<ManualCommand>());
  return commands;
}
} // namespace palpate::cli
