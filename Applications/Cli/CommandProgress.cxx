#include "CommandProgress.h"

#include "Console.h"
#include "Interruption.h"

namespace palpate::cli
{
ProgressFunction ProgressOn(Console& console)
{
  return [&console](double fraction, const std::string& stage)
  {
    console.Progress(fraction, stage);
    return !Interruption::WasAsked();
  };
}
} // namespace palpate::cli
