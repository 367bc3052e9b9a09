#include "InfoCommand.h"

#include "AvailableMemory.h"
#include "CaseTally.h"
#include "Console.h"
#include "FileType.h"
#include "ImageContent.h"
#include "ImageFormat.h"
#include "InfoReport.h"
#include "InputError.h"
#include "LabelStatistics.h"
#include "MaskFolders.h"

#include <CLI/CLI.hpp>
#include <ostream>

namespace palpate::cli
{
std::string InfoCommand::Examples() const
{
  return "  palpate info t2.nii.gz mask.seg.nrrd     geometry, values, labels\n"
         "  palpate info dicom-folder --series 2     the second series of a folder\n"
         "  palpate info *.nii.gz --json             one JSON object per line, for scripts";
}

void InfoCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("FILE", this->Inputs,
                 "Images and segmentations (" + ListOfEndings(ReadableImageEndings()) +
                     ", or a DICOM folder, or a folder of masks)")
      ->required()
      ->check(FileType::Input("image"));
  this->Images.Declare(app, "folder");
  app.add_flag("--json", this->Json, "Print one JSON object per line instead of text");
}

void InfoCommand::Describe(const std::string& input, Console& console) const
{
  InfoReport report;
  report.Input = input;
  report.Content = ReadImageContent(input, this->Images.Choice());
  if (report.Content.Labels)
  {
    report.Labels = MeasureLabels(*report.Content.Labels);
  }
  console.Output() << (this->Json ? report.Json() + '\n' : report.Text());
}

void InfoCommand::RecordLost(const std::string& input, const std::string& status,
                             const std::string& message, Console& console) const
{
  console.Error(message);
  if (this->Json)
  {
    console.Output() << InfoReport::FailureJson(input, status, message) << '\n';
  }
}

int InfoCommand::Run(Console& console)
{
  CaseTally tally;
  for (const std::string& input : WithMasksOfFolders(this->Inputs))
  {
    ++tally.Cases;
    try
    {
      this->Describe(input, console);
    }
    catch (const InputError& error)
    {
      ++tally.BadInputs;
      this->RecordLost(input, "bad-input", error.what(), console);
    }
    catch (const std::exception& error)
    {
      if (!SaysMemoryIsShort(error))
      {
        throw;
      }
      ++tally.Failures;
      this->RecordLost(input, "failed",
                       input + " needs more memory than there is; crop or resample it.", console);
    }
  }
  return tally.ExitCode();
}
} // namespace palpate::cli
